// Under limits of speed, acceleration and jerk.
//
// Everything here is in units in which the limits of acceleration and jerk are 1: times in A/J, speeds in A^2/J,
// distances in A^3/J^2. The motion that goes as far as possible has up to seven phases, of the jerks
//
//   +1  until the acceleration is `rise` (between -1 and 1)
//    0  for hold_s, only with rise = 1
//   -1  until the acceleration is 0, cruise at the limit of the speed
//   -1  (without a cruise one phase with that before) until the acceleration is -fall
//    0  for brake_s, only with fall = 1
//   +1  to rest.
//
// Two quantities describe it. The start (v, a) lies on a parabola of jerk +1 that passes an acceleration of 0 with the
// speed c = v - a^2 / 2. The parabola of jerk -1 after the rise passes it with the speed w = c + rise^2 + hold_s. Where
// rise < 0 the axis itself is only on the other side of these points. From w, braking to rest covers
// S(w) = w^1.5 with fall = sqrt(w), or for w > 1 (w^2 + w) / 2 with fall = 1.
#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/trajectory/state/reach_rules.hpp"

namespace armature {
namespace {

struct UnitsOfLimits {
  double time, speed, length;

  explicit UnitsOfLimits(const TimeLawLimits& limits)
      : time{limits.accel / limits.jerk}, speed{limits.accel * time}, length{speed * time} {}
};

struct SCurveShape {
  double rise = 0.0;
  double hold = 0.0;
  double cruise = 0.0;
  double fall = 0.0;
  double brake = 0.0;

