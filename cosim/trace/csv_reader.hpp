// Reads a trace file line by line, in constant memory.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "cosim/trace/csv_row.hpp"

namespace armature::cosim {

class CsvReader {
 public:
  // Throws InputError with file, line and column of the file when it cannot be read or is malformed (csv_row.hpp), as
  // does every call.
  explicit CsvReader(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& header() const noexcept { return row_->header(); }

  // Advances to the next row; false at the end of the file.
  bool next();
  [[nodiscard]] const CsvRow& row() const noexcept { return *row_; }

 private:
  bool read_line();

  std::string file_;
  std::ifstream stream_;
  std::string buffer_;
  int line_ = 0;
  std::optional<CsvRow> row_;
};

}  // namespace armature::cosim
