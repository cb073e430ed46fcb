// Reads a trace file line by line, in constant memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/trace/csv_row.hpp"

namespace armature::cosim {

class CsvReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{64} * 1024;  // bytes, with its end

  // A byte order mark, CR LF and a missing end of the last line are accepted. Throws InputError with file, line and
  // column of the file when it cannot be read or is malformed (csv_row.hpp), as does every call.
  explicit CsvReader(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& header() const noexcept { return row_->header(); }

  // Advances to the next row; false at the end of the file.
  bool next();
  [[nodiscard]] const CsvRow& row() const noexcept { return *row_; }

 private:
  bool read_line();

  std::string file_;
  std::ifstream stream_;
  std::vector<char> buffer_ = std::vector<char>(kLongestLine);
  std::string_view line_text_;  // the line in buffer_, without its end
  int line_ = 0;
  std::optional<CsvRow> row_;
};

}  // namespace armature::cosim
