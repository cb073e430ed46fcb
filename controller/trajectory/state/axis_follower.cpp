#include "controller/trajectory/state/axis_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {
namespace {

// Rounding of the planner, as a share of a limit.
constexpr double kSlack = 1.0 + 1e-9;
// An axis may be beyond the end of its range by this: rounding, a millionth of a pulse.
constexpr double kBeyond = 1e-12;
// The share of a limit that a reference may use. The rest is left to catch up with one that uses more.
constexpr double kFrameShare = 0.9;

bool within(double value, double limit) {
  return std::fabs(value) <= limit * kSlack;
}

// Two halves of the tick with constant acceleration.
bool meets_with_acceleration(const AxisState& from, const AxisState& to, const TimeLawLimits& limits) {
  constexpr double kHalf_s = 0.5 * kTickSeconds;
  const double way = (to.position - from.position) - from.velocity * kTickSeconds;
  const double change = to.velocity - from.velocity;
  const double first = (way - 0.5 * change * kHalf_s) / (kHalf_s * kHalf_s);
  const double second = change / kHalf_s - first;
  return within(first, limits.accel) && within(second, limits.accel) &&
         within(from.velocity + first * kHalf_s, limits.speed) && within(to.velocity, limits.speed);
}

// Three thirds of the tick with constant jerk.
bool meets_with_jerk(const AxisState& from, const AxisState& to, const TimeLawLimits& limits) {
  constexpr double kThird_s = kTickSeconds / 3.0, kTick2 = kTickSeconds * kTickSeconds;
  const double accel = (to.accel - from.accel) / kThird_s;
  const double speed = ((to.velocity - from.velocity) - from.accel * kTickSeconds) / (kThird_s * kThird_s);
  const double way = 6.0 * ((to.position - from.position) - from.velocity * kTickSeconds - 0.5 * from.accel * kTick2) /
                     (kThird_s * kThird_s * kThird_s);
  // accel = j1 + j2 + j3, speed = (5 j1 + 3 j2 + j3) / 2, way = 19 j1 + 7 j2 + j3
  const double first = (way + 2.0 * accel - 6.0 * speed) / 6.0;
  const double second = speed - 0.5 * accel - 2.0 * first;
  const double third = accel - first - second;
  const double accel1 = from.accel + first * kThird_s, accel2 = accel1 + second * kThird_s;
  return within(first, limits.jerk) && within(second, limits.jerk) && within(third, limits.jerk) &&
         within(accel1, limits.accel) && within(accel2, limits.accel) && within(to.accel, limits.accel) &&
         within(from.velocity, limits.speed) && within(to.velocity, limits.speed);
}

// At least the way of the fastest stop, in a tenth of its time; infinite for a state beyond the limits.
double most_way_to_stop(ProfileKind kind, const AxisState& state, const TimeLawLimits& limits) {
  const double accel = std::fabs(state.accel), speed = std::fabs(state.velocity);
  if (kind == ProfileKind::kTrapezoid) return 0.5 * speed * speed / limits.accel;
  const double peak = speed + 0.5 * accel * accel / limits.jerk;  // when the acceleration is 0
  if (!(accel <= limits.accel && peak <= limits.speed)) return std::numeric_limits<double>::infinity();
  return peak * (accel / limits.jerk + 0.5 * (peak / limits.accel + limits.accel / limits.jerk));
}

}  // namespace

AxisFollower::AxisFollower(ProfileKind kind, const TimeLawLimits& limits, const Range& range, double position) noexcept
    : kind_{kind}, limits_{limits}, range_{range}, state_{.position = position} {}

void AxisFollower::advance(const AxisState& reference) noexcept {
  AxisState next = reference;
  if (!meets(next)) next = towards(reference);
  // While the frame accelerates, its speed and that of the axis in it may add up to too much.
  if (!keeps_speed(next)) next = towards({.position = reference.position, .velocity = reference.velocity});
  if (kind_ == ProfileKind::kTrapezoid) next.accel = 0.0;
  if (!can_stop_after(next)) next = stop().at(kTickSeconds);
  state_ = next;
}

PhaseLaw AxisFollower::stop() const noexcept {
  return plan_to_velocity(kind_, state_, 0.0, limits_);
}

bool AxisFollower::meets(const AxisState& reference) const noexcept {
  return kind_ == ProfileKind::kTrapezoid ? meets_with_acceleration(state_, reference, limits_)
                                          : meets_with_jerk(state_, reference, limits_);
}

// In the frame that moves with the velocity and the acceleration of the reference, and reaches it at the end of the
// tick.
AxisState AxisFollower::towards(const AxisState& reference) const noexcept {
  AxisState frame = reference;
  frame.velocity = std::clamp(reference.velocity, -kFrameShare * limits_.speed, kFrameShare * limits_.speed);
  if (frame.velocity != reference.velocity) frame.accel = 0.0;
  frame.accel = std::clamp(frame.accel, -kFrameShare * limits_.accel, kFrameShare * limits_.accel);
  TimeLawLimits limits = limits_;
  limits.speed -= std::fabs(frame.velocity);
  limits.accel -= std::fabs(frame.accel);
  const AxisState before = after(frame, 0.0, -kTickSeconds);
  const AxisState start{state_.position - before.position, state_.velocity - before.velocity,
                        state_.accel - before.accel};
  const AxisReach reach{kind_, start, limits};
  const AxisState next = reach.on_motion(0.0, reach.shortest_s(0.0), kTickSeconds);
  return {.position = next.position + frame.position,
          .velocity = next.velocity + frame.velocity,
          .accel = kind_ == ProfileKind::kTrapezoid ? 0.0 : next.accel + frame.accel};
}

// Also when the acceleration then returns to 0 at once.
bool AxisFollower::keeps_speed(const AxisState& next) const noexcept {
  double velocity = next.velocity;
  if (kind_ == ProfileKind::kSCurve) velocity += 0.5 * next.accel * std::fabs(next.accel) / limits_.jerk;
  const double mean = (next.position - state_.position) / kTickSeconds;
  return within(velocity, limits_.speed) && within(next.velocity, limits_.speed) && within(mean, limits_.speed);
}

bool AxisFollower::can_stop_after(const AxisState& next) const noexcept {
  const double most = most_way_to_stop(kind_, next, limits_);
  if (next.position - most >= range_.least && next.position + most <= range_.largest) return true;
  const double end = AxisReach{kind_, next, limits_}.stop_position();
  return end >= range_.least - kBeyond && end <= range_.largest + kBeyond;
}

}  // namespace armature
