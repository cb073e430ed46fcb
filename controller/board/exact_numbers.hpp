// Conversions between numbers of 64 bits, and floor, by the instructions of the Cortex-A9, which converts 32 bits at a
// time. The compiler's library computes them bit by bit, in four times the instructions. Results are exact or correctly
// rounded, as those of the host are.
#pragma once

#include <cmath>
#include <cstdint>

namespace armature::board {

inline constexpr double kWord = 0x1p32;

// Rounded once, by the sum: both parts are exact.
constexpr double to_double(std::int64_t value) noexcept {
  const double high = static_cast<std::int32_t>(value >> 32);
  return high * kWord + static_cast<double>(static_cast<std::uint32_t>(value));
}
constexpr double to_double(std::uint64_t value) noexcept {
  const double high = static_cast<std::uint32_t>(value >> 32);
  return high * kWord + static_cast<double>(static_cast<std::uint32_t>(value));
}

// Towards 0. The value is >= 0 and less than 2^64.
constexpr std::uint64_t to_unsigned(double value) noexcept {
  const auto high = static_cast<std::uint32_t>(value * (1.0 / kWord));
  const auto low = static_cast<std::uint32_t>(value - static_cast<double>(high) * kWord);
  return std::uint64_t{high} << 32 | low;
}

// Towards 0. The value is a number of 64 bits.
constexpr std::int64_t to_signed(double value) noexcept {
  if (std::fabs(value) < 0x1p31) return static_cast<std::int32_t>(value);
  const auto size = static_cast<std::int64_t>(to_unsigned(std::fabs(value)));
  return value < 0.0 ? -size : size;
}

constexpr double floor_of(double value) noexcept {
  const double size = std::fabs(value);
  if (!(size < 0x1p52)) return value;  // whole, or not a number
  double whole = 0.0;
  if (size < 0x1p31) {
    whole = static_cast<std::int32_t>(value);
  } else {
    whole = size + 0x1p52 - 0x1p52;  // the nearest
    if (value < 0.0) whole = -whole;
  }
  if (whole == value) return value;  // -0 stays
  return whole > value ? whole - 1.0 : whole;
}

}  // namespace armature::board
