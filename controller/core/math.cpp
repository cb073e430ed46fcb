#include "controller/core/math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "controller/core/arc_tangents.hpp"

// Every result is rounded once from a sum of two doubles, high + low; the low part contains what the earlier operations
// lost. Without FMA a product is exact only when its factors are short enough, so numbers are split into a short high
// part and the rest. All of it requires rounding to nearest, ties to even, the default of IEEE 754.

namespace armature::math {
namespace {

constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Added to |v| < 2^51 it leaves the nearest integer in the low bits; subtracting it again gives that integer.
constexpr double kToInteger = 0x1.8p52;

// Keeps 26 significant bits: the product of two such parts, or of one such part and its rest, is exact.
double high_part(double v) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) & 0xFFFF'FFFF'F800'0000u);
}

double with_sign_of(double magnitude, double sign) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) |
                               (std::bit_cast<std::uint64_t>(sign) & kSignBit));
}

// True when both magnitudes are within 2^-240 .. 2^241: then no square, product or rest leaves the normal numbers.
// False for zeros, infinities and NaNs.
bool both_moderate(double x, double y) {
  const auto moderate = [](double v) {
    return ((std::bit_cast<std::uint64_t>(v) >> 52) & 0x7FFu) - (1023 - 240) <= 480;
  };
  return moderate(x) && moderate(y);
}

// pi/2 = the sum of the four. The first three have at most 33 bits: their products with an integer below 2^20 are
// exact.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2ep-69;
constexpr double kHalfPi4 = 0x1.b839a252049c1p-104;
constexpr double kHalfPi34 = 0x1.3198a2e037073p-69;  // the last two as one

constexpr double kPiHigh = 0x1.921fb54442d18p+1;
constexpr double kPiLow = 0x1.1a62633145c07p-53;

// x = (quadrant) pi/2 + high + low, |high| <= pi/4 except for rounding.
struct Reduced {
  double high;
  double low;
  std::uint64_t quadrant;  // its last two bits
};

// For arguments near a zero of sine or cosine, where the first subtractions cancel all but the last bits of x.
Reduced reduce_near_zero(double x, double n, std::uint64_t quadrant) {
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
Reduced reduce(double x) {
  constexpr double kTwoByPi = 0x1.45f306dc9c883p-1;
  const double shifted = x * kTwoByPi + kToInteger;
  const double n = shifted - kToInteger;
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const double first = x - n * kHalfPi1;  // exact: a multiple of 2^-53 below 1
  if (std::fabs(first) < 0x1p-13) [[unlikely]]
    return reduce_near_zero(x, n, quadrant);
  const double second = n * kHalfPi2;
  const double sum = first - second;
  const double low = ((first - sum) - second) - n * kHalfPi34;
  const double high = sum + low;
  return {high, (sum - high) + low, quadrant};
}

// Minimax polynomials in z = x^2 on |x| <= pi/4: (sin(x)/x - 1)/z to 2^-57 and (cos(x) - 1 + z/2)/z^2 to 2^-59 of 1.
double sine_polynomial(double z) {
  const double z2 = z * z;
  const double low = (-0x1.5555555555549p-3 + 0x1.111111110f881p-7 * z);
  const double middle = (-0x1.a01a019c126f9p-13 + 0x1.71de35787797fp-19 * z);
  const double top = (-0x1.ae5e66d714690p-26 + 0x1.5d932fdabe8d0p-33 * z);
  return low + z2 * (middle + z2 * top);
}
double cosine_polynomial(double z) {
  const double z2 = z * z;
  const double low = (0x1.555555555554cp-5 - 0x1.6c16c16c15184p-10 * z);
  const double middle = (0x1.a01a019cb2704p-16 - 0x1.27e4f80a768c2p-22 * z);
  const double top = (0x1.1ee9ec47728a9p-29 - 0x1.8faecee6be6edp-37 * z);
  return low + z2 * (middle + z2 * top);
}

double kernel_sin(const Reduced& r, double z) {
  return r.high + ((r.high * z) * sine_polynomial(z) + (r.low - 0.5 * z * r.low));
}

double kernel_cos(const Reduced& r, double z) {
  // z/2 is large enough for its rounding to matter, so it is split into an exact square and the rest.
  const double cut = high_part(r.high);
  const double half_square = 0.5 * cut * cut;
  const double rest = 0.5 * (r.high + cut) * (r.high - cut);
  const double base = 1.0 - half_square;
  return base + (((1.0 - base) - half_square) + (z * z * cosine_polynomial(z) - (rest + r.high * r.low)));
}

// Below 2^-27 sin(x) = x and cos(x) = 1; this also keeps the sign of a zero.
bool tiny(double x) {
  return std::fabs(x) < 0x1p-27;
}

bool in_range(double x) {
  return std::fabs(x) <= 1e6;
}

double flip_sign(double v, std::uint64_t condition_bit) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) ^ (condition_bit << 63));
}

