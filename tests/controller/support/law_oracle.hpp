// The shortest time of a motion along a path, computed on a fine uniform grid in long double, by bisection: the bound
// with which the laws of the controller are compared. Shares no code with them except the description of limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/trajectory/law/law_limits.hpp"

namespace armature::test {

struct OracleRange {
  long double low, high;
  [[nodiscard]] bool empty() const { return low > high; }
};

// The part of a jerk at a right angle to the path, as a share of its limit: |both sqrt(x) u + speed sqrt(x^3)|^2, with
// the squares and the product of the two vectors. It does not depend on the third derivative of the parameter.
struct JerkAcross {
  long double both2 = 0.0L, mixed = 0.0L, speed2 = 0.0L;
};

// The accelerations that one point permits at the squared speed x.
inline OracleRange oracle_accelerations(const LawLimits& limits, long double x, const JerkAcross& jerk = {}) {
  OracleRange range{-1e30L, 1e30L};
  const OracleRange none{1.0L, -1.0L};
  if (x > static_cast<long double>(limits.most_square)) return none;
  const auto meet = [&range](long double a, long double b) {
    range.low = std::max(range.low, std::min(a, b));
    range.high = std::min(range.high, std::max(a, b));
  };
  for (const LawLimits::Band& band : limits.bands) {
    const long double u = band.by_accel, rest = band.by_square * x;
    if (u != 0.0L) meet((1.0L - rest) / u, (-1.0L - rest) / u);
    if (u == 0.0L && std::fabs(rest) > 1.0L) return none;
  }
  // a u^2 + 2 b u + c <= 0
  const auto meet_ellipse = [&meet](long double a, long double b, long double c) {
    if (a == 0.0L) return c <= 0.0L;
    const long double discriminant = b * b - a * c;
    if (discriminant < 0.0L) return false;
    const long double root = std::sqrt(discriminant);
    meet((-b - root) / a, (-b + root) / a);
    return true;
  };
  for (const LawLimits::Ellipse& e : limits.ellipses) {
    if (!meet_ellipse(e.accel2, e.mixed * x, e.square2 * x * x - 1.0L)) return none;
  }
  if (!meet_ellipse(jerk.both2 * x, jerk.mixed * x * x, jerk.speed2 * x * x * x - 1.0L)) return none;
  return range;
}

// Duration from rest to rest over a path with these limits at equally spaced points, `step` apart; `jerk` is empty or
// of the same size.
inline long double least_duration_s(const std::vector<LawLimits>& limits, long double step,
                                    const std::vector<JerkAcross>& jerk = {}) {
  // With a jerk a point may permit a high speed but not a lower one, so the search begins at the highest.
  constexpr int kSpeeds = 100;
  const auto accelerations = [&](std::size_t i, long double x) {
    return oracle_accelerations(limits[i], x, jerk.empty() ? JerkAcross{} : jerk[i]);
  };
  std::vector<long double> most(limits.size(), 0.0L);
  for (std::size_t i = limits.size() - 1; i-- > 0;) {
    const auto brakes_in_time = [&](long double x) {
      const OracleRange u = accelerations(i, x);
      return !u.empty() && x + 2.0L * step * u.low <= most[i + 1];
    };
    long double low = 0.0L, high = limits[i].most_square;
    if (brakes_in_time(high)) low = high;
    const long double top = high;
    for (int k = kSpeeds - 1; !jerk.empty() && low == 0.0L && k > 0; --k) {
      const long double share = static_cast<long double>(k) / kSpeeds, x = top * share * share;
      (brakes_in_time(x) ? low : high) = x;
    }
    for (int halving = 0; halving < 64 && low < high; ++halving) {
      const long double middle = 0.5L * (low + high);
      (brakes_in_time(middle) ? low : high) = middle;
    }
    most[i] = low;
  }
  long double x = 0.0L, duration_s = 0.0L;
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    const OracleRange u = accelerations(i, x);
    const long double next = u.empty() ? most[i + 1] : std::clamp(x + 2.0L * step * u.high, 0.0L, most[i + 1]);
    duration_s += 2.0L * step / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  return duration_s;
}

// Largest share of any limit at this point that a motion with (u, x) uses.
inline double oracle_share(const LawLimits& limits, double u, double x) {
  double most = x / limits.most_square;
  for (const LawLimits::Band& band : limits.bands)
    most = std::max(most, std::fabs(band.by_accel * u + band.by_square * x));
  for (const LawLimits::Ellipse& e : limits.ellipses) {
    most = std::max(most, std::sqrt(std::max(0.0, e.accel2 * u * u + 2.0 * e.mixed * u * x + e.square2 * x * x)));
  }
  return most;
}

}  // namespace armature::test
