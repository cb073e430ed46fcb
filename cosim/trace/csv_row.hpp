// One row of a trace. Returns the value of a column as text, integer or number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/text/csv_line.hpp"

namespace armature::cosim {

// Comma-separated values without quoting, under a header whose first column is `tick`, which increases from row to row.
// Anything else throws InputError with `file`, line and column of the file.
class CsvRow {
 public:
  // `header`: line 1 of `file`, without its end.
  CsvRow(std::string file, std::string header);
  CsvRow(const CsvRow&) = delete;
  CsvRow& operator=(const CsvRow&) = delete;

  [[nodiscard]] const std::vector<std::string>& header() const noexcept { return header_; }

  // Sets the next row. `line`: its line in the file, from 2; 0: not in a file.
  void set(int line, std::string_view text);

  [[nodiscard]] int line() const noexcept { return values_.line(); }
  [[nodiscard]] std::int64_t tick() const noexcept { return tick_; }
  [[nodiscard]] std::string_view text(std::size_t column) const { return values_[column]; }
  [[nodiscard]] std::int64_t integer(std::size_t column) const;
  [[nodiscard]] double number(std::size_t column) const;  // accepts "nan", which the writer uses for invalid values

 private:
  template <class T>
  [[nodiscard]] T value(std::size_t column, std::string_view kind) const;

  std::string text_;
  CsvLine values_;  // of text_
  std::vector<std::string> header_;
  std::int64_t tick_ = -1;
};

}  // namespace armature::cosim
