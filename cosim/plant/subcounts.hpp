// Motor positions as exact fixed-point numbers, so that an encoder edge falls on the same clock cycle on every machine.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim {

// Encoder counts in units of 2^-24; 64 bits reach +-5e11 counts.
using Subcounts = Quantity<struct SubcountsTag, std::int64_t>;

struct CountRange {
  Counts min{};
  Counts max{};

  [[nodiscard]] bool has(Counts count) const { return count >= min && count <= max; }
};

inline constexpr int kSubcountBits = 24;
inline constexpr std::int64_t kSubcountsPerCount = std::int64_t{1} << kSubcountBits;

inline constexpr Subcounts kHalfCount{kSubcountsPerCount / 2};

[[nodiscard]] constexpr Subcounts to_subcounts(Counts counts) {
  return Subcounts{counts.value() * kSubcountsPerCount};
}

// The largest integer that is not above x, whose magnitude is below 2^63: std::floor() without a call of the library.
[[nodiscard]] constexpr std::int64_t floor_of(double x) {
  const auto towards_zero = static_cast<std::int64_t>(x);
  return towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0);
}

// The encoder's count at a position: floor(position + 1/2).
[[nodiscard]] constexpr Counts nearest_count(Subcounts position) {
  return Counts{(position + kHalfCount).value() >> kSubcountBits};
}

}  // namespace armature::cosim
