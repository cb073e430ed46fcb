// How fast a plan is run through: as planned, more slowly under an override, ever more slowly to a hold or a stop, and
// up again. Only the timing changes: every set-point is a point of the plan's path, in its order.
//
// The clock keeps the path time and the rate, the share of a tick by which the path time advanced in the last tick. In
// each tick the rate goes towards the one that is wanted as far as no joint exceeds its limits, taken on the set-points
// themselves (and not on measured positions):
//
//   |q[k+1] - 2 q[k] + q[k-1]| <= a_max Ts^2     |q[k+1] - q[k]| <= v_max Ts
//
// To keep the rate is always possible: at a rate of 1 or less it needs no more than the plan does. So the rate stays
// where it is while it cannot change the right way, which happens: a joint that already brakes with all it has lets
// nothing slow down, nor does one that turns round when slowing down would bend it more; both pass with the path.
//
// Jerk is not limited while the rate changes: an S-curve that is held, resumed or stopped brakes and speeds up like a
// trapezoid. At a constant rate the plan's jerk holds, times the rate's cube.
#pragma once

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class PathClock {
 public:
  // Most evaluations of the path in one tick; one while the rate is the one wanted, none while standing.
  static constexpr int kMostEvaluations = 5;

  explicit PathClock(const RobotModel& robot) noexcept;

  // A plan begins, at rest and at this rate, 0..1. What begins at rest can be run at any rate at once.
  void restart(double rate) noexcept;

  // Path time in ticks since the start of the plan, and its advance in the last tick, 0..1.
  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] double rate() const noexcept { return rate_; }

  // The next set-point. `wanted` is the rate to go to, 0..1; `now` the set-point before; `at(ticks)` gives the joints
  // at a path time, the last of them beyond the end of the plan.
  template <class At>
  [[nodiscard]] PerAxis<Radians> advance(double wanted, const PerAxis<Radians>& now, At at) noexcept;

 private:
  static constexpr int kAttempts = kMostEvaluations - 2;  // the rest: a look ahead, and the rate kept after all

  // The rate nearest to `wanted` on a model of the path: for each joint the parabola through the last two set-points
  // and the point a tick `ahead`.
  [[nodiscard]] double propose(double wanted, const PerAxis<Radians>& now,
                               const PerAxis<Radians>& ahead) const noexcept;
  [[nodiscard]] bool allowed(const PerAxis<Radians>& now, const PerAxis<Radians>& next) const noexcept;
  void take(double rate, const PerAxis<Radians>& now, const PerAxis<Radians>& next) noexcept;

  std::size_t axis_count_;
  PerAxis<double> max_step_rad_{};  // v_max Ts
  PerAxis<double> max_bend_rad_{};  // a_max Ts^2
  double time_ = 0.0;
  double rate_ = 1.0;
  PerAxis<double> step_rad_{};  // last set-point minus the one before; 0 at the start of a plan
};

template <class At>
PerAxis<Radians> PathClock::advance(double wanted, const PerAxis<Radians>& now, At at) noexcept {
  if (wanted == rate_) {
    const PerAxis<Radians> next = rate_ == 0.0 ? now : at(time_ + rate_);
    take(rate_, now, next);
    return next;
  }
  const PerAxis<Radians> ahead = at(time_ + 1.0);
  const auto at_rate = [&](double rate) { return rate == 0.0 ? now : rate == 1.0 ? ahead : at(time_ + rate); };
  double rate = propose(wanted, now, ahead);
  for (int attempt = 0; attempt < kAttempts && rate != rate_; ++attempt) {
    const PerAxis<Radians> next = at_rate(rate);
    if (allowed(now, next)) {
      take(rate, now, next);
      return next;
    }
    rate = rate_ + 0.5 * (rate - rate_);
  }
  const PerAxis<Radians> next = at_rate(rate_);
  take(rate_, now, next);
  return next;
}

}  // namespace armature
