// The results that `armature check` keeps of a scenario that failed, each in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/report/judge/run_summary.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// One folder below `out` for each scenario, named after it. Scenarios of the same name get folders of different names.
[[nodiscard]] std::vector<std::filesystem::path> result_folders(const std::vector<Scenario>& scenarios,
                                                                const std::filesystem::path& out);

// Removes the results of an earlier check, and the folder if nothing else is in it. Throws std::filesystem_error.
void remove_results(const std::filesystem::path& folder);

// Copies the files that the run has written from `run` to `folder` and adds the summary. Throws std::filesystem_error
// or InputError when that is not possible.
void keep_results(const std::filesystem::path& run, const RunSummary& summary, const std::filesystem::path& folder);

}  // namespace armature::cosim
