#include "cosim/trace/csv_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {

CsvReader::CsvReader(const std::filesystem::path& file) : file_{file.string()} {
  errno = 0;
  stream_.open(file, std::ios::binary);
  if (!stream_ || std::filesystem::is_directory(file)) {
    throw InputError{file_, std::string{"cannot open: "} + std::strerror(errno == 0 ? EISDIR : errno)};
  }
  if (!read_line()) throw InputError{file_, "is empty, expected a header line"};
  split();
  header_.assign(fields_.begin(), fields_.end());
  if (header_.front() != "tick") fail(0, "expected the column \"tick\", found \"" + header_.front() + "\"");
  for (std::size_t i = 0; i < header_.size(); ++i) {
    const auto here = header_.begin() + static_cast<std::ptrdiff_t>(i);
    if (header_[i].empty()) fail(i, "empty column name");
    if (std::find(header_.begin(), here, header_[i]) != here) fail(i, "second column \"" + header_[i] + "\"");
  }
}

bool CsvReader::next() {
  if (!read_line()) return false;
  split();
  if (fields_.size() != header_.size()) {
    fail(std::min(fields_.size(), header_.size()) - 1, "expected " + std::to_string(header_.size()) +
                                                           " values as in the header, found " +
                                                           std::to_string(fields_.size()));
  }
  const std::int64_t tick = integer(0);
  if (tick <= tick_) fail(0, "expected a tick above " + std::to_string(tick_) + ", found " + std::to_string(tick));
  tick_ = tick;
  return true;
}

std::int64_t CsvReader::integer(std::size_t column) const {
  const std::string_view text = fields_[column];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail(column, header_[column] + ": expected an integer, found \"" + std::string{text} + "\"");
  }
  return value;
}

double CsvReader::number(std::size_t column) const {
  const std::string_view text = fields_[column];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail(column, header_[column] + ": expected a number, found \"" + std::string{text} + "\"");
  }
  return value;
}

bool CsvReader::read_line() {
  if (!std::getline(stream_, buffer_)) {
    if (stream_.bad()) throw InputError{file_, "cannot read"};
    return false;
  }
  ++line_;
  if (buffer_.ends_with('\r')) buffer_.pop_back();
  return true;
}

void CsvReader::split() {
  fields_.clear();
  std::string_view rest{buffer_};
  while (true) {
    const std::size_t comma = rest.find(',');
    fields_.push_back(rest.substr(0, comma));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
}

void CsvReader::fail(std::size_t column, const std::string& message) const {
  const auto place = static_cast<int>(fields_[column].data() - buffer_.data()) + 1;
  throw InputError{Problem{file_, Origin{line_, place, {}}, {}, message}};
}

}  // namespace armature::cosim
