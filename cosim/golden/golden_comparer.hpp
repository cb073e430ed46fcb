// Compares a run with the golden of its scenario during the run: row by row, in constant memory, without a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cosim/golden/golden.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/compare.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "cosim/trace/trace_file.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

class GoldenComparer {
 public:
  // `tool_columns`: whether the traces of the scenario have them. `trace`: the trace file of this run, for messages.
  // The comparer does not use the file itself. A golden that cannot be read counts as different.
  GoldenComparer(const Scenario& scenario, ToolColumns tool_columns, TraceFile trace);

  // Adds a row. Call it for every row of the run. `digest` includes this row and all rows before it.
  void add(const TraceRow& row, const IntegerDigest& digest);

  // When the difference begins; none: all rows so far are equal. It stays as it is once it is known.
  [[nodiscard]] std::optional<TimeSpan> difference() const;

  // Call it once, after the last row of a run that reached its end. `sha256` is the digest of all rows.
  [[nodiscard]] GoldenCheck finish(const std::string& sha256);

 private:
  // When the difference begins: from the last row that is equal to the first one that is not.
  [[nodiscard]] std::optional<TimeSpan> begins(const Comparison& comparison) const;
  [[nodiscard]] GoldenCheck check(const Comparison& comparison, const std::string& sha256) const;

  std::filesystem::path golden_;
  std::optional<std::string> sha256_;  // of the golden
  std::string scenario_;               // as an argument of `armature run`
  ToolColumns tool_columns_;
  TraceFile trace_;
  std::optional<CsvRow> row_;              // of this run
  std::optional<TraceComparer> comparer_;  // none: there is no file, or it cannot be read
  std::string error_;                      // why it cannot be read
  std::int64_t ticks_ = 0;
  std::int64_t first_cycle_ = 0;  // of tick 0
  std::vector<char> text_;
};

}  // namespace armature::cosim
