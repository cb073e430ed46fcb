// Compares two trace files: integers exactly, floats within the tolerance of their column.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature::cosim {

struct ColumnDeviation {
  std::string column;
  std::optional<double> tolerance;  // none: an integer column, equal or not
  double largest = 0;               // |b - a| over all common rows, in the column's unit
  std::int64_t tick = 0;            // where
  std::int64_t rows = 0;            // that are out of tolerance
};

struct Mismatch {
  int line_a = 0, line_b = 0;  // in the files
  std::int64_t tick = 0;
  std::string column;
  std::string value_a, value_b;
};

// Rows belong together when their ticks are equal, columns when their names are.
struct Comparison {
  std::string file_a, file_b;
  std::int64_t rows = 0;  // common ones
  std::int64_t rows_differ = 0;
  std::int64_t rows_only_a = 0, rows_only_b = 0;
  std::optional<std::int64_t> first_tick_only_a, first_tick_only_b;
  std::vector<std::string> columns_only_a, columns_only_b;
  std::optional<Mismatch> first;
  std::vector<ColumnDeviation> columns;  // common ones, in the order of file a

  [[nodiscard]] bool equal() const;
  // `PASS b.csv equals a.csv: ...` or `FAIL b.csv differs from a.csv: ...`, one line, no line end.
  [[nodiscard]] std::string verdict() const;
  // The verdict, what is missing, the first mismatch and the largest deviation of every column that is not zero.
  [[nodiscard]] std::string report() const;
};

// The tolerance of a float column by the unit at the end of its name; none for an integer column.
[[nodiscard]] std::optional<double> column_tolerance(std::string_view column);

// `a` is the reference, `b` what is judged. Throws InputError when a file cannot be read or is malformed.
[[nodiscard]] Comparison compare_traces(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace armature::cosim
