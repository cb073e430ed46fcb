// Compares a run with the golden of its scenario. Without this listener the summary does not mention the golden.
#pragma once

#include <optional>

#include "cosim/golden/golden_comparer.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_file.hpp"

namespace armature::cosim {

class GoldenListener final : public RunListener {
 public:
  // `trace`: the trace file of this run, which messages name.
  GoldenListener(const Scenario& scenario, const TraceFile& trace)
      : comparer_{scenario, tool_columns(scenario), trace} {}

  void on_row(const TraceRow& row, const IntegerDigest& digest) override { comparer_.add(row, digest); }

  // As of GoldenComparer.
  [[nodiscard]] std::optional<TimeSpan> difference() const { return comparer_.difference(); }

  // Only a run that has reached its end can equal the golden.
  void judge(RunSummary& summary) override {
    if (summary.interrupted) {
      summary.golden = {GoldenVerdict::kNotCompared, "the run was interrupted", {}};
    } else if (summary.failure) {
      summary.golden = {GoldenVerdict::kNotCompared, "the run failed before its end", {}};
    } else {
      summary.golden = comparer_.finish(summary.facts.sha256);
    }
  }

 private:
  GoldenComparer comparer_;
};

}  // namespace armature::cosim
