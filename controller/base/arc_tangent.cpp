// atan2 and atan2_each of math.hpp. Two angles are computed at once, in the two lanes of a vector, without a branch: a
// branch on the octant or on the size of the tangent is not predictable.
#include <bit>
#include <cmath>
#include <cstdint>

#include "controller/base/arc_tangents.hpp"
#include "controller/base/double_bits.hpp"
#include "controller/base/lanes.hpp"
#include "controller/base/math.hpp"

namespace armature::math {
namespace {

constexpr double kPiHigh = 0x1.921fb54442d18p+1;
constexpr double kPiLow = 0x1.1a62633145c07p-53;

struct LanePairs {
  Lanes high, low;  // their sum
};

// The ratio small / large, with the parts of the operands that make products exact.
struct Quotient {
  Lanes small, large, large_cut, large_rest, inverse, ratio;
};

// For ratios below 1/8: the quotient as two doubles, then the odd polynomial: (atan(q)/q - 1)/z to 2^-58.
LanePairs angle_near_zero(const Quotient& v) {
  const Lanes q = high_part(v.ratio);
  const Lanes q_rest = ((v.small - q * v.large_cut) - q * v.large_rest) * v.inverse;
  const Lanes z = v.ratio * v.ratio;
  const Lanes z2 = z * z;
  const Lanes p = (-0x1.55555555554ccp-2 + 0x1.9999999945f4ap-3 * z) +
                  z2 * ((-0x1.2492489cddb22p-3 + 0x1.c71ba72945a63p-4 * z) +
                        z2 * (-0x1.74107a16533d4p-4 + 0x1.2cc20ade145fep-4 * z));
  return {q, q_rest + v.ratio * z * p};
}

TwoDoubles breakpoint(std::int64_t bits) {
  // Ratios below 1/8 have no breakpoint: any will do, because their result is not used.
  const auto k = static_cast<std::size_t>(bits & 0x7F);
  return kArcTangents[k > kFirstBreakpoint ? k - kFirstBreakpoint : 0];
}

// For the others: atan(q) = atan(c) + atan((q - c)/(1 + q c)) with the nearest c = k/64.
LanePairs angle_near_breakpoint(const Quotient& v) {
  const Lanes shifted = v.ratio * 64.0 + kToInteger;
  const Lanes c = (shifted - kToInteger) * 0x1p-6;
  const Masks k = bits_of(shifted);
  const TwoDoubles first = breakpoint(k[0]), second = breakpoint(k[1]);
  const Lanes numerator = (v.small - c * v.large_cut) - c * v.large_rest;  // exact except for the last difference
  const Lanes t = numerator / (v.large + c * v.small);
  const Lanes z = t * t;
  const Lanes p = -0x1.55555555554fcp-2 + z * (0x1.99999988ff01cp-3 - z * 0x1.248b4ae31b86ep-3);  // |t| < 1/120
  return {Lanes{first.high, second.high}, Lanes{first.low, second.low} + (t + t * z * p)};
}

// From the angle in the first octant to that of the point, by reflection at the diagonal and at the axes. All numbers
// are moderate.
inline Lanes atan2_moderate(Lanes y, Lanes x) {
  const Masks sign = all_lanes(kSignBit);
  const Lanes ax = magnitude(x);
  const Lanes ay = magnitude(y);
  const Masks steep = ay > ax;
  const Masks left = bits_of(x) >> 63;

  Quotient v{};
  v.small = select(steep, ax, ay);
  v.large = select(steep, ay, ax);
  v.large_cut = high_part(v.large);
  v.large_rest = v.large - v.large_cut;
  v.inverse = 1.0 / v.large;
  v.ratio = v.small * v.inverse;
  const LanePairs zero = angle_near_zero(v), other = angle_near_breakpoint(v);
  const Masks near_zero = v.ratio < 0.125;

  // steep: pi/2 -+ octant, left: pi - octant.
  const Masks minus = (steep ^ left) & sign;
  const Lanes high = flip_signs(select(near_zero, zero.high, other.high), minus);
  const Lanes low = flip_signs(select(near_zero, zero.low, other.low), minus);
  const Lanes turns = select(steep, Lanes{} + 0.5, masked(Lanes{} + 1.0, left));
  const Lanes base = turns * kPiHigh;
  const Lanes sum = base + high;
  const Lanes rest = (base - sum) + high;
  const Lanes angle = sum + (rest + (turns * kPiLow + low));
  return std::bit_cast<Lanes>(bits_of(angle) | (bits_of(y) & sign));
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
  const double scaled_y = y * scale, scaled_x = x * scale;
  return atan2_moderate(Lanes{scaled_y, scaled_y}, Lanes{scaled_x, scaled_x})[0];
}

}  // namespace

double atan2(double y, double x) noexcept {
  if (both_moderate(x, y)) [[likely]]
    return atan2_moderate(Lanes{y, y}, Lanes{x, x})[0];
  return atan2_rare(y, x);
}

void atan2_each(std::span<const double> y, std::span<const double> x, std::span<double> angle) noexcept {
  std::size_t i = 0;
  for (; i + 1 < angle.size(); i += 2) {
    if (both_moderate(x[i], y[i]) && both_moderate(x[i + 1], y[i + 1])) [[likely]] {
      const Lanes two = atan2_moderate(Lanes{y[i], y[i + 1]}, Lanes{x[i], x[i + 1]});
      angle[i] = two[0];
      angle[i + 1] = two[1];
    } else {
      angle[i] = atan2(y[i], x[i]);
      angle[i + 1] = atan2(y[i + 1], x[i + 1]);
    }
  }
  if (i < angle.size()) angle[i] = atan2(y[i], x[i]);
}

}  // namespace armature::math
