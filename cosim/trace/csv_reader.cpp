#include "cosim/trace/csv_reader.hpp"

#include <cerrno>
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
  row_.emplace(file_, buffer_);
}

bool CsvReader::next() {
  if (!read_line()) return false;
  row_->set(line_, buffer_);
  return true;
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

}  // namespace armature::cosim
