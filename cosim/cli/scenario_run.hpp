// One run of a scenario with everything that is recorded and judged along the way; what run, check and bless share.
#pragma once

#include <cstdint>
#include <filesystem>
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
  std::optional<WaveRequest> wave;
  std::optional<std::filesystem::path> log;         // events as text, one a line
  std::optional<std::filesystem::path> serial_log;  // of a scenario with a serial line
  SerialPeer* serial_peer = nullptr;
  bool show_progress = false;  // on stderr, if that is a terminal
  // The trace file of this run as messages about the golden name it; none: the golden is not compared, and the summary
  // says nothing about it.
  std::optional<TraceFile> compare_golden;
};

// Runs to the end, a failure or an interrupt (interrupt.hpp; the caller catches them).
[[nodiscard]] RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options);

}  // namespace armature::cosim
