// Writes a trace file.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "cosim/trace/columns.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "cosim/trace/trace_lines.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// The lines are those of TraceLines. After write_through(), close() or destruction the file on disk contains whole
// lines only.
class CsvWriter {
 public:
  // Creates missing folders. Throws std::runtime_error naming the file when it cannot be written, as does every call.
  CsvWriter(const std::filesystem::path& file, std::int64_t every_ticks, ToolColumns tool_columns = ToolColumns::kNo);
  CsvWriter(CsvWriter&&) = default;
  CsvWriter& operator=(CsvWriter&&) = delete;
  ~CsvWriter();  // writes the rest and ignores errors, so call close() at the end of a good run

  // `digest` includes this row and all rows before it.
  void write(const TraceRow& row, const IntegerDigest& digest) {
    if (lines_.has(row)) append(row, digest);
  }
  // Writes all rows so far to the file, so that they remain when this process is killed.
  void write_through() { flush(); }
  void close();
  [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  void append(const TraceRow& row, const IntegerDigest& digest);
  void flush();

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  TraceLines lines_;
  std::int64_t rows_ = 0;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace armature::cosim
