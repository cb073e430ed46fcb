// Why a run did not pass, and the command that shows it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/report/judge/run_summary.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// The reasons, one in each line; details of a golden follow it. Empty if the run passed and has a golden.
[[nodiscard]] std::string failure_reasons(const Scenario& scenario, const RunSummary& summary);

// The waveforms that the run wrote into `folder` because its engines differ, one line. Empty if it wrote none.
[[nodiscard]] std::string engine_waves_text(const RunSummary& summary, const std::filesystem::path& folder);

// A command, and what the user gets by it: `to see it`.
struct NextCommand {
  std::string_view what;
  std::string command;
};

// The one command that shows why a run failed. If the moment of the failure is known, it writes the waveform around it
// (FST if it is long and can be converted, else VCD), and the report begins there. If nothing failed but that there is
// no golden, the command that makes one. `options`: words of the command line that made this run what it is, such as
// --set. `out`: the folder for the results.
[[nodiscard]] NextCommand next_command(const Scenario& scenario, const RunSummary& summary, const std::string& out,
                                       const std::vector<std::string>& options = {});
// The command that shows where two engines differ, after a run that wrote their waveforms into `folder`.
[[nodiscard]] NextCommand compare_engines_command(const std::filesystem::path& folder);

}  // namespace armature::cosim
