#include "cosim/trace/csv_reader.hpp"

#include <cerrno>
#include <cstring>

#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

CsvReader::CsvReader(const std::filesystem::path& file) : file_{file.string()} {
  errno = 0;
  stream_.open(file, std::ios::binary);
  if (!stream_ || std::filesystem::is_directory(file)) {
    throw InputError{file_, std::string{"cannot open: "} + std::strerror(errno == 0 ? EISDIR : errno)};
  }
  if (!read_line()) throw InputError{file_, "is empty, expected a header line"};
  row_.emplace(file_, std::string{line_text_});
}

bool CsvReader::next() {
  if (!read_line()) return false;
  row_->set(line_, line_text_);
  return true;
}

bool CsvReader::read_line() {
  stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  auto length = static_cast<std::size_t>(stream_.gcount());
  if (stream_.bad()) throw InputError{file_, "cannot read"};
  if (length == 0) return false;
  ++line_;
  if (stream_.fail()) {
    throw InputError{Problem{
        file_, Origin{line_, 0, {}}, {}, "expected lines of less than " + std::to_string(kLongestLine) + " bytes"}};
  }
  if (!stream_.eof()) --length;  // the end of the line
  line_text_ = {buffer_.data(), length};
  if (line_ == 1) {
    if (const std::string_view encoding = foreign_encoding(line_text_); !encoding.empty()) {
      throw InputError{file_, "is " + std::string{encoding} + " text, expected UTF-8"};
    }
    line_text_ = without_byte_order_mark(line_text_);
  }
  if (line_text_.ends_with('\r')) line_text_.remove_suffix(1);
  return true;
}

}  // namespace armature::cosim
