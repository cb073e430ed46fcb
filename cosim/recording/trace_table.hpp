// A whole trace file in memory: each column as exact integers, so that what is drawn is what the file says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

// A column of numbers. A value is an integer in units of 10^-digits.
struct NumberColumn {
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();  // the file says `nan`

  std::string name;
  int digits = 0;  // after the point
  std::vector<std::int64_t> values{};

  // NaN for kNone.
  [[nodiscard]] double number(std::size_t row) const;
};

// Consecutive rows with the same word in the column `state`.
struct StateSpan {
  std::string state;
  std::size_t first_row = 0;
};

struct TraceTable {
  std::string file;                     // for messages
  std::vector<NumberColumn> columns{};  // of numbers, in the order of the file
  std::vector<StateSpan> states{};

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  // Nullptr: the file does not have it.
  [[nodiscard]] const NumberColumn* find(std::string_view name) const;
  // Throws InputError if the file does not have it.
  [[nodiscard]] const NumberColumn& column(std::string_view name) const;
};

// Throws InputError when the file cannot be read, is malformed or has no rows.
[[nodiscard]] TraceTable read_trace_table(const std::filesystem::path& file);

}  // namespace armature::cosim
