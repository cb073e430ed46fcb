// Reads a trace file line by line, in constant memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

// Comma-separated values without quoting, a header line first, the first column is `tick` and increases from row to
// row. Anything else throws InputError with file, line and column of the file.
class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& header() const noexcept { return header_; }

  // Advances to the next row; false at the end of the file. The fields below are those of this row.
  bool next();
  [[nodiscard]] int line() const noexcept { return line_; }  // in the file; the header is line 1
  [[nodiscard]] std::int64_t tick() const noexcept { return tick_; }
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }
  [[nodiscard]] std::int64_t integer(std::size_t column) const;
  [[nodiscard]] double number(std::size_t column) const;  // "nan" is a number here: the writer's mark for nonsense

 private:
  bool read_line();
  void split();
  [[noreturn]] void fail(std::size_t column, const std::string& message) const;

  std::string file_;
  std::ifstream stream_;
  std::string buffer_;
  std::vector<std::string_view> fields_;  // into buffer_
  std::vector<std::string> header_;
  int line_ = 0;
  std::int64_t tick_ = -1;
};

}  // namespace armature::cosim
