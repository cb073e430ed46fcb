// SHA-256 of the integers of every tick: a golden checks them at 20 kHz without storing them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/text/sha256.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// The integers of a tick and what defines its edges, as 64 bits. Rows that differ in one value have different hashes;
// rows that differ in several have the same one with a probability of 2^-64.
//
// A hash begins with 1. A value v changes it from h to x ^ (x >> 32), with x = (h ^ v) * 0x9E3779B97F4A7C15 modulo
// 2^64. The values are tick, number of the state, cycle of the trigger, and a hash for each axis. That has cmd_pulses,
// pin_pulses, enc_counts, corr_pulses, first_rise, turned, motor_from and motor_to of the axis (TraceRow).
[[nodiscard]] std::uint64_t tick_hash(const TraceRow& row);

// The hashed bytes are the tick_hash() of each tick, the lowest byte first.
class IntegerDigest {
 public:
  static constexpr std::size_t kPrefixDigits = 16;

  IntegerDigest();
  void add(const TraceRow& row) {
    const std::uint64_t hash = tick_hash(row);
    std::memcpy(bytes_.data() + used_, &hash, sizeof hash);
    used_ += sizeof hash;
    prefix_.clear();
    if (used_ == bytes_.size()) flush();
  }
  // Digest of all rows so far, 64 lower-case hexadecimal digits.
  [[nodiscard]] std::string hex() const;
  // The first kPrefixDigits of hex(): the column kDigestColumn of the row that was added last. Valid until the next
  // add().
  [[nodiscard]] std::string_view prefix() const;

 private:
  void flush() const;

  // Hashing is put off until somebody asks or the buffer is full.
  mutable Sha256 sha256_;
  std::vector<char> bytes_;
  mutable std::size_t used_ = 0;
  mutable std::string prefix_;  // of all rows so far; empty: not computed yet
};

}  // namespace armature::cosim
