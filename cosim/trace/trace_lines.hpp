// Which rows of a run become lines of its trace, and how.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "cosim/trace/columns.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// One line of header, then one line for every tick that is a multiple of `every_ticks`. Lines end with '\n'.
class TraceLines {
 public:
  static constexpr std::size_t kMaxText = kMaxRowText + 1;  // of append()

  TraceLines(std::int64_t every_ticks, ToolColumns tool_columns)
      : every_ticks_{every_ticks}, tool_columns_{tool_columns} {}

  [[nodiscard]] std::string header() const { return trace_header(tool_columns_) + '\n'; }
  // Whether the row has a line.
  [[nodiscard]] bool has(const TraceRow& row) const { return row.tick % every_ticks_ == 0; }
  // Writes the line at `out` and returns its end. `digest` includes this row and all rows before it.
  [[nodiscard]] char* append(char* out, const TraceRow& row, const IntegerDigest& digest) const {
    out = append_row(out, row, digest.prefix(), tool_columns_);
    *out++ = '\n';
    return out;
  }

 private:
  std::int64_t every_ticks_;
  ToolColumns tool_columns_;
};

}  // namespace armature::cosim
