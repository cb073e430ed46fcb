#include "controller/base/math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "controller/base/double_bits.hpp"
#include "controller/base/lanes.hpp"

// Every result is rounded once from a sum of two doubles, high + low; the low part contains what the earlier operations
// lost. Without FMA a product is exact only when its factors are short enough, so numbers are split into a short high
// part and the rest. All of it requires rounding to nearest, ties to even, the default of IEEE 754.

namespace armature::math {
namespace {

// pi/2 = the sum of the four. The first three have at most 33 bits: their products with an integer below 2^20 are
// exact.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2ep-69;
constexpr double kHalfPi4 = 0x1.b839a252049c1p-104;
constexpr double kHalfPi34 = 0x1.3198a2e037073p-69;  // the last two as one

// V: double, or Lanes for two arguments at once.
template <class V>
struct BitsOf;
template <>
struct BitsOf<double> {
  using Type = std::uint64_t;
};
template <>
struct BitsOf<Lanes> {
  using Type = Masks;
};
template <class V>
using Bits = typename BitsOf<V>::Type;

constexpr double kLargest = 1e6;

// x = (quadrant) pi/2 + high + low, |high| <= pi/4 except for rounding.
template <class V>
struct Reduced {
  V high;
  V low;
  Bits<V> quadrant;  // its last two bits
};

// The nearest number n of quarters, and x without the first part of each.
template <class V>
struct Quarters {
  V n;
  V first;
  Bits<V> quadrant;
};

// |x| <= 1e6.
template <class V>
Quarters<V> quarters(V x) {
  constexpr double kTwoByPi = 0x1.45f306dc9c883p-1;
  const V shifted = x * kTwoByPi + kToInteger;
  const V n = shifted - kToInteger;
  return {n, x - n * kHalfPi1,
          std::bit_cast<Bits<V>>(shifted)};  // the difference is exact: a multiple of 2^-53 below 1
}

// Where |first| is smaller, the later parts cancel too much of it.
constexpr double kNearZero = 0x1p-13;

template <class V>
Reduced<V> reduce(const Quarters<V>& q) {
  const V second = q.n * kHalfPi2;
  const V sum = q.first - second;
  const V low = ((q.first - sum) - second) - q.n * kHalfPi34;
  const V high = sum + low;
  return {high, (sum - high) + low, q.quadrant};
}

// For arguments near a zero of sine or cosine, where the first subtractions cancel all but the last bits of x.
Reduced<double> reduce_near_zero(double x, double n, std::uint64_t quadrant) {
  if (n == 0.0) return {x, 0.0, quadrant};
  // Exact: the result is a multiple of 2^-65 below 2^-12.
  const double a = (x - n * kHalfPi1) - n * kHalfPi2;
  const double b = -n * kHalfPi3;
  const double sum = a + b;
  const double b_taken = sum - a;
  const double rest = (a - (sum - b_taken)) + (b - b_taken);
  const double low = rest - n * kHalfPi4;
  const double high = sum + low;
  return {high, (sum - high) + low, quadrant};
}

// |x| <= 1e6.
Reduced<double> reduce(double x) {
  const Quarters<double> q = quarters(x);
  if (std::fabs(q.first) < kNearZero) [[unlikely]]
    return reduce_near_zero(x, q.n, q.quadrant);
  return reduce(q);
}

// Minimax polynomials in z = x^2 on |x| <= pi/4: (sin(x)/x - 1)/z to 2^-57 and (cos(x) - 1 + z/2)/z^2 to 2^-59 of 1.
template <class V>
V sine_polynomial(V z) {
  const V z2 = z * z;
  const V low = (-0x1.5555555555549p-3 + 0x1.111111110f881p-7 * z);
  const V middle = (-0x1.a01a019c126f9p-13 + 0x1.71de35787797fp-19 * z);
  const V top = (-0x1.ae5e66d714690p-26 + 0x1.5d932fdabe8d0p-33 * z);
  return low + z2 * (middle + z2 * top);
}
template <class V>
V cosine_polynomial(V z) {
  const V z2 = z * z;
  const V low = (0x1.555555555554cp-5 - 0x1.6c16c16c15184p-10 * z);
  const V middle = (0x1.a01a019cb2704p-16 - 0x1.27e4f80a768c2p-22 * z);
  const V top = (0x1.1ee9ec47728a9p-29 - 0x1.8faecee6be6edp-37 * z);
  return low + z2 * (middle + z2 * top);
}

template <class V>
V kernel_sin(const Reduced<V>& r, V z) {
  return r.high + ((r.high * z) * sine_polynomial(z) + (r.low - 0.5 * z * r.low));
}

template <class V>
V kernel_cos(const Reduced<V>& r, V z) {
  // z/2 is large enough for its rounding to matter, so it is split into an exact square and the rest.
  const V cut = high_part(r.high);
  const V half_square = 0.5 * cut * cut;
  const V rest = 0.5 * (r.high + cut) * (r.high - cut);
  const V base = 1.0 - half_square;
  return base + (((1.0 - base) - half_square) + (z * z * cosine_polynomial(z) - (rest + r.high * r.low)));
}

template <class V>
struct Both {
  V sin, cos;
};

template <class V>
Both<V> kernel_both(const Reduced<V>& r) {
  const V z = r.high * r.high;
  if constexpr (!kComputesLanes && std::is_same_v<V, double>) {
    const V of_sin = kernel_sin(r, z), of_cos = kernel_cos(r, z);
    const bool odd = (r.quadrant & 1) != 0;
    const V sin = odd ? of_cos : of_sin, cos = odd ? of_sin : of_cos;
    return {(r.quadrant & 2) != 0 ? -sin : sin, ((r.quadrant + 1) & 2) != 0 ? -cos : cos};
  }
  const auto s = std::bit_cast<Bits<V>>(kernel_sin(r, z));
  const auto c = std::bit_cast<Bits<V>>(kernel_cos(r, z));
  // Swapped in odd quadrants, by arithmetic, because the branch is not predictable.
  const Bits<V> exchange = (s ^ c) & (0 - (r.quadrant & 1));
  return {std::bit_cast<V>((s ^ exchange) ^ ((r.quadrant >> 1) << 63)),
          std::bit_cast<V>((c ^ exchange) ^ (((r.quadrant + 1) >> 1) << 63))};
}

// Below 2^-27 sin(x) = x and cos(x) = 1; this also keeps the sign of a zero.
bool tiny(double x) {
  return std::fabs(x) < 0x1p-27;
}

bool in_range(double x) {
  return std::fabs(x) <= kLargest;
}

double flip_sign(double v, std::uint64_t condition_bit) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) ^ (condition_bit << 63));
}

