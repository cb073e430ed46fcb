// Columns of integers in few characters, for pages that must fit everything into one file.
//
// The values are replaced by the differences of neighbours, up to three times: positions of a motor change so evenly
// that one byte is then enough for a value. Each difference is a variable-length integer; the bytes are base64 text.
// web/decode.js reads it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace armature::cosim {

struct ColumnCode {
  int order = 0;     // how often differences were taken, 0 to kMaxDifferences
  std::string text;  // base64
};

inline constexpr int kMaxDifferences = 3;

// The shortest code of all orders. All differences must be below 2^52, so that a browser computes with them exactly.
[[nodiscard]] ColumnCode column_code(const std::vector<std::int64_t>& values);

}  // namespace armature::cosim
