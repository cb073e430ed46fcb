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

// How the values of a column are compared; its name tells.
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
  double largest = 0;     // of numbers: |b - a| over all common rows, infinite where one of them is no number
  std::int64_t tick = 0;  // where; of text: the first row that differs
  std::int64_t rows = 0;  // that differ, or are out of tolerance
};

// A row that both traces have.
struct RowPlace {
  std::int64_t tick = 0;
  std::optional<double> time_s;  // none: neither trace tells
  int line_a = 0, line_b = 0;    // in the files; 0: in none
};

struct Mismatch {
  RowPlace at;
  std::string column;
  std::string value_a, value_b;
};

// The column `digest` pins every tick up to its row: where it differs first, the integers differ first in a tick after
// the row before and not after this one, although the rows of the file may be equal.
struct DigestMismatch {
  std::optional<RowPlace> after;  // the row before; none: it differs in the first row
  RowPlace until;
  std::int64_t rows = 0;  // that differ in it
};

// How messages name one of the two traces.
struct TraceName {
  std::string file;     // empty: there is none that the user could look into
  std::string value{};  // what its values are called, as in `golden 90`; empty: by the file
};

// Rows belong together when their ticks are equal, columns when their names are.
struct Comparison {
  TraceName a, b;
  std::string scenario{};        // as `armature run` takes it, for the command that shows more; empty: unknown
  std::int64_t rows = 0;         // common ones
  std::int64_t rows_differ = 0;  // of them, in another column than `digest`
  std::int64_t rows_only_a = 0, rows_only_b = 0;
  std::int64_t last_tick = -1;  // of the common rows
  std::optional<std::int64_t> first_tick_only_a, first_tick_only_b;
  std::vector<std::string> columns_only_a, columns_only_b;
  std::optional<Mismatch> first;  // in another column than `digest`
  std::optional<DigestMismatch> digest;
  std::vector<ColumnDeviation> columns;  // common ones, in the order of trace a

  [[nodiscard]] bool equal() const;
  // `PASS a.csv and b.csv are equal: ...` or `FAIL a.csv and b.csv differ: ...`, one line, no line end.
  [[nodiscard]] std::string verdict() const;
  // The same without the word and the names.
  [[nodiscard]] std::string counts() const;
  // What is missing, the first mismatch, where the integers differ first and the largest deviation of every column that
  // is not zero; lines that begin with two blanks, '\n' ended. Empty when nothing deviates.
  [[nodiscard]] std::string details() const;
  // All of it.
  [[nodiscard]] std::string report() const { return verdict() + "\n" + details(); }
};

// Compares rows with those of a file as they come, in constant memory.
class TraceComparer {
 public:
  // `columns_b`: as in CsvRow. Throws InputError, as do the others, when trace a cannot be read or is malformed.
  TraceComparer(std::unique_ptr<CsvReader> trace_a, TraceName a, TraceName b,
                const std::vector<std::string>& columns_b);
  // The next row of trace b: in the order of their ticks.
  void add(const CsvRow& b);
  // After the last row of b, once.
  [[nodiscard]] Comparison finish();

 private:
  struct ColumnPair {
    std::size_t a, b;
  };
  void pair_columns(const std::vector<std::string>& a, const std::vector<std::string>& b);
  void skip_a();
  void compare_rows(const CsvRow& a, const CsvRow& b);
  void compare_digest(const CsvRow& a, const CsvRow& b, const RowPlace& here);
  [[nodiscard]] RowPlace place_of(const CsvRow& a, const CsvRow& b) const;

  std::unique_ptr<CsvReader> a_;
  bool more_a_ = false;
  std::vector<ColumnPair> pairs_;               // of result_.columns
  std::optional<std::size_t> time_a_, time_b_;  // columns
  std::optional<std::size_t> digest_;           // in pairs_
  std::optional<RowPlace> before_;              // the common row before
  Comparison result_;
};

// The command that shows these ticks of a scenario, as Comparison::scenario.
[[nodiscard]] std::string show_ticks_command(const std::string& scenario, std::int64_t first, std::int64_t last);

// `a` is the reference, `b` what is judged. Throws InputError when a file cannot be read or is malformed.
[[nodiscard]] Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b);
[[nodiscard]] Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b,
                                        TraceName name_a, TraceName name_b);

}  // namespace armature::cosim
