#include "controller/trajectory/law/law_limits.hpp"

#include <algorithm>
#include <cmath>

namespace armature {

double largest_square(const LawLimits& limits) noexcept {
  double most = limits.most_square;
  for (const LawLimits::Band& band : limits.bands) {
    if (band.by_accel == 0.0 && band.by_square != 0.0) most = std::min(most, 1.0 / std::fabs(band.by_square));
  }
  for (const LawLimits::Ellipse& e : limits.ellipses) {
    // The part of d that u cannot cancel: d.d - (c.d)^2 / c.c.
    const double left = e.accel2 > 0.0 ? e.square2 - e.mixed * (e.mixed / e.accel2) : e.square2;
    if (left > 0.0) most = std::min(most, 1.0 / std::sqrt(left));
  }
  return most;
}

LawLimits between(const LawLimits& first, const LawLimits& second, double share) noexcept {
  const auto mix = [share](double a, double b) { return (1.0 - share) * a + share * b; };
  LawLimits result;
  for (std::size_t i = 0; i < result.bands.size(); ++i) {
    const LawLimits::Band &a = first.bands[i], &b = second.bands[i];
    result.bands[i] = {mix(a.by_accel, b.by_accel), mix(a.by_square, b.by_square)};
  }
  for (std::size_t i = 0; i < result.ellipses.size(); ++i) {
    const LawLimits::Ellipse &a = first.ellipses[i], &b = second.ellipses[i];
    result.ellipses[i] = {mix(a.accel2, b.accel2), mix(a.mixed, b.mixed), mix(a.square2, b.square2)};
  }
  result.most_square = mix(first.most_square, second.most_square);
  result.jerk = {mix(first.jerk.by_change, second.jerk.by_change), mix(first.jerk.by_both, second.jerk.by_both),
                 mix(first.jerk.by_speed, second.jerk.by_speed),
                 mix(first.jerk.usual_square, second.jerk.usual_square)};
  return result;
}

void limit_jerk(LawLimits& limits, double tau_s) noexcept {
  const LawLimits::Jerk& jerk = limits.jerk;
  LawLimits::Band* bands = limits.bands.data() + kAxes;
  bands[0] = {jerk.by_change / tau_s, jerk.by_speed};
  bands[1] = {jerk.by_change / tau_s, -jerk.by_speed};
  bands[2] = bands[3] = {};
  // u <= f(x) with f = 1 / (by_both sqrt(x)); a tangent of f is below it.
  if (!(jerk.by_both > 0.0) || !(jerk.usual_square > 0.0)) return;
  const double at_usual = 1.0 / (jerk.by_both * std::sqrt(jerk.usual_square));
  bands[2] = {1.0 / (1.5 * at_usual), 1.0 / (3.0 * jerk.usual_square)};
  bands[3] = {bands[2].by_accel, -bands[2].by_square};
}

void free_jerk(LawLimits& limits) noexcept {
  std::fill(limits.bands.begin() + kAxes, limits.bands.end(), LawLimits::Band{});
  limits.jerk.usual_square = -std::numeric_limits<double>::infinity();
}

void slow_down(LawLimits& limits, double share) noexcept {
  const double k2 = share * share;
  for (LawLimits::Band& band : limits.bands) {
    band.by_accel /= k2;
    band.by_square /= k2;
  }
  for (LawLimits::Ellipse& e : limits.ellipses) {
    e.accel2 /= k2 * k2;
    e.mixed /= k2 * k2;
    e.square2 /= k2 * k2;
  }
  limits.most_square *= k2;
}

}  // namespace armature
