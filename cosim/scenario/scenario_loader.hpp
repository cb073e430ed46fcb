// Finds, reads and checks a scenario and its robot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

struct LoadOptions {
  std::filesystem::path scenarios_dir = "scenarios";  // for bare scenario names, and robots not found otherwise
  std::vector<std::string> overrides;                 // `--set`, see override.hpp, applied in order before the checks
  std::optional<std::string> fabric{};                // "rtl" | "paper" instead of the scenario's own
};

// `where` is a scenario folder, a .toml file, or the bare name of a folder of `scenarios_dir`. The robot is looked up
// in `robots/` beside the scenario's folder, then in that of `scenarios_dir`; a name that ends in .toml is a path
// relative to the scenario file. Throws InputError with every problem of both files.
[[nodiscard]] Scenario load_scenario(const std::filesystem::path& where, const LoadOptions& options = {});

// Names of the folders that hold a scenario.toml, sorted. Empty when there is no such folder.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::filesystem::path& scenarios_dir);

}  // namespace armature::cosim
