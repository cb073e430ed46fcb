// A proof that a motion is time-optimal, without the planner: no motion within the limits goes farther in its time.
//
// The farthest position is the value of a linear programme over all motions v' = a, a' = j with |v| <= V, |a| <= A, |j|
// <= J that end at rest at time T. By weak duality every choice of multipliers gives an upper bound: with functions
// x_v, x_a and non-negative measures l, n, m
//
//   x_v' = -1 + l     x_a' = -x_v + n - m
//   p(T) - p(0) <= x_v(0) v(0) + x_a(0) a(0) + V * integral of l + A * integral of (n + m) + J * integral of |x_a|
//
// The multipliers here are parabolas through the times at which the motion switches. If the bound equals the position
// of the motion, that is the farthest one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature::test {

struct FarthestBound {
  long double position = 0.0L;  // in the direction of `sign`
  long double slope = 0.0L;     // its increase per s of additional time
};

namespace bound {

// Integral of |(t - m)^2 - (k - m)^2| / 2 over [from, to], where the sign does not change.
inline long double area(long double from, long double to, long double m, long double k) {
  const auto cube = [](long double x) { return x * x * x; };
  return std::fabs((cube(to - m) - cube(from - m)) / 6 - (k - m) * (k - m) * (to - from) / 2);
}

// The times at which a motion in positive direction switches: it increases its acceleration until rise, keeps it until
// fall, decreases it, cruises from cruise to leave, decreases it until brake, keeps it until ease, increases it to the
// end.
struct Switches {
  long double start = 0, rise = 0, fall = 0, cruise = 0, leave = 0, brake = 0, ease = 0, end = 0;
};

inline Switches switches_of(const PhaseLaw& law, double sign, double from_s, bool with_jerk) {
  Switches t{};
  t.start = from_s;
  t.end = law.duration_s();
  long double now = from_s;  // the end of the phases seen so far
  enum { kRise, kHold, kFall, kCruise, kAfter, kBrake, kEase } part = kRise;
  t.rise = t.fall = t.cruise = t.leave = t.brake = t.ease = -1;
  const auto knots = law.knots();
  double most_jerk = 0, most_accel = 0;
  for (const auto& k : knots) {
    most_jerk = std::fmax(most_jerk, std::fabs(k.jerk));
    most_accel = std::fmax(most_accel, std::fabs(k.state.accel));
  }
  for (const auto& k : knots) {
    if (k.start_s < from_s - 1e-15) continue;
    now = k.start_s;
    const double jerk = sign * k.jerk, accel = sign * k.state.accel;
    auto next = part;
    if (with_jerk && jerk > 0.5 * most_jerk) {
      next = part == kRise ? kRise : kEase;
    } else if (with_jerk && jerk < -0.5 * most_jerk) {
      next = part >= kCruise ? kAfter : kFall;
    } else if (std::fabs(accel) < 1e-6 * most_accel) {
      next = kCruise;
    } else {
      next = accel > 0 ? kHold : kBrake;
    }
    const auto mark = [&](long double& time, int begins) {
      if (time < 0 && part < begins && next >= begins) time = now;
    };
    mark(t.rise, kHold);
    mark(t.fall, kFall);
    mark(t.cruise, kCruise);
    mark(t.leave, kAfter);
    mark(t.brake, kBrake);
    mark(t.ease, kEase);
    part = next;
  }
  if (t.ease < 0) t.ease = t.end;
  if (t.brake < 0) t.brake = t.ease;
  if (t.leave < 0) t.leave = t.brake;
  if (t.cruise < 0) t.cruise = t.leave;
  if (t.fall < 0) t.fall = t.cruise;
  if (t.rise < 0) t.rise = t.fall;
  return t;
}

}  // namespace bound

// For the phases of `law` from `from_s` on, where the axis is at `start`.
inline FarthestBound farthest_bound(ProfileKind kind, const PhaseLaw& law, const AxisState& start, double from_s,
                                    double sign, const TimeLawLimits& limits) {
  const bool with_jerk = kind == ProfileKind::kSCurve;
  const bound::Switches t = bound::switches_of(law, sign, from_s, with_jerk);
  const long double v0 = static_cast<long double>(sign) * start.velocity,
                    a0 = static_cast<long double>(sign) * start.accel;
  const long double A = limits.accel, V = limits.speed, J = limits.jerk;
  const bool cruises = t.leave > t.cruise;
  FarthestBound bound{static_cast<long double>(sign) * start.position, 0};
  if (!with_jerk) {
    const long double first = (cruises ? t.cruise : t.brake) - t.start, last = t.end - (cruises ? t.leave : t.brake);
    bound.position += first * v0 + A * (first * first + last * last) / 2 + V * (cruises ? t.leave - t.cruise : 0);
    bound.slope = A * last;
    return bound;
  }
  // x_v = m - t, and x_a is 0 at both ends of a fall.
  const long double first_end = cruises ? t.cruise : t.brake, last_begin = cruises ? t.leave : t.fall;
  const long double m1 = (t.fall + first_end) / 2, m2 = (last_begin + t.brake) / 2;
  const auto square = [](long double x) { return x * x; };
  bound.position += (m1 - t.start) * v0 + (square(t.start - m1) - square(t.rise - m1)) / 2 * a0;
  bound.position += J * (bound::area(t.start, t.rise, m1, t.rise) + bound::area(t.ease, t.end, m2, t.ease));
  bound.position += A * (square(m1 - t.rise) - square(m1 - t.fall) + square(t.ease - m2) - square(t.brake - m2)) / 2;
  bound.position += J * bound::area(t.fall, first_end, m1, t.fall);
  if (cruises) {
    bound.position += J * bound::area(t.leave, t.brake, m2, t.leave);
    bound.position += V * ((t.cruise - t.fall) / 2 + (t.leave - t.cruise) + (t.brake - t.leave) / 2);
  }
  bound.slope = J * (square(t.end - m2) - square(t.ease - m2)) / 2;
  return bound;
}

}  // namespace armature::test
