// What `armature check` leaves of a scenario that failed: the results of the run, in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/report/judge/run_summary.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// A folder for each scenario, below `out`, named after it; scenarios of one name get folders of different names.
[[nodiscard]] std::vector<std::filesystem::path> result_folders(const std::vector<Scenario>& scenarios,
                                                                const std::filesystem::path& out);

// Removes what an earlier check kept there, and the folder if nothing else is in it. Throws std::filesystem_error.
void remove_results(const std::filesystem::path& folder);

// Copies the files of the run from `run`, those that it wrote, and writes the summary. Throws std::filesystem_error or
// InputError when that is not possible.
void keep_results(const std::filesystem::path& run, const RunSummary& summary, const std::filesystem::path& folder);

// The one command that shows why the scenario failed.
[[nodiscard]] std::string showing_command(const Scenario& scenario, const RunSummary& summary);

}  // namespace armature::cosim
