#include "cosim/trace/csv_row.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "cosim/text/printable.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {

CsvRow::CsvRow(std::string file, std::string header) : text_{std::move(header)}, values_{std::move(file)} {
  values_.set(1, text_);
  header_.assign(values_.values().begin(), values_.values().end());
  // What was found is not shown: the file may be any file.
  if (header_.front() != kTickColumn) values_.fail(0, "expected the column \"tick\", found another text");
  for (std::size_t i = 0; i < header_.size(); ++i) {
    const auto here = header_.begin() + static_cast<std::ptrdiff_t>(i);
    if (header_[i].empty()) values_.fail(i, "empty column name");
    if (std::find(header_.begin(), here, header_[i]) != here)
      values_.fail(i, "duplicate column \"" + printable(header_[i]) + "\"");
  }
}

void CsvRow::set(int line, std::string_view text) {
  text_ = text;
  values_.set(line, text_);
  if (const std::size_t found = values_.values().size(); found != header_.size()) {
    values_.fail(std::min(found, header_.size()) - 1, "expected " + std::to_string(header_.size()) +
                                                          " values as in the header, found " + std::to_string(found));
  }
  const std::int64_t tick = integer(0);
  if (tick <= tick_)
    values_.fail(0, "expected a tick above " + std::to_string(tick_) + ", found " + std::to_string(tick));
  tick_ = tick;
}

template <class T>
T CsvRow::value(std::size_t column, std::string_view kind) const {
  if (const std::optional<T> value = values_.number<T>(column)) return *value;
  values_.fail(column, printable(header_[column]).append(": expected ").append(kind).append(", found \"") +
                           printable(text(column)) + "\"");
}

std::int64_t CsvRow::integer(std::size_t column) const {
  return value<std::int64_t>(column, "an integer");
}

double CsvRow::number(std::size_t column) const {
  return value<double>(column, "a number");
}

}  // namespace armature::cosim
