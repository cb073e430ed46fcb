#include <fmt/format.h>

#include <iostream>

#include "controller/regs/soc_map.hpp"
#include "cosim/cli/commands.hpp"
#include "cosim/cli/scenario_folder.hpp"
#include "cosim/kernel/clock.hpp"

namespace armature::cosim {

int info_command() {
  namespace soc = regs::soc;
  std::cout << fmt::format("armature {}\n", ARMATURE_VERSION);
  std::cout << fmt::format("compiler     {}\n", __VERSION__);
  std::cout << fmt::format("model        Verilator {}\n", ARMATURE_VERILATOR_OPT);
  std::cout << fmt::format("clock        {} MHz, tick {} cycles = {} us\n", kClkFreqHz / 1'000'000, kTickCycles,
                           kTickCycles * 1'000'000 / kClkFreqHz);
  for (const regs::soc::Block& block : soc::kBlocks) {
    std::cout << fmt::format("0x{:08X}   {}, {} KiB{}\n", block.base, block.name, block.size / 1024,
                             block.fabric.empty() ? std::string{} : fmt::format(", --fabric {} only", block.fabric));
  }
  std::cout << fmt::format("scenarios    {}\n", scenario_folder().string());
  return kExitOk;
}

}  // namespace armature::cosim
