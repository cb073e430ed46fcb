// atan2 and atan2_each of math.hpp. Where the processor can, two angles are computed at once, in the two lanes of a
// vector, without a branch: a branch on the octant or on the size of the tangent is not predictable.
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

// V: double, or Lanes for two angles at once.
template <class V>
struct Pair {
  V high, low;  // their sum
};

// The ratio small / large, with the parts of the operands that make products exact.
template <class V>
struct Quotient {
  V small, large, large_cut, large_rest, inverse, ratio;

  Quotient(V of_small, V of_large)
      : small{of_small},
        large{of_large},
        large_cut{high_part(large)},
        large_rest{large - large_cut},
        inverse{1.0 / large},
        ratio{small * inverse} {}
};

// The others have a breakpoint.
constexpr double kSmallRatio = 0.125;

// For ratios below 1/8: the quotient as two doubles, then the odd polynomial: (atan(q)/q - 1)/z to 2^-58.
template <class V>
Pair<V> angle_near_zero(const Quotient<V>& v) {
  const V q = high_part(v.ratio);
  const V q_rest = ((v.small - q * v.large_cut) - q * v.large_rest) * v.inverse;
  const V z = v.ratio * v.ratio;
  const V z2 = z * z;
  const V p = (-0x1.55555555554ccp-2 + 0x1.9999999945f4ap-3 * z) +
              z2 * ((-0x1.2492489cddb22p-3 + 0x1.c71ba72945a63p-4 * z) +
                    z2 * (-0x1.74107a16533d4p-4 + 0x1.2cc20ade145fep-4 * z));
  return {q, q_rest + v.ratio * z * p};
}

template <class Bits>
TwoDoubles breakpoint(Bits bits) {
  // Ratios below 1/8 have no breakpoint: any will do, because their result is not used.
  const auto k = static_cast<std::size_t>(bits & 0x7F);
  return kArcTangents[k > kFirstBreakpoint ? k - kFirstBreakpoint : 0];
}
Pair<double> breakpoints(double shifted) {
  const TwoDoubles one = breakpoint(std::bit_cast<std::uint64_t>(shifted));
  return {one.high, one.low};
}
Pair<Lanes> breakpoints(Lanes shifted) {
  const Masks k = bits_of(shifted);
  const TwoDoubles first = breakpoint(k[0]), second = breakpoint(k[1]);
  return {Lanes{first.high, second.high}, Lanes{first.low, second.low}};
}

// For the others: atan(q) = atan(c) + atan((q - c)/(1 + q c)) with the nearest c = k/64.
template <class V>
Pair<V> angle_near_breakpoint(const Quotient<V>& v) {
  const V shifted = v.ratio * 64.0 + kToInteger;
  const V c = (shifted - kToInteger) * 0x1p-6;
  const Pair<V> at_c = breakpoints(shifted);
  const V numerator = (v.small - c * v.large_cut) - c * v.large_rest;  // exact except for the last difference
  const V t = numerator / (v.large + c * v.small);
  const V z = t * t;
  const V p = -0x1.55555555554fcp-2 + z * (0x1.99999988ff01cp-3 - z * 0x1.248b4ae31b86ep-3);  // |t| < 1/120
  return {at_c.high, at_c.low + (t + t * z * p)};
}

// The angle of the first octant after reflection, `turns` halves of pi away.
template <class V>
V reflected(const Pair<V>& octant, V turns) {
  const V base = turns * kPiHigh;
  const V sum = base + octant.high;
  const V rest = (base - sum) + octant.high;
  return sum + (rest + (turns * kPiLow + octant.low));
}

// From the angle in the first octant to that of the point, by reflection at the diagonal and at the axes. All numbers
// are moderate.
inline Lanes atan2_moderate(Lanes y, Lanes x) {
  const Masks sign = all_lanes(kSignBit);
  const Lanes ax = magnitude(x);
  const Lanes ay = magnitude(y);
  const Masks steep = ay > ax;
  const Masks left = bits_of(x) >> 63;

  const Quotient<Lanes> v{select(steep, ax, ay), select(steep, ay, ax)};
  const Pair<Lanes> zero = angle_near_zero(v), other = angle_near_breakpoint(v);
  const Masks near_zero = v.ratio < kSmallRatio;

  // steep: pi/2 -+ octant, left: pi - octant.
  const Masks minus = (steep ^ left) & sign;
  const Pair<Lanes> octant{flip_signs(select(near_zero, zero.high, other.high), minus),
                           flip_signs(select(near_zero, zero.low, other.low), minus)};
  const Lanes turns = select(steep, Lanes{} + 0.5, masked(Lanes{} + 1.0, left));
  return std::bit_cast<Lanes>(bits_of(reflected(octant, turns)) | (bits_of(y) & sign));
}

// The same for one angle, with branches.
double atan2_moderate(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  const bool steep = ay > ax, left = x < 0.0;
  const Quotient<double> v{steep ? ax : ay, steep ? ay : ax};
  Pair<double> octant = v.ratio < kSmallRatio ? angle_near_zero(v) : angle_near_breakpoint(v);
  if (steep != left) octant = {-octant.high, -octant.low};
  return with_sign_of(reflected(octant, steep ? 0.5 : left ? 1.0 : 0.0), y);
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
  return atan2_moderate(scaled_y, scaled_x);
}

}  // namespace

double atan2(double y, double x) noexcept {
  if (both_moderate(x, y)) [[likely]]
    return atan2_moderate(y, x);
  return atan2_rare(y, x);
}

void atan2_each(std::span<const double> y, std::span<const double> x, std::span<double> angle) noexcept {
  std::size_t i = 0;
  for (; kComputesLanes && i + 1 < angle.size(); i += 2) {
    if (both_moderate(x[i], y[i]) && both_moderate(x[i + 1], y[i + 1])) [[likely]] {
      const Lanes two = atan2_moderate(Lanes{y[i], y[i + 1]}, Lanes{x[i], x[i + 1]});
      angle[i] = two[0];
      angle[i + 1] = two[1];
    } else {
      angle[i] = atan2(y[i], x[i]);
      angle[i + 1] = atan2(y[i + 1], x[i + 1]);
    }
  }
  for (; i < angle.size(); ++i) angle[i] = atan2(y[i], x[i]);
}

}  // namespace armature::math
