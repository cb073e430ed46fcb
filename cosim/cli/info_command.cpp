#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "controller/regs/soc_map.hpp"
#include "cosim/cli/command.hpp"
#include "cosim/scenario/logic_spec.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kInfoDetails = R"(Example:
  armature info)";

// soc_map.toml and the options of this program use the same names for the variants.
static_assert(std::ranges::all_of(regs::soc::kBlocks, [](const regs::soc::Block& block) {
  return block.variant.empty() || named<Variant>(kVariantNames, block.variant);
}));

int show_info(const SearchPath& path) {
  namespace soc = regs::soc;
  std::cout << fmt::format("armature {}\n", ARMATURE_VERSION);
  std::cout << fmt::format("compiler     {}\n", __VERSION__);
  std::cout << fmt::format("model        Verilator {}\n", ARMATURE_VERILATOR_OPT);
  std::cout << fmt::format("clock        {} MHz, tick {} cycles = {} us\n", kClkFreqHz / 1'000'000, kTickCycles,
                           kTickCycles * 1'000'000 / kClkFreqHz);
  for (const regs::soc::Block& block : soc::kBlocks) {
    std::cout << fmt::format("0x{:08X}   {}, {} KiB{}\n", block.base, block.name, block.size / 1024,
                             block.variant.empty() ? std::string{} : fmt::format(", --variant {} only", block.variant));
  }
  for (const SearchFolder& folder : path.folders()) {
    std::cout << fmt::format("scenarios    {} ({})\n", printable(folder.path.string(), kShowAll), folder.origin);
  }
  if (path.folders().empty())
    std::cout << fmt::format("scenarios    none ({})\n", printable(path.searched(), kShowAll));
  return kExitOk;
}

CommandAction declare_info(CLI::App&) {
  return [](const CommonOptions& common) { return show_info(common.search_path()); };
}

}  // namespace

Command info_command() {
  return {.name = "info",
          .order = 90,
          .summary = "Print version, clock, address map and the folders of scenarios",
          .details = kInfoDetails,
          .declare = declare_info};
}

}  // namespace armature::cosim
