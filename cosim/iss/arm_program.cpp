#include "cosim/iss/arm_program.hpp"

#include <sys/mman.h>

#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/board/mpcore.hpp"
#include "controller/host_memory/boot_memory.hpp"
#include "cosim/iss/state_digest.hpp"

namespace armature::cosim::iss {
namespace {

// Of the Zynq-7020 (UG585, table 4-1): the part of the DDR that the firmware has (controller/board/memory.ld), and the
// on-chip memory, in which core 0 leaves the start address of core 1.
constexpr std::uint32_t kDdr = 0x0010'0000;
constexpr std::size_t kDdrBytes = 63u << 20;
constexpr std::uint32_t kOnChip = 0xFFFC'0000;
constexpr std::size_t kOnChipBytes = 256u << 10;
using board::mpcore::kCore1Start;

// The sections of controller/board/memory.ld, and the memory of the host.
std::vector<CoreMemory::Part> parts_of(const ElfImage& image, std::uint32_t host_bytes) {
  constexpr std::uint32_t kPageTableBytes = 0x4000;
  const auto between = [&](std::string name, std::uint32_t begin, std::uint32_t end) {
    return CoreMemory::Part{.name = std::move(name), .begin = begin, .bytes = (end - begin) / 4 * 4};
  };
  const auto at = [&](std::string_view symbol) { return image.symbol(symbol); };
  const std::uint32_t stacks = at("page_table") + kPageTableBytes;
  return {between("code", kDdr, at("init_array_begin")),
          between("data", at("init_array_begin"), at("bss_begin")),
          between("variables", at("bss_begin"), at("page_table")),
          between("page table", at("page_table"), stacks),
          between("stack of core 0", stacks, at("core0_stack_top")),
          between("stack of core 1", at("core0_stack_top"), at("core1_stack_top")),
          between("host memory", at("host_memory"), at("host_memory") + host_bytes)};
}

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
      memory_{.parts = parts_of(image_, memory.bytes), .symbols = image_.symbols()},
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

std::span<std::uint8_t> ArmProgram::bytes_from(std::uint32_t address) const {
  for (const MemoryPiece& piece : pieces_) {
    const std::uint32_t offset = address - piece.address;
    if (address < piece.address || offset >= piece.bytes) continue;
    return std::span{static_cast<std::uint8_t*>(piece.data), piece.bytes}.subspan(offset);
  }
  return {};
}

void ArmProgram::flip_memory(std::uint32_t addr, std::uint32_t mask) {
  const std::span<std::uint8_t> bytes = bytes_from(addr);
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data(), sizeof word);
  word ^= mask;
  std::memcpy(bytes.data(), &word, sizeof word);
  for (ArmCore& core : cores_) core.memory_has_flipped(addr);
}

std::optional<std::uint64_t> ArmProgram::digest() const {
  StateDigest digest;
  for (const ArmCore& core : cores_) {
    if (!core.waits()) return std::nullopt;
    core.add_to(digest);
  }
  for (const CoreMemory::Part& part : memory_.parts) digest.add(bytes_from(part.begin).first(part.bytes));
  return digest.value();
}

void ArmProgram::main(int core, CoreBus& bus) {
  const auto i = static_cast<std::size_t>(core);
  cores_.at(i).run(starts_.at(i), bus);
}

}  // namespace armature::cosim::iss
