#include "cosim/trace/csv_row.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {

CsvRow::CsvRow(std::string file, std::string header) : file_{std::move(file)}, text_{std::move(header)} {
  split();
  header_.assign(fields_.begin(), fields_.end());
  // What was found is not shown: the file may be any file.
  if (header_.front() != kTickColumn) fail(0, "expected the column \"tick\", found another text");
  for (std::size_t i = 0; i < header_.size(); ++i) {
    const auto here = header_.begin() + static_cast<std::ptrdiff_t>(i);
    if (header_[i].empty()) fail(i, "empty column name");
    if (std::find(header_.begin(), here, header_[i]) != here)
      fail(i, "duplicate column \"" + printable(header_[i]) + "\"");
  }
}

void CsvRow::set(int line, std::string_view text) {
  line_ = line;
  text_ = text;
  split();
  if (fields_.size() != header_.size()) {
    fail(std::min(fields_.size(), header_.size()) - 1, "expected " + std::to_string(header_.size()) +
                                                           " values as in the header, found " +
                                                           std::to_string(fields_.size()));
  }
  const std::int64_t tick = integer(0);
  if (tick <= tick_) fail(0, "expected a tick above " + std::to_string(tick_) + ", found " + std::to_string(tick));
  tick_ = tick;
}

std::int64_t CsvRow::integer(std::size_t column) const {
  const std::string_view text = fields_[column];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail(column, printable(header_[column]) + ": expected an integer, found \"" + printable(text) + "\"");
  }
  return value;
}

double CsvRow::number(std::size_t column) const {
  const std::string_view text = fields_[column];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail(column, printable(header_[column]) + ": expected a number, found \"" + printable(text) + "\"");
  }
  return value;
}

void CsvRow::split() {
  fields_.clear();
  std::string_view rest{text_};
  while (true) {
    const std::size_t comma = rest.find(',');
    fields_.push_back(rest.substr(0, comma));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
}

void CsvRow::fail(std::size_t column, const std::string& message) const {
  const auto column_number = static_cast<int>(fields_[column].data() - text_.data()) + 1;
  throw InputError{Problem{file_, Origin{line_, column_number, {}}, {}, message}};
}

}  // namespace armature::cosim
