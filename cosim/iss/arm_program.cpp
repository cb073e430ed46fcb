#include "cosim/iss/arm_program.hpp"

#include <sys/mman.h>

#include <cstring>
#include <new>
#include <stdexcept>

#include "controller/board/mpcore.hpp"
#include "controller/host_memory/boot_memory.hpp"

namespace armature::cosim::iss {
namespace {

// Of the Zynq-7020 (UG585, table 4-1): the part of the DDR that the firmware has (controller/board/memory.ld), and the
// on-chip memory, in which core 0 leaves the start address of core 1.
constexpr std::uint32_t kDdr = 0x0010'0000;
constexpr std::size_t kDdrBytes = 63u << 20;
constexpr std::uint32_t kOnChip = 0xFFFC'0000;
constexpr std::size_t kOnChipBytes = 256u << 10;
using board::mpcore::kCore1Start;

}  // namespace

void ArmProgram::Unmap::operator()(void* pages) const {
  ::munmap(pages, bytes);
}

ArmProgram::Pages ArmProgram::pages(std::size_t bytes) {
  void* const found = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (found == MAP_FAILED) throw std::bad_alloc{};
  return Pages{found, Unmap{bytes}};
}

ArmProgram::ArmProgram(std::span<const std::uint8_t> firmware, host_memory::HostMemory& memory,
                       std::optional<double> cpi, CoreWatcher* watcher)
    : image_{firmware},
      ddr_{pages(kDdrBytes)},
      on_chip_{pages(kOnChipBytes)},
      pieces_{{{kDdr, ddr_.get(), kDdrBytes},
               {kOnChip, on_chip_.get(), kOnChipBytes},
               {image_.symbol("host_memory"), &memory, host_memory::BootMemory::whole_pages(memory.bytes)}}},
      code_end_{image_.symbol("init_array_begin")},
      watched_{watcher != nullptr},
      cores_{
          {{0, image_.symbol("armature_charge"), cpi, watcher}, {1, image_.symbol("armature_charge"), cpi, watcher}}} {
  for (const ElfImage::Segment& segment : image_.segments()) {
    if (segment.address < kDdr || segment.address - kDdr + segment.bytes.size() > kDdrBytes) {
      throw std::runtime_error{"the ARM program does not fit into its memory"};
    }
    std::memcpy(static_cast<std::uint8_t*>(ddr_.get()) + (segment.address - kDdr), segment.bytes.data(),
                segment.bytes.size());
  }
  for (ArmCore& core : cores_) {
    for (const MemoryPiece& piece : pieces_) core.map(piece);
  }
  starts_[0] = image_.symbol("core0_is_prepared");
  cores_[0].prepare(image_.symbol("start_core0"), starts_[0]);
  std::memcpy(&starts_[1], static_cast<std::uint8_t*>(on_chip_.get()) + (kCore1Start - kOnChip), sizeof starts_[1]);
  for (std::size_t i = 0; i < cores_.size(); ++i) cores_.at(i).set_start(starts_.at(i));
}

std::span<std::uint8_t> ArmProgram::memory(std::uint32_t address) const {
  for (const MemoryPiece& piece : pieces_) {
    const std::uint32_t offset = address - piece.address;
    if (address < piece.address || offset >= piece.bytes) continue;
    return std::span{static_cast<std::uint8_t*>(piece.data), piece.bytes}.subspan(offset);
  }
  return {};
}

void ArmProgram::main(int core, CoreBus& bus) {
  const auto i = static_cast<std::size_t>(core);
  cores_.at(i).run(starts_.at(i), bus);
}

}  // namespace armature::cosim::iss
