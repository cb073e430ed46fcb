// Under limits of speed and acceleration the axis accelerates, cruises and brakes.
#include <algorithm>
#include <cmath>

#include "controller/trajectory/state/reach_rules.hpp"

namespace armature {
namespace {

Phases trapezoid_ramp(const AxisState& start, double velocity, const TimeLawLimits& limits) noexcept {
  Phases phases;
  const double change = velocity - start.velocity;
  phases.add(std::fabs(change) / limits.accel, std::copysign(limits.accel, change), 0.0);
  return phases;
}

Phases trapezoid_lead(const AxisState& start, const TimeLawLimits& limits) noexcept {
  return trapezoid_ramp(start, std::clamp(start.velocity, -limits.speed, limits.speed), limits);
}

double trapezoid_shortest_s(const AxisState& start, double distance, const TimeLawLimits& limits) noexcept {
  const double v = start.velocity;
  const double peak = std::max({std::sqrt(std::max(distance * limits.accel + 0.5 * v * v, 0.0)), v, 0.0});
  if (peak <= limits.speed) return (2.0 * peak - v) / limits.accel;
  const double on_ramps = (limits.speed * limits.speed - 0.5 * v * v) / limits.accel;
  return (2.0 * limits.speed - v) / limits.accel + (distance - on_ramps) / limits.speed;
}

Phases trapezoid_farthest(const AxisState& start, double duration_s, const TimeLawLimits& limits) noexcept {
  const double v = start.velocity;
  const double peak = std::max(0.5 * (limits.accel * duration_s + v), v);
  const double top = std::min(peak, limits.speed);
  Phases phases;
  phases.add((top - v) / limits.accel, limits.accel, 0.0);
  if (peak > top) phases.add(duration_s - (2.0 * top - v) / limits.accel, 0.0, 0.0);
  phases.add(top / limits.accel, -limits.accel, 0.0);
  return phases;
}

}  // namespace

const ReachRules kTrapezoidReach{trapezoid_lead, trapezoid_ramp, trapezoid_shortest_s, trapezoid_farthest};

}  // namespace armature
