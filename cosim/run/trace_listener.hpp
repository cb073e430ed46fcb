// Writes trace.csv of a run.
#pragma once

#include "cosim/report/measure/tool_point.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/trace_file.hpp"

namespace armature::cosim {

class TraceListener final : public RunListener {
 public:
  // Throws InputError when the file cannot be written, as do all functions.
  TraceListener(const Scenario& scenario, const TraceFile& trace)
      : writer_{trace.file, trace.every_ticks, tool_columns(scenario)} {}

  void on_row(const TraceRow& row, const IntegerDigest& digest) override { writer_.write(row, digest); }
  void write_through() override { writer_.write_through(); }
  void on_end(const RunSummary&) override { writer_.close(); }

 private:
  CsvWriter writer_;
};

}  // namespace armature::cosim
