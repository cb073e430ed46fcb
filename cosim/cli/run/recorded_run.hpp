// The results of a run, as commands that show them read them.
#pragma once

#include <filesystem>

#include "cosim/cli/options/output_files.hpp"
#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// Warns on standard error if the run did not reach its end. If it was killed, the summary has only what was known
// before the run: the scenario and the robot. Throws InputError when the folder has no results.
[[nodiscard]] RunRecord recorded_run(const std::filesystem::path& folder);

// The same without the warning.
[[nodiscard]] RunRecord run_record_so_far(const std::filesystem::path& folder);

// The files that recorded_run() reads are inputs of the command. Throws InputError when there is no such folder.
void reads_results(OutputFiles& files, const std::filesystem::path& folder);

}  // namespace armature::cosim
