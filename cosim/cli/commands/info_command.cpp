#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "controller/base/words.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/version.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kInfoDetails = R"(Examples:
  armature info
  armature info --json)";

// soc_map.toml and the options of this program use the same names for the variants.
static_assert(std::ranges::all_of(regs::soc::kBlocks, [](const regs::soc::Block& block) {
  return block.variant.empty() || enumerator_of<Variant>(block.variant);
}));

nlohmann::ordered_json info_json(const SearchPath& path) {
  nlohmann::ordered_json info = {{"version", version()},
                                 {"compiler", __VERSION__},
                                 {"model", ARMATURE_VERILATOR_OPT},
                                 {"clock_hz", kClkFreqHz},
                                 {"tick_cycles", kTickCycles}};
  info["blocks"] = nlohmann::ordered_json::array();
  for (const regs::soc::Block& block : regs::soc::kBlocks) {
    info["blocks"].push_back(
        {{"name", block.name},
         {"base", block.base},
         {"size", block.size},
         {"variant", block.variant.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(block.variant)}});
  }
  info["folders"] = nlohmann::ordered_json::array();
  for (const SearchFolder& folder : path.folders()) {
    info["folders"].push_back({{"path", folder.path.string()}, {"origin", folder.origin}});
  }
  return info;
}

int show_info(const SearchPath& path) {
  namespace soc = regs::soc;
  std::cout << fmt::format("armature {}\n", version());
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

CommandAction declare_info(CLI::App& app) {
  const auto output = std::make_shared<OutputOptions>();
  add_json_option(app, *output);
  return [output](const CommonOptions& common) {
    if (!output->json) return show_info(common.search_path());
    print_json(info_json(common.search_path()));
    return kExitOk;
  };
}

}  // namespace

Subcommand info_command() {
  return {.name = "info",
          .order = 90,
          .summary = "Print version, clock, address map and the folders of scenarios",
          .details = kInfoDetails,
          .declare = declare_info};
}

}  // namespace armature::cosim
