// Random states of motion, targets and limits of one axis.
#pragma once

#include <cmath>
#include <string>

#include "controller/trajectory/state/axis_reach.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::test {

struct AxisDraw {
  AxisState start{};
  double target = 0.0;
  TimeLawLimits limits{};
};

inline std::string text_of(const AxisDraw& d) {
  const auto number = [](double x) { return std::to_string(x) + " "; };
  return "start " + number(d.start.position) + number(d.start.velocity) + number(d.start.accel) + "target " +
         number(d.target) + "limits " + number(d.limits.speed) + number(d.limits.accel) + number(d.limits.jerk);
}

inline double logarithmic(Random& random, double low, double high) {
  return std::exp(random.real(std::log(low), std::log(high)));
}

// The speed if the acceleration returns to 0 at once.
inline double released(ProfileKind kind, const AxisState& state, const TimeLawLimits& limits) {
  if (kind == ProfileKind::kTrapezoid) return state.velocity;
  return state.velocity + 0.5 * state.accel * std::fabs(state.accel) / limits.jerk;
}

// Starts within the limits, often exactly at one of them; targets at all distances, often near the end of a stop.
inline AxisDraw draw_within(Random& random, ProfileKind kind) {
  AxisDraw d;
  d.limits = {.speed = logarithmic(random, 0.1, 8.0),
              .accel = logarithmic(random, 0.2, 50.0),
              .jerk = logarithmic(random, 1.0, 2'000.0)};
  do {
    d.start = {random.real(-3.0, 3.0), random.real(-1.0, 1.0) * d.limits.speed,
               random.real(-1.0, 1.0) * d.limits.accel};
    const auto special = random.integer(0, 11);
    if (special == 0) d.start.velocity = 0.0;
    if (special == 1 || special == 2) d.start.accel = 0.0;
    if (special == 2 || special == 3) d.start.velocity = d.limits.speed;
    if (special == 4) d.start.velocity = -d.limits.speed;
    if (special == 5) d.start.accel = d.limits.accel;
    if (special == 6) d.start.accel = -d.limits.accel;
    if (special == 7) d.start.velocity = d.start.accel = 0.0;
  } while (std::fabs(released(kind, d.start, d.limits)) > d.limits.speed);
  d.target = random.real(-3.0, 3.0);
  for (auto scale = random.integer(0, 9); scale > 0; --scale)
    d.target = d.start.position + 0.3 * (d.target - d.start.position);
  const double stop = AxisReach{kind, d.start, d.limits}.stop_position();
  const auto special = random.integer(0, 19);
  if (special == 0) d.target = d.start.position;
  if (special == 1) d.target = stop;
  if (special == 2 || special == 3) d.target = stop + random.real(-1.0, 1.0) * logarithmic(random, 1e-12, 1.0);
  return d;
}

}  // namespace armature::test
