// The firmware: the controller on both cores of the Zynq-7020. start.S calls the functions with C names.

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

#include "controller/app/controller.hpp"
#include "controller/board/board_bus.hpp"
#include "controller/board/mpcore.hpp"
#include "controller/host_memory/memory.hpp"

extern "C" {
extern armature::host_memory::HostMemory host_memory;  // memory.ld
extern std::array<std::uint32_t, 4096> page_table;
extern const std::uint32_t code_begin[], code_end[];
extern void (*init_array_begin[])();
extern void (*init_array_end[])();
void start_core1();
}

namespace {

using armature::Controller;
using armature::Interrupts;
using armature::board::BoardBus;
using armature::board::mpcore::kCore1Start;

alignas(Controller) std::array<std::byte, sizeof(Controller)> storage;
Controller* controller = nullptr;

constexpr std::uint32_t kMegabyte = 0x0010'0000;
constexpr std::uint32_t kMemoryEnd = 0x4000'0000;  // DDR; the logic begins
// Sections of 1 MB (DDI 0406C, B3.5.1), readable and writable.
constexpr std::uint32_t kMemorySection = 0x0001'1C0E;  // shared, write-back, write-allocate
constexpr std::uint32_t kDeviceSection = 0x0000'0C16;  // shared device, not executed

}  // namespace

// Before the MMU is on.
extern "C" void write_page_table() {
  for (std::uint32_t i = 0; i < page_table.size(); ++i) {
    const std::uint32_t address = i * kMegabyte;
    page_table[i] = address | (address < kMemoryEnd ? kMemorySection : kDeviceSection);
  }
}

// Constructs the controller, with all that the host has written into the memory, and starts core 1.
extern "C" void prepare_core0() {
  for (auto* function = init_array_begin; function != init_array_end; ++function) (*function)();
  controller = new (storage.data()) Controller{host_memory, {code_begin, code_end}};
  BoardBus::start_mpcore();
  *reinterpret_cast<volatile std::uint32_t*>(kCore1Start) = reinterpret_cast<std::uint32_t>(&start_core1);
  asm volatile("dsb\n\tsev" ::: "memory");
}

extern "C" void core0_main() {
  BoardBus bus{0, Interrupts::kTimer};
  controller->core0_main(bus);
}

extern "C" void core1_main() {
  BoardBus bus{1, Interrupts::kUart | Interrupts::kGpio};
  controller->core1_main(bus);
}
