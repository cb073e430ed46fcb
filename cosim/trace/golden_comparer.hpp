// Judges a run by the golden of its scenario while it runs, row by row, in constant memory and without a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/compare.hpp"
#include "cosim/trace/golden.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// The trace file of this run, which messages name; the comparer does not touch it. Its rate may be any.
struct TraceFile {
  std::filesystem::path file;
  std::int64_t every_ticks = kGoldenEveryTicks;
};

class GoldenComparer {
 public:
  // `tool_columns`: whether the traces of the scenario have them. A golden that cannot be read is one that differs.
  GoldenComparer(const Scenario& scenario, ToolColumns tool_columns, TraceFile trace);

  // Every row of the run. `digest` has this row and all before it.
  void add(const TraceRow& row, IntegerDigest& digest);

  // After the last row of a run that came to its end, once. `digest` has all rows.
  [[nodiscard]] GoldenCheck finish(IntegerDigest& digest);

 private:
  [[nodiscard]] GoldenCheck judge(const Comparison& comparison, const std::string& sha256) const;

  std::filesystem::path golden_;
  std::optional<std::string> sha256_;  // of the golden
  std::string scenario_;               // as `armature run` takes it
  ToolColumns tool_columns_;
  TraceFile trace_;
  std::optional<CsvRow> row_;              // of this run
  std::optional<TraceComparer> comparer_;  // none: there is no file, or it cannot be read
  std::string error_;                      // why it cannot
  std::int64_t ticks_ = 0;
  std::vector<char> text_;
};

}  // namespace armature::cosim
