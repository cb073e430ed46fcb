// Bits of doubles, for math.cpp and arc_tangent.cpp.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace armature::math {

inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Added to |v| < 2^51 it leaves the nearest integer in the low bits; subtracting it again gives that integer.
inline constexpr double kToInteger = 0x1.8p52;

// `v & kHighBits` keeps 26 significant bits: the product of two such parts, or of one such part and its rest, is exact.
inline constexpr std::uint64_t kHighBits = 0xFFFF'FFFF'F800'0000u;

[[nodiscard]] inline double high_part(double v) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) & kHighBits);
}

[[nodiscard]] inline double with_sign_of(double magnitude, double sign) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) |
                               (std::bit_cast<std::uint64_t>(sign) & kSignBit));
}

// True when both magnitudes are within 2^-240 .. 2^241: then no square, product or rest leaves the normal numbers.
// False for zeros, infinities and NaNs.
[[nodiscard]] inline bool both_moderate(double x, double y) noexcept {
  const auto moderate = [](double v) {
    return ((std::bit_cast<std::uint64_t>(v) >> 52) & 0x7FFu) - (1023 - 240) <= 480;
  };
  return moderate(x) && moderate(y);
}

}  // namespace armature::math
