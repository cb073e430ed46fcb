// Finds, reads and checks a scenario and its robot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/scenario/files/search_path.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

struct LoadOptions {
  SearchPath search_path{};              // for bare names of scenarios, and robots that are not beside the scenario
  std::vector<std::string> overrides{};  // `--set`, see override.hpp, applied in order before the checks
  LogicChoice logic{};
  std::optional<CpuKind> processor{};  // replaces `cpu.processor`
};

// `where` is a scenario folder, a .toml file, or a bare name on the search path. The robot is looked up in `robots/`
// beside the scenario's folder, then on the search path; a name that ends in .toml is a path relative to the scenario
// file. Throws InputError with every problem of both files.
[[nodiscard]] Scenario load_scenario(const std::filesystem::path& where, const LoadOptions& options = {});

// The files of the scenarios that `where` means: those of every scenario in it when it is a folder of scenarios, else
// the one that load_scenario() reads. Throws InputError when there is none.
[[nodiscard]] std::vector<std::filesystem::path> find_scenario_files(const std::filesystem::path& where,
                                                                     const SearchPath& search_path);

}  // namespace armature::cosim
