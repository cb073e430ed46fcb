// A moment on a serial line, exact: a whole number of clock cycles and a fraction of one.
//
// A half bit is clock / (2 * baud * (1 + error)) cycles, a ratio of two integers, and the moment carries the remainder.
// So however many characters follow each other, every edge is where the rate says, never a rounding away from it.
#pragma once

#include <cstdint>

#include "controller/core/units.hpp"

namespace armature::cosim {

class LineTime {
 public:
  // What a half bit is from here on. `error_ppm` is above -1 000 000. A change of the rate keeps the moment to 1e-15 of
  // a cycle.
  void set_rate(std::int64_t baud, std::int64_t error_ppm);

  // At the beginning of this cycle.
  void set(Cycles cycle) { whole_ = cycle.value(), fraction_ = 0; }
  void advance(Cycles cycles) { whole_ += cycles.value(); }
  void advance_half_bits(int count);  // at most 64

  // The first cycle at or after the moment.
  [[nodiscard]] Cycles first_cycle() const { return Cycles{whole_ + (fraction_ > 0 ? 1 : 0)}; }

 private:
  std::int64_t whole_ = 0;
  std::int64_t fraction_ = 0;  // of denominator_, below it
  std::int64_t denominator_ = 1;
};

}  // namespace armature::cosim
