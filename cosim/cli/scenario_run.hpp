// One run of a scenario, with its recording and judging. The commands run, check and bless share it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "cosim/kernel/simulation.hpp"
#include "cosim/report/format/progress_bar.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/golden_comparer.hpp"
#include "cosim/trace/integer_digest.hpp"

namespace armature::cosim {

// A trace file to write.
struct TraceRequest {
  std::filesystem::path file;
  std::int64_t every_ticks = 1;
};

struct ScenarioRunOptions {
  std::vector<TraceRequest> traces;
  std::optional<TraceRequest> load{};  // what the cores did
  std::optional<WaveRequest> wave;
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

// What is known before the run. It is that of an interrupted run of no tick.
[[nodiscard]] RunSummary summary_before_run(const Scenario& scenario);

// Runs to the end, to a failure or to an interrupt. The caller has called catch_interrupts().
[[nodiscard]] RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options);

}  // namespace armature::cosim
