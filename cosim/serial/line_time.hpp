// An exact time on a serial line: a whole number of clock cycles and a fraction of one.
//
// A half bit is clock / (2 * baud * (1 + error)) cycles, a ratio of two integers. The remainder of the division is
// kept, so rounding errors do not add up over many characters.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim {

class LineTime {
 public:
  // Sets the length of a half bit from here on. `error_ppm` must be above -1 000 000. A change of the rate keeps the
  // time to 1e-15 of a cycle.
  void set_rate(std::int64_t baud, std::int64_t error_ppm);

  // Sets the time to the beginning of `cycle`.
  void set(Cycles cycle) { whole_ = cycle.value(), fraction_ = 0; }
  void advance(Cycles cycles) { whole_ += cycles.value(); }
  void advance_half_bits(int count);  // at most 64

  // The first cycle at or after the time.
  [[nodiscard]] Cycles first_cycle() const { return Cycles{whole_ + (fraction_ > 0 ? 1 : 0)}; }

 private:
  std::int64_t whole_ = 0;
  std::int64_t fraction_ = 0;  // of denominator_, below it
  std::int64_t denominator_ = 1;
};

}  // namespace armature::cosim
