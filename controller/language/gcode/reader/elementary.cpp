#include "controller/language/gcode/reader/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace armature::gcode {
namespace {

constexpr double kLn2 = 0.693147180559945309417232121458;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kExponentBias = 1023;
constexpr int kFractionBits = 52;

// 2^n for -1022 <= n <= 1023.
double two_to(int n) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(n + kExponentBias) << kFractionBits);
}

double product_power(double base, int exponent) noexcept {
  double result = 1.0;
  for (int rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

}  // namespace

double exponential(double x) noexcept {
  if (x > 709.78) return kInfinity;
  if (x < -745.0) return 0.0;
  // x = n ln 2 + r with |r| <= ln 2 / 2; the series of exp(r) ends below 1e-17.
  const double n = std::floor(x / kLn2 + 0.5);
  const double r = x - n * kLn2;
  double sum = 1.0;
  for (int term = 15; term > 0; --term) sum = 1.0 + sum * r / term;
  const int scale = static_cast<int>(n);
  const int half = scale / 2;  // two factors: 2^n alone may be outside the normal numbers
  return sum * two_to(half) * two_to(scale - half);
}

double logarithm(double x) noexcept {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= two_to(kFractionBits);
    exponent = -kFractionBits;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> kFractionBits) - kExponentBias;
  double mantissa = x / two_to(static_cast<int>(bits >> kFractionBits) - kExponentBias);
  if (mantissa > 1.4142135623730951) {
    mantissa /= 2.0;
    ++exponent;
  }
  // ln m = 2 artanh(s), s = (m - 1) / (m + 1), |s| <= 0.172; the series ends below 1e-17.
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  double sum = 0.0;
  for (int term = 23; term > 0; term -= 2) sum = sum * s * s + 1.0 / term;
  return exponent * kLn2 + 2.0 * s * sum;
}

double power(double base, double exponent) noexcept {
  constexpr double kMaxProducts = 64.0;
  const bool whole = std::floor(exponent) == exponent;
  if (whole && std::fabs(exponent) <= kMaxProducts) {
    const double result = product_power(base, static_cast<int>(std::fabs(exponent)));
    return exponent < 0.0 ? 1.0 / result : result;
  }
  if (base == 0.0) return exponent < 0.0 ? kInfinity : 0.0;
  const double magnitude = exponential(exponent * logarithm(std::fabs(base)));
  const bool odd = whole && std::floor(exponent / 2.0) * 2.0 != exponent;
  return base < 0.0 && odd ? -magnitude : magnitude;
}

}  // namespace armature::gcode
