// The controller as the firmware of the Zynq-7020 (controller/board), on two cores that execute its instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "controller/host_memory/memory.hpp"
#include "cosim/cpu/core_program.hpp"
#include "cosim/iss/arm_core.hpp"
#include "cosim/iss/elf_image.hpp"

namespace armature::cosim::iss {

class ArmProgram final : public CoreProgram {
 public:
  // `firmware`: the bytes of controller.elf. `memory` is mapped where the firmware expects it, and must outlive the
  // program. The controller is constructed here, before simulated time begins. Throws std::runtime_error.
  // `cpi` and `watcher`: as of ArmCore.
  ArmProgram(std::span<const std::uint8_t> firmware, host_memory::HostMemory& memory,
             std::optional<double> cpi = std::nullopt, CoreWatcher* watcher = nullptr);

  void main(int core, CoreBus& bus) override;
  [[nodiscard]] std::int64_t instructions(int core) const override {
    return cores_.at(static_cast<std::size_t>(core)).instructions();
  }

  // After a flip a core ends where it cannot continue, and an endless loop takes time.
  [[nodiscard]] const CoreMemory& memory() const override { return memory_; }
  void flip_memory(std::uint32_t addr, std::uint32_t mask) override;
  [[nodiscard]] std::optional<std::uint64_t> digest() const override;

  [[nodiscard]] bool may_run_ahead() const override { return !watched_; }
  // The number of a core: 0 or 1.
  [[nodiscard]] ArmCore& core(int number) { return cores_.at(static_cast<std::size_t>(number)); }
  // The memory that both cores have from this address on, up to the end of its piece. Empty: there is none.
  [[nodiscard]] std::span<std::uint8_t> bytes_from(std::uint32_t address) const;
  // The instructions and constants of the firmware: code_begin() <= address < code_end().
  [[nodiscard]] std::uint32_t code_begin() const { return pieces_[0].address; }
  [[nodiscard]] std::uint32_t code_end() const { return code_end_; }

 private:
  // Of whole pages, which the engines need.
  struct Unmap {
    std::size_t bytes = 0;
    void operator()(void* pages) const;
  };
  using Pages = std::unique_ptr<void, Unmap>;
  static Pages pages(std::size_t bytes);

  ElfImage image_;
  Pages ddr_, on_chip_;
  std::array<MemoryPiece, 3> pieces_;
  CoreMemory memory_;
  std::uint32_t code_end_;
  bool watched_;
  std::array<ArmCore, 2> cores_;
  std::array<std::uint32_t, 2> starts_{};
};

}  // namespace armature::cosim::iss