  [[nodiscard]] double duration(double start_accel) const {
    return 2.0 * (rise + fall) - start_accel + hold + cruise + brake;
  }
};

SCurveShape with_hold(double hold, double w) {
  return {
      .rise = 1.0, .hold = std::max(hold, 0.0), .fall = std::min(std::sqrt(w), 1.0), .brake = std::max(w - 1.0, 0.0)};
}

SCurveShape without_hold(double rise, double w) {
  return {.rise = rise, .fall = std::min(std::sqrt(std::max(w, 0.0)), 1.0), .brake = std::max(w - 1.0, 0.0)};
}

// Without a cruise, the peak speed is the limit.
SCurveShape up_to_limit(double c, double speed) {
  const double squares = std::max(speed - c, 0.0);
  return squares > 1.0 ? with_hold(squares - 1.0, speed) : without_hold(std::sqrt(squares), speed);
}

double braking_distance(double w) {
  return w > 1.0 ? 0.5 * (w * w + w) : w * std::sqrt(w);
}

// The distance of up_to_limit() from the point where the parabola of the start passes an acceleration of 0.
double distance_up_to_limit(double c, double speed) {
  const double squares = std::max(speed - c, 0.0);
  if (squares > 1.0) {
    return 0.5 * (speed * speed + speed - (c + 1.0) * (c + 2.0)) + 2.0 * c + 1.0 + braking_distance(speed);
  }
  return (2.0 * c + squares) * std::sqrt(squares) + braking_distance(speed);
}

// Newton's method on a convex function, from above its root: it approaches the root from that side. So it has ended
// when a step does not decrease x. The starts are within a small factor of the root.
template <class Step>
double newton_from_above(double x, Step step) {
  constexpr int kMaxSteps = 24;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double next = x - step(x);
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

// rise and fall without hold and brake, from their sum s and their product: rise^2 - fall^2 = -c.
SCurveShape from_sum(double s, double c) {
  const double difference = s > 0.0 ? c / s : 0.0;  // fall - rise
  return {.rise = 0.5 * (s - difference), .fall = std::max(0.5 * (s + difference), 0.0)};
}

// The distance is e = s^3/4 + c s - c^2/(4 s), so s^4 + 4 c s^2 - 4 e s - c^2 = 0.
SCurveShape without_hold_and_brake(double e, double c) {
  if (c < 0.0) {
    // With sigma = sqrt(-c), s = sigma + u: u^2 (u^2 + 4 sigma u + 2 sigma^2) = 4 excess (sigma + u).
    const double sigma = std::sqrt(-c), excess = std::max(e + sigma * sigma * sigma, 0.0);
    if (excess == 0.0) return {.rise = sigma};
    const double above = std::min(math::cbrt(4.0 * excess), std::sqrt(2.0 * excess / sigma));
    const double u = newton_from_above(above, [&](double x) {
      const double value = x * x * (x * (x + 4.0 * sigma) + 2.0 * sigma * sigma) - 4.0 * excess * (sigma + x);
      return value / (4.0 * (x * (x * (x + 3.0 * sigma) + sigma * sigma) - excess));
    });
    return {.rise = sigma + 0.5 * u * u / (sigma + u), .fall = 0.5 * u * (u + 2.0 * sigma) / (sigma + u)};
  }
  // Both bounds follow from leaving out a positive term; 2.0582 = 1 / 0.48587, the root for c = 1, e = 0.
  const double root = std::sqrt(e * e + c * c * c);
  double above = 0.0;
  if (e <= 0.0) {
    if (root == 0.0) return {};
    above = 0.5 * c * c / (root - e);
  } else {
    above = math::cbrt(4.0 * e + 2.0582 * c * std::sqrt(c));
    if (c > 0.0) above = std::min(above, 0.5 * (e + root) / c);
  }
  const double s = newton_from_above(above, [&](double x) {
    const double value = x * (x * (x * x + 4.0 * c) - 4.0 * e) - c * c;
    return value / (4.0 * (x * (x * x + 2.0 * c) - e));
  });
  return from_sum(s, c);
}

// With b = rise + 1: b^2 ((b - 1)^2 + 2 c) = 2 e + c - c^2. `most` is the largest b in question, and (b - 1)^2 >=
// least.
SCurveShape with_brake(double e, double c, double most, double least) {
  const double value = std::max(2.0 * e + c - c * c, 0.0);
  double b = std::min(most, std::sqrt(value / (least + 2.0 * c)));
  if (b > 0.0) {
    b = newton_from_above(b, [&](double x) {
      return (x * x * ((x - 1.0) * (x - 1.0) + 2.0 * c) - value) / (2.0 * x * (x * (2.0 * x - 3.0) + 1.0 + 2.0 * c));
    });
  }
  const double rise = b - 1.0;
  return without_hold(rise, std::max(c + rise * rise, 1.0));
}

// The fastest shape to the distance `e` from the point of the parabola.
SCurveShape fastest(double e, double c, double speed) {
  const double beyond = e - distance_up_to_limit(c, speed);
  if (beyond >= 0.0) {
    SCurveShape shape = up_to_limit(c, speed);
    shape.cruise = beyond / speed;
    return shape;
  }
  // With a hold: w^2 + w = r with a brake; (w + sqrt(w))^2 = 2 r without.
  const double r = std::max(e + 0.5 * (c * c - c), 0.0);
  const double w = 2.0 * r / (1.0 + std::sqrt(1.0 + 4.0 * r));
  if (w >= 1.0 && w - c >= 1.0) return with_hold(w - c - 1.0, w);
  const double square = std::sqrt(2.0 * r), fall = 2.0 * square / (1.0 + std::sqrt(1.0 + 4.0 * square));
  if (c <= -1.0 || (fall < 1.0 && fall * fall - c >= 1.0)) return with_hold(fall * fall - c - 1.0, fall * fall);
  if (c >= 1.0) return with_brake(e, c, 2.0, 0.0);
  if (c > 0.0) {
    const double least_rise = std::sqrt(1.0 - c), cubes = (1.0 + c) * least_rise;  // where w = 1
    if (e > 1.0 + cubes) return with_brake(e, c, 2.0, 1.0 - c);
    if (e < 1.0 - cubes) return with_brake(e, c, 1.0 - least_rise, 1.0 - c);
  }
  return without_hold_and_brake(e, c);
}

// The shape of this duration; `m` is the duration plus the acceleration of the start.
SCurveShape of_duration(double m, double c) {
  const double w = 0.5 * (m + c) - 1.0;
  if (w >= 1.0 && w - c >= 1.0) return with_hold(w - c - 1.0, w);
  const double fall = std::sqrt(std::max(m + c, 0.0)) - 1.0;
  if (c <= -1.0 || (fall >= 0.0 && fall < 1.0 && fall * fall - c >= 1.0)) {
    const double at_least_0 = std::max(fall, 0.0);
    return with_hold(at_least_0 * at_least_0 - c - 1.0, at_least_0 * at_least_0);
  }
  const SCurveShape shape = from_sum(0.5 * m, c);
  if (shape.fall <= 1.0) return shape;
  const double rise = std::sqrt(std::max(m - c, 0.0)) - 1.0;
  return without_hold(rise, std::max(c + rise * rise, 1.0));
}

// Phases of the jerk `first`, 0, -first that change the velocity by `w` from an acceleration of 0; `accel` is the
// acceleration now, on the first of them.
void add_ramp(Phases& phases, double w, double accel, double sign, const TimeLawLimits& limits, double time) {
  const double peak = std::min(std::sqrt(w), 1.0);
  phases.add((peak - sign * accel) * time, accel * limits.accel, sign * limits.jerk);
  phases.add((w - 1.0) * time, sign * limits.accel, 0.0);
  phases.add(peak * time, sign * peak * limits.accel, -sign * limits.jerk);
}

Phases scurve_ramp(const AxisState& start, double velocity, const TimeLawLimits& limits) noexcept {
  const UnitsOfLimits units{limits};
  const double a = start.accel / limits.accel, v = (start.velocity - velocity) / units.speed;
  const double sign = v + 0.5 * a * std::fabs(a) > 0.0 ? -1.0 : 1.0;
  Phases phases;
  add_ramp(phases, std::max(0.5 * a * a - sign * v, 0.0), a, sign, limits, units.time);
  return phases;
}

Phases scurve_lead(const AxisState& start, const TimeLawLimits& limits) noexcept {
  const UnitsOfLimits units{limits};
  Phases phases;
  double a = start.accel / limits.accel, v = start.velocity / units.speed;
  if (std::fabs(a) > 1.0) {
    const double sign = std::copysign(1.0, a), beyond = std::fabs(a) - 1.0;
    phases.add(beyond * units.time, start.accel, -sign * limits.jerk);
    v += sign * beyond * (1.0 + 0.5 * beyond);
    a = sign;
  }
  const double limit = limits.speed / units.speed;
  const double released = v + 0.5 * a * std::fabs(a);  // the speed if the acceleration returns to 0 at once
  if (std::fabs(released) <= limit) return phases;
  const double sign = std::copysign(1.0, released);
  const double w = sign * v + 0.5 * a * a;
  const double peak = std::min(std::sqrt(std::max(w - limit, 0.0)), 1.0);
  phases.add((peak + sign * a) * units.time, a * limits.accel, -sign * limits.jerk);
  phases.add((w - limit - 1.0) * units.time, -sign * limits.accel, 0.0);
  return phases;
}

double scurve_shortest_s(const AxisState& start, double distance, const TimeLawLimits& limits) noexcept {
  const UnitsOfLimits units{limits};
  const double a = start.accel / limits.accel, v = start.velocity / units.speed;
  const double c = v - 0.5 * a * a;
  const double e = distance / units.length + (c + a * a / 6.0) * a;
  return fastest(e, c, limits.speed / units.speed).duration(a) * units.time;
}

Phases scurve_farthest(const AxisState& start, double duration_s, const TimeLawLimits& limits) noexcept {
  const UnitsOfLimits units{limits};
  const double a = start.accel / limits.accel, v = start.velocity / units.speed;
  const double c = v - 0.5 * a * a, duration = duration_s / units.time;
  SCurveShape shape = up_to_limit(c, limits.speed / units.speed);
  const double beyond = duration - shape.duration(a);
  if (beyond >= 0.0) {
    shape.cruise = beyond;
  } else {
    shape = of_duration(duration + a, c);
    shape.rise = std::clamp(shape.rise, a, std::max(a, 1.0));
  }
  Phases phases;
  phases.add((shape.rise - a) * units.time, start.accel, limits.jerk);
  phases.add(shape.hold * units.time, limits.accel, 0.0);
  if (shape.cruise > 0.0) {
    phases.add(shape.rise * units.time, shape.rise * limits.accel, -limits.jerk);
    phases.add(shape.cruise * units.time, 0.0, 0.0);
    phases.add(shape.fall * units.time, 0.0, -limits.jerk);
  } else {
    phases.add((shape.rise + shape.fall) * units.time, shape.rise * limits.accel, -limits.jerk);
  }
  phases.add(shape.brake * units.time, -limits.accel, 0.0);
  phases.add(shape.fall * units.time, -shape.fall * limits.accel, limits.jerk);
  return phases;
}

}  // namespace

const ReachRules kSCurveReach{scurve_lead, scurve_ramp, scurve_shortest_s, scurve_farthest};

}  // namespace armature
