// Where an axis can come to rest and when, from any state of motion, and the motion that does it.
//
// A start beyond a limit first returns into it, without delay. For the speed this means: the acceleration returns to 0
// exactly at the limit. What follows is within the limits.
//
// A target that can be reached at rest can be waited at. So every duration from the shortest on is possible: there are
// no blocked intervals. A longer motion is the weighted mean of two motions of its duration: the stop, after which the
// axis waits, and the motion that ends as far as possible in the direction from the end of the stop to the target.
// Limits are convex, so the mean keeps them. If neither turns round, nor does the mean: with time in hand an axis does
// not overshoot.
#pragma once

#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"
#include "controller/trajectory/state/reach_rules.hpp"

namespace armature {

class AxisReach {
 public:
  // All values finite, limits > 0. kTrapezoid: the acceleration of the start has no effect. 0 limits are allowed for an
  // axis at rest that is asked only for its own position.
  AxisReach(ProfileKind kind, const AxisState& start, const TimeLawLimits& limits) noexcept;

  // The end of the shortest stop, and its duration. A state has one, whatever the target.
  [[nodiscard]] double stop_position() const noexcept { return stop_position_; }
  [[nodiscard]] double stop_s() const noexcept { return lead_s_ + stop_.duration_s(); }

  // The least time to come to rest at `target`, at most 1e-12 of it above the exact optimum.
  [[nodiscard]] double shortest_s(double target) const noexcept;

  struct Motion {
    PhaseLaw law{};     // ends at the target, at rest
    double miss = 0.0;  // its phases end at this distance from the target: rounding, or the duration is too short
  };
  // The motion that comes to rest at `target` in `duration_s` >= shortest_s(). The duration of the law can differ from
  // that by rounding; a stop at the target takes only its own time. For a duration that is slightly too short all
  // limits are exceeded by up to a millionth.
  [[nodiscard]] Motion motion(double target, double duration_s) const noexcept;
  // The same; returns the miss.
  [[nodiscard]] double motion(double target, double duration_s, PhaseLaw& law) const noexcept;
  // motion().law.at(t_s), without what comes after `t_s`.
  [[nodiscard]] AxisState on_motion(double target, double duration_s, double t_s) const noexcept;

 private:
  [[nodiscard]] double sign_to(double target) const noexcept { return target < stop_position_ ? -1.0 : 1.0; }
  // Within a rounding error: without this, the time to cover that error would be the third root of it.
  [[nodiscard]] bool stops_at(double target) const noexcept;
  // Calls take(Phase) for each phase of the motion while it returns true.
  template <class Take>
  void walk(double target, double duration_s, Take take) const noexcept;

  const ReachRules& rules_;
  TimeLawLimits limits_;
  AxisState start_;
  Phases lead_;
  AxisState lead_end_;  // = start_ for a start within the limits
  double lead_s_;
  Phases stop_;  // after lead_
  double stop_position_;
};

// The fastest motion of one axis to rest at `target`.
[[nodiscard]] PhaseLaw plan_to_rest(ProfileKind kind, const AxisState& start, double target,
                                    const TimeLawLimits& limits) noexcept;

// The fastest change to a constant velocity, |velocity| <= limits.speed, which then continues.
[[nodiscard]] PhaseLaw plan_to_velocity(ProfileKind kind, const AxisState& start, double velocity,
                                        const TimeLawLimits& limits) noexcept;

}  // namespace armature
