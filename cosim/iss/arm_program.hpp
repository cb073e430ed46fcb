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
  // `cpi`: as of ArmCore.
  ArmProgram(std::span<const std::uint8_t> firmware, host_memory::HostMemory& memory,
             std::optional<double> cpi = std::nullopt);

  void main(int core, CoreBus& bus) override;
  [[nodiscard]] std::int64_t instructions(int core) const override {
    return cores_.at(static_cast<std::size_t>(core)).instructions();
  }

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
  std::array<ArmCore, 2> cores_;
  std::array<std::uint32_t, 2> starts_{};
};

}  // namespace armature::cosim::iss
