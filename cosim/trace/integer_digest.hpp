// SHA-256 of the integer columns of every tick: a golden checks them at 20 kHz without storing them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/text/sha256.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// The hashed text is that of a full-rate trace file without `time_s` and without the columns after the integers: the
// header line, then one line per tick, each with '\n' at its end. `cut -d, -f1,3-27 trace.csv | sha256sum` of a trace
// with every_ticks = 1 gives the same.
class IntegerDigest {
 public:
  static constexpr std::size_t kPrefixDigits = 16;

  IntegerDigest();
  void add(const TraceRow& row);
  // Digest of all rows so far, 64 lower-case hexadecimal digits.
  [[nodiscard]] std::string hex() const;
  // The first kPrefixDigits of hex(): the column `digest` of the row that was added last. Valid until the next add().
  [[nodiscard]] std::string_view prefix() const;

 private:
  void flush() const;

  // Hashing is put off until somebody asks or the buffer is full.
  mutable Sha256 sha256_;
  std::vector<char> buffer_;
  mutable std::size_t used_ = 0;
  mutable std::string prefix_;  // of all rows so far; empty: not computed yet
};

}  // namespace armature::cosim
