// Compares two traces: integers and words exactly, floats within the tolerance of their column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/trace/csv_reader.hpp"

namespace armature::cosim {

// How the values of a column are compared. The rule follows from its name.
struct ColumnRule {
  enum class Kind : std::uint8_t { kText, kInteger, kReal };
  Kind kind = Kind::kInteger;
  double tolerance = 0;  // of kReal, in the column's unit
  int digits = 0;        // of kReal: after the point, in files and messages
};
[[nodiscard]] ColumnRule column_rule(std::string_view column);

struct ColumnDeviation {
  std::string column;
  ColumnRule rule;
  double largest = 0;     // of numbers: largest |b - a| of all common rows, infinite if a value is NaN
  std::int64_t tick = 0;  // of `largest`; of text: the first row that differs
  std::int64_t rows = 0;  // that differ, or are out of tolerance
};

// A row that both traces have.
struct RowPosition {
  std::int64_t tick = 0;
  std::optional<double> time_s;  // none: neither trace has it
  int line_a = 0, line_b = 0;    // in the files; 0: not in a file
};

struct Mismatch {
  RowPosition at;
  std::string column;
  std::string value_a, value_b;
};

// A column with digests covers every tick up to its row. In the first row with a different digest, the integers or the
// edges differ first in a tick after the row before and not after this row, even if the rows of the file are equal.
struct DigestMismatch {
  std::optional<RowPosition> after;  // the row before; none: it differs in the first row
  RowPosition until;
  std::int64_t rows = 0;  // with a different digest
};

// The ticks of which a trace has rows, as its first two rows tell.
class RowGrid {
 public:
  // Adds the tick of the next row.
  void add(std::int64_t tick);
  // Whether the tick is between two rows of this trace, and the other one has more rows: the interval of this one is a
  // multiple of the other's.
  [[nodiscard]] bool skips(std::int64_t tick, const RowGrid& other) const;

 private:
  std::int64_t rows_ = 0;
  std::int64_t first_ = 0, interval_ = 0;
};

// How messages name one of the two traces.
struct TraceName {
  std::string file;     // empty: there is no file that the user can read
  std::string value{};  // name of its values, as in `golden 90`; empty: the file
};

// Rows are paired by tick, columns by name. A row that only one trace has is a difference, unless the RowGrid of the
// other one skips it.
struct Comparison {
  TraceName a, b;
  std::string scenario{};        // as an argument of `armature run`, for the command that shows more; empty: unknown
  std::int64_t rows = 0;         // common ones
  std::int64_t rows_differ = 0;  // of them, in another column than the digest
  std::int64_t rows_only_a = 0, rows_only_b = 0;
  std::int64_t rows_between = 0;      // that the other trace skips
  std::int64_t last_tick = -1;        // of the common rows
  std::int64_t last_equal_tick = -1;  // of the common rows before the first one that differs
  std::optional<std::int64_t> first_tick_only_a, first_tick_only_b;
  std::vector<std::string> columns_only_a, columns_only_b;
  std::optional<Mismatch> first;  // in another column than the digest
  std::optional<DigestMismatch> digest;
  bool other_cycles =
      false;  // a trigger comes at another cycle, which digests cover: they are not compared from there on
  std::vector<ColumnDeviation> columns;  // common ones, in the order of trace a

  [[nodiscard]] bool equal() const;
  // Equal but for their digests, which are of two versions of the digest.
  [[nodiscard]] bool equal_but_for_version() const;
  // `PASS a.csv and b.csv are equal: ...` or `FAIL a.csv and b.csv differ: ...`, one line, no line end.
  [[nodiscard]] std::string verdict() const;
  // The same without the word and the names.
  [[nodiscard]] std::string counts() const;
  // Missing rows and columns, the first mismatch, and where the ticks differ first. Lines begin with two blanks and
  // end with '\n', here and below. Empty when nothing differs.
  [[nodiscard]] std::string first_differences() const;
  // The largest deviation of every column that deviates.
  [[nodiscard]] std::string deviations() const;
  [[nodiscard]] std::size_t deviating_columns() const;
  // first_differences() and deviations().
  [[nodiscard]] std::string details() const { return first_differences() + deviations(); }
  // verdict() and details().
  [[nodiscard]] std::string report() const { return verdict() + "\n" + details(); }
};

// Compares rows one by one with the rows of a file, in constant memory.
class TraceComparer {
 public:
  // `columns_b`: as in CsvRow. Throws InputError, as do the others, when trace a cannot be read or is malformed.
  TraceComparer(std::unique_ptr<CsvReader> trace_a, TraceName a, TraceName b,
                const std::vector<std::string>& columns_b);
  // Whether the next row of trace a has this tick.
  [[nodiscard]] bool is_next(std::int64_t tick) const { return more_a_ && a_->row().tick() == tick; }
  // Adds the next row of trace b, in the order of ticks.
  void add(const CsvRow& b);
  // Without what only finish() knows: rows that are left in trace a.
  [[nodiscard]] const Comparison& so_far() const { return result_; }
  // Call it once, after the last row of b.
  [[nodiscard]] Comparison finish();

 private:
  struct ColumnPair {
    std::size_t a, b;
  };
  void pair_columns(const std::vector<std::string>& a, const std::vector<std::string>& b);
  void next_a();
  void skip_a();
  void compare_rows(const CsvRow& a, const CsvRow& b);
  void compare_digest(const CsvRow& a, const CsvRow& b, const RowPosition& here);
  [[nodiscard]] RowPosition position_of(const CsvRow& a, const CsvRow& b) const;

  std::unique_ptr<CsvReader> a_;
  bool more_a_ = false;
  RowGrid grid_a_, grid_b_;
  std::vector<ColumnPair> pairs_;               // of result_.columns
  std::optional<std::size_t> time_a_, time_b_;  // columns
  std::optional<std::size_t> digest_;           // in pairs_
  std::optional<RowPosition> before_;           // the common row before
  Comparison result_;
};

// The shell command that shows these ticks. `scenario` as in Comparison.
[[nodiscard]] std::string show_ticks_command(const std::string& scenario, std::int64_t first, std::int64_t last);

// `a` is the reference, `b` is compared with it. Throws InputError when a file cannot be read or is malformed.
[[nodiscard]] Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b);
[[nodiscard]] Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b,
                                        TraceName name_a, TraceName name_b);

}  // namespace armature::cosim
