// Decimals of a fixed number of digits, for files with many of them. Each function writes at `out` and returns the end.
// No locale, and the same text on every machine.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace armature::cosim {

inline constexpr std::size_t kMaxIntegerText = 20;  // of an int64
inline constexpr std::size_t kMaxFixedText = 32;    // of append_fixed()
inline constexpr double kLargestFixed = 1e15;       // of append_fixed()

[[nodiscard]] inline char* append_integer(char* out, std::int64_t value) {
  return std::to_chars(out, out + kMaxIntegerText, value).ptr;
}

// 10 to this power: the units of a last digit that make one.
template <int kDigits>
inline constexpr std::uint64_t kPowerOfTen = 10 * kPowerOfTen<kDigits - 1>;
template <>
inline constexpr std::uint64_t kPowerOfTen<0> = 1;

// `units` of the last digit.
template <int kDigits>
[[nodiscard]] char* append_units(char* out, std::uint64_t units) {
  out = append_integer(out, static_cast<std::int64_t>(units / kPowerOfTen<kDigits>));
  *out = '.';
  std::uint64_t rest = units % kPowerOfTen<kDigits>;
  for (int i = kDigits; i > 0; --i, rest /= 10) out[i] = static_cast<char>('0' + rest % 10);
  return out + kDigits + 1;
}

// What std::to_chars writes with kDigits digits after the point, but no minus before a zero. |value| < kLargestFixed.
template <int kDigits>
[[nodiscard]] char* append_fixed(char* out, double value) {
  static_assert(kDigits <= 9);
  __extension__ using Wide = unsigned __int128;
  constexpr int kFractionBits = 52, kBias = 1075;
  const auto bits = std::bit_cast<std::uint64_t>(std::fabs(value));
  const int exponent = static_cast<int>(bits >> kFractionBits);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << kFractionBits) - 1);
  // |value| = mantissa / 2^shift, and shift is positive because the value is below 2^50.
  const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | std::uint64_t{1} << kFractionBits;
  const int shift = kBias - (exponent == 0 ? 1 : exponent);
  const Wide scaled = Wide{mantissa} * kPowerOfTen<kDigits>;
  Wide units = 0;
  constexpr int kScaledBits = 53 + 30;  // a larger shift gives less than half a unit
  if (shift <= kScaledBits) {
    const Wide half = Wide{1} << (shift - 1), rest = scaled & (2 * half - 1);
    units = scaled >> shift;
    if (rest > half || (rest == half && (units & 1) != 0)) ++units;
  }
  if (value < 0 && units != 0) *out++ = '-';
  constexpr std::uint64_t kMaxUnits = INT64_MAX;
  if (units > kMaxUnits)
    return std::to_chars(out, out + kMaxFixedText, std::fabs(value), std::chars_format::fixed, kDigits).ptr;
  return append_units<kDigits>(out, static_cast<std::uint64_t>(units));
}

}  // namespace armature::cosim