double hypot_moderate(double large, double small) {
  const double large_cut = high_part(large);
  const double small_cut = high_part(small);
  const double h = std::sqrt(large * large + small * small);
  // One Newton step from the exact x^2 + y^2 - h^2.
  const double h_cut = high_part(h);
  const double cuts = (large_cut * large_cut - h_cut * h_cut) + small_cut * small_cut;
  const double rests = ((large + large_cut) * (large - large_cut) - (h + h_cut) * (h - h_cut)) +
                       (small + small_cut) * (small - small_cut);
  return h + (cuts + rests) / (2.0 * h);
}

// The start value is accurate enough for the cut to 17 bits: a third of the exponent and of the fraction is off by 4 %
// at most, and each step of Halley's method reduces the relative error to two thirds of its third power.
double rough_cbrt(double x) {
  constexpr std::uint64_t kTwoThirdsOfBias = std::uint64_t{0x2A9F'7893} << 32;
  double t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kTwoThirdsOfBias);
  for (int step = 0; step < 2; ++step) {
    const double cube = t * t * t;
    t *= (cube + 2.0 * x) / (2.0 * cube + x);
  }
  return t;
}

// 0 < x, moderate.
double cbrt_moderate(double x) {
  // 17 bits, so its cube is exact.
  const double t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(rough_cbrt(x)) & 0xFFFF'FFF0'0000'0000u);
  const double cube = t * t * t;
  const double d = (x - cube) / cube;  // below 2^-14
  return t + t * (d * (1.0 / 3.0 + d * (-1.0 / 9.0 + d * (5.0 / 81.0 - d * (10.0 / 243.0)))));
}

}  // namespace

double sin(double x) noexcept {
  if (!in_range(x)) return kNan;
  if (tiny(x)) return x;
  const Reduced<double> r = reduce(x);
  const double z = r.high * r.high;
  return flip_sign((r.quadrant & 1u) != 0 ? kernel_cos(r, z) : kernel_sin(r, z), (r.quadrant >> 1) & 1u);
}

double cos(double x) noexcept {
  if (!in_range(x)) return kNan;
  if (tiny(x)) return 1.0;
  const Reduced<double> r = reduce(x);
  const double z = r.high * r.high;
  return flip_sign((r.quadrant & 1u) != 0 ? kernel_sin(r, z) : kernel_cos(r, z), ((r.quadrant + 1) >> 1) & 1u);
}

SinCos sin_cos(double x) noexcept {
  if (!in_range(x)) return {kNan, kNan};
  if (tiny(x)) return {x, 1.0};
  const auto [sin, cos] = kernel_both(reduce(x));
  return {sin, cos};
}

void sin_cos_each(std::span<const double> x, std::span<SinCos> result) noexcept {
  std::size_t i = 0;
  for (; kComputesLanes && i + 1 < x.size(); i += 2) {
    const Lanes two{x[i], x[i + 1]};
    const Quarters<Lanes> q = quarters(two);
    // False for tiny and for NaN, too.
    if (both((magnitude(two) <= kLargest) & (magnitude(q.first) >= kNearZero))) [[likely]] {
      const auto [sin, cos] = kernel_both(reduce(q));
      result[i] = {sin[0], cos[0]};
      result[i + 1] = {sin[1], cos[1]};
    } else {
      result[i] = sin_cos(x[i]);
      result[i + 1] = sin_cos(x[i + 1]);
    }
  }
  for (; i < x.size(); ++i) result[i] = sin_cos(x[i]);
}

double hypot(double x, double y) noexcept {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const double large = ax > ay ? ax : ay;
  const double small = ax > ay ? ay : ax;
  if (both_moderate(large, small)) [[likely]]
    return hypot_moderate(large, small);
  if (ax == kInfinity || ay == kInfinity) return kInfinity;
  if (std::isnan(x) || std::isnan(y)) return kNan;
  if (small <= large * 0x1p-60) return large;
  // Both within 2^-480 .. 2^424: their squares do not overflow or underflow.
  if (large > 1.0) return hypot_moderate(large * 0x1p-600, small * 0x1p-600) * 0x1p+600;
  return hypot_moderate(large * 0x1p+600, small * 0x1p+600) * 0x1p-600;
}

double cbrt(double x) noexcept {
  const double magnitude = std::fabs(x);
  if (both_moderate(magnitude, magnitude)) [[likely]]
    return with_sign_of(cbrt_moderate(magnitude), x);
  if (!(magnitude > 0.0) || magnitude == kInfinity) return x;
  const bool huge = magnitude > 1.0;
  return with_sign_of(cbrt_moderate(magnitude * (huge ? 0x1p-900 : 0x1p+900)) * (huge ? 0x1p+300 : 0x1p-300), x);
}

}  // namespace armature::math
