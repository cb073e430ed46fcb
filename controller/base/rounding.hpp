// Rounding to integers without the current rounding mode, exact for every double below 2^62.
#pragma once

#include <cmath>
#include <cstdint>

namespace armature {

// Nearest integer, ties away from zero. (floor(x + 0.5) is wrong for 0.5 - 2^-54, where the sum rounds up to 1.)
[[nodiscard]] inline std::int64_t round_half_away(double x) noexcept {
  const double magnitude = std::fabs(x);
  if (magnitude < 0x1p31) {  // an instruction instead of a call
    const auto cut = static_cast<std::int32_t>(magnitude);
    const std::int64_t rounded = std::int64_t{cut} + (magnitude - cut >= 0.5 ? 1 : 0);
    return x < 0.0 ? -rounded : rounded;
  }
  const double whole = std::floor(magnitude);
  const auto rounded = static_cast<std::int64_t>(whole) + (magnitude - whole >= 0.5 ? 1 : 0);
  return x < 0.0 ? -rounded : rounded;
}

// The next integer at or above x, as std::ceil, which would be a call of libm.
[[nodiscard]] inline double rounded_up(double x) noexcept {
  return -std::floor(-x);
}

}  // namespace armature
