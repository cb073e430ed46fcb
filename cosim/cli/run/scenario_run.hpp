// A run of a command: the files that it writes, Ctrl-C, the pace and the progress. The commands run, watch, check and
// bless share it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "cosim/cli/waves/moment_wave.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_file.hpp"

namespace armature::cosim {

struct ScenarioRunOptions {
  std::vector<TraceFile> traces;    // to write
  std::optional<TraceFile> load{};  // what the cores did
  std::optional<WaveRequest> wave;
  std::optional<MomentWaveRequest> moment_wave{};
  std::optional<std::filesystem::path> log;         // events as text, one a line
  std::optional<std::filesystem::path> serial_log;  // of a scenario with a serial line
  SerialPeer* serial_peer = nullptr;
  bool show_progress = false;              // on stderr, if that is a terminal
  std::function<bool()> stop_requested{};  // ends the run as interrupted; empty: never. Called often
  std::optional<double> pace;              // simulated time per real time, above 0; nullopt: as fast as possible
  // The trace file of this run, for messages about the golden. Nullopt: the run is not compared with its golden, and
  // the summary does not mention the golden.
  std::optional<TraceFile> compare_golden;
};

// Runs to the end, to a failure or to an interrupt. The caller has called catch_interrupts().
[[nodiscard]] RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options);

}  // namespace armature::cosim
