// A run that writes its results into a folder: what `run` and `watch` do.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/waves/moment_wave.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

struct FolderRunOptions {
  std::filesystem::path out;
  std::optional<WaveRequest> wave{};
  std::optional<MomentWaveRequest> moment_wave{};
  std::optional<std::string> serial{};     // as in connect_serial()
  std::optional<double> pace{};            // as in ScenarioRunOptions
  bool show_progress = true;               // on stderr, if that is a terminal
  std::function<bool()> stop_requested{};  // ends the run as Ctrl-C does; empty: never
  std::string why_not_compared{};          // with the golden; empty: it is compared
};

// out/NAME: the folder for the results if the user names none.
[[nodiscard]] std::filesystem::path default_folder(const Scenario& scenario);

// Creates the folder, and adds the results in it to the files that the command writes.
void claim_results(OutputFiles& files, const std::filesystem::path& out);

// Runs the scenario and writes its results. The caller has called catch_interrupts(). `scenario` gets a serial line
// with the options of `serial`. Throws InputError when another run writes into the folder.
[[nodiscard]] RunSummary run_into_folder(Scenario& scenario, const FolderRunOptions& options);

}  // namespace armature::cosim