// The angle whose tangent is small/large, as two doubles. 0 < small <= large, both moderate.
TwoDoubles octant_angle(double small, double large) {
  const double inverse = 1.0 / large;
  const double ratio = small * inverse;
  if (ratio < 0.125) {
    // The quotient as two doubles, then the odd polynomial: (atan(q)/q - 1)/z to 2^-58.
    const double q = high_part(ratio);
    const double large_cut = high_part(large);
    const double q_rest = ((small - q * large_cut) - q * (large - large_cut)) * inverse;
    const double z = ratio * ratio;
    const double z2 = z * z;
    const double p = (-0x1.55555555554ccp-2 + 0x1.9999999945f4ap-3 * z) +
                     z2 * ((-0x1.2492489cddb22p-3 + 0x1.c71ba72945a63p-4 * z) +
                           z2 * (-0x1.74107a16533d4p-4 + 0x1.2cc20ade145fep-4 * z));
    return {q, q_rest + ratio * z * p};
  }
  // atan(q) = atan(c) + atan((q - c)/(1 + q c)) with the nearest c = k/64.
  const double shifted = ratio * 64.0 + kToInteger;
  const double c = (shifted - kToInteger) * 0x1p-6;
  const TwoDoubles& base = kArcTangents[(std::bit_cast<std::uint64_t>(shifted) & 0x7Fu) - kFirstBreakpoint];
  const double large_cut = high_part(large);
  const double numerator = (small - c * large_cut) - c * (large - large_cut);  // exact except for the last difference
  const double t = numerator / (large + c * small);
  const double z = t * t;
  const double p = -0x1.55555555554fcp-2 + z * (0x1.99999988ff01cp-3 - z * 0x1.248b4ae31b86ep-3);  // |t| < 1/120
  return {base.high, base.low + (t + t * z * p)};
}

// From the angle in the first octant to that of the point, by reflection at the diagonal and at the axes.
double atan2_moderate(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const bool steep = ay > ax;
  const bool left = std::signbit(x);
  const TwoDoubles octant = steep ? octant_angle(ax, ay) : octant_angle(ay, ax);
  // steep: pi/2 -+ octant, left: pi - octant.
  const double turns = steep ? 0.5 : left ? 1.0 : 0.0;
  const std::uint64_t minus = static_cast<std::uint64_t>(steep != left);
  const double high = flip_sign(octant.high, minus);
  const double low = flip_sign(octant.low, minus);
  const double base = turns * kPiHigh;
  const double sum = base + high;
  const double rest = (base - sum) + high;
  const double angle = sum + (rest + (turns * kPiLow + low));
  return with_sign_of(angle, y);
}

// For zeros, infinities, NaNs, and numbers too large or too small for the exact products.
double atan2_rare(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const bool left = std::signbit(x);
  if (ay == 0.0) return with_sign_of(left ? kPiHigh : 0.0, y);
  if (ax == 0.0) return with_sign_of(0.5 * kPiHigh, y);
  if (ax == kInfinity && ay == kInfinity) return with_sign_of(left ? 0.75 * kPiHigh : 0.25 * kPiHigh, y);
  // Here the tangent equals the angle to double precision.
  if (ax == kInfinity || ay < ax * 0x1p-60) return with_sign_of(left ? kPiHigh : ay / ax, y);
  if (ay == kInfinity || ax < ay * 0x1p-60) return with_sign_of(0.5 * kPiHigh, y);
  // Now within 2^-480 .. 2^424: no overflow or underflow below.
  const double scale = ax > 1.0 ? 0x1p-600 : 0x1p+600;
  return atan2_moderate(y * scale, x * scale);
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
  const Reduced r = reduce(x);
  const double z = r.high * r.high;
  return flip_sign((r.quadrant & 1u) != 0 ? kernel_cos(r, z) : kernel_sin(r, z), (r.quadrant >> 1) & 1u);
}

double cos(double x) noexcept {
  if (!in_range(x)) return kNan;
  if (tiny(x)) return 1.0;
  const Reduced r = reduce(x);
  const double z = r.high * r.high;
  return flip_sign((r.quadrant & 1u) != 0 ? kernel_sin(r, z) : kernel_cos(r, z), ((r.quadrant + 1) >> 1) & 1u);
}

SinCos sin_cos(double x) noexcept {
  if (!in_range(x)) return {kNan, kNan};
  if (tiny(x)) return {x, 1.0};
  const Reduced r = reduce(x);
  const double z = r.high * r.high;
  const auto s = std::bit_cast<std::uint64_t>(kernel_sin(r, z));
  const auto c = std::bit_cast<std::uint64_t>(kernel_cos(r, z));
  // Swapped in odd quadrants, by arithmetic, because the branch is not predictable.
  const std::uint64_t exchange = (s ^ c) & (0 - (r.quadrant & 1u));
  return {std::bit_cast<double>((s ^ exchange) ^ ((r.quadrant >> 1) << 63)),
          std::bit_cast<double>((c ^ exchange) ^ (((r.quadrant + 1) >> 1) << 63))};
}

double atan2(double y, double x) noexcept {
  if (both_moderate(x, y)) [[likely]]
    return atan2_moderate(y, x);
  return atan2_rare(y, x);
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
