// How fast a plan is run through: as planned, more slowly under an override, ever more slowly to a hold or a stop, and
// up again. Only the timing changes: every set-point is a point of the plan's path, in its order.
//
// The clock keeps the path time and the rate, the share of a tick by which the path time advanced in the last tick. In
// each tick the rate goes towards the one that is wanted as far as neither a joint nor the tool exceeds its limits,
// taken on the set-points themselves (and not on measured positions):
//
//   joints  |q[k+1] - 2 q[k] + q[k-1]| <= a_max Ts^2     |q[k+1] - q[k]| <= v_max Ts
//   tool    the same of its position and of its turning, with the acceleration that the move was given
//
// To keep the rate is always possible: at a rate of 1 or less it needs no more than the plan does. So the rate stays
// where it is while it cannot change the right way, which happens: a joint that already brakes with all it has lets
// nothing slow down, nor does one that turns round when slowing down would bend it more; both pass with the path.
// Where a change fails because the path bends more than its model says, the next tick tries half of it, and so on: an
// arm that stands would otherwise try the same in vain for ever.
//
// For plans with limited jerk the rate's own second difference is limited too: it goes to the one wanted in the shape
// of an S, du = r[k+1] - 2 r[k] + r[k-1] with |du| <= w, and slows down on u^2 = 2 w |wanted - r|. With w from
// rate_bend() the jerk of plan and change together stays within 2 J; see there. A constant rate needs J rate^3.
// Accelerations come first: where one of them holds the rate back it is the one that decides u, and |du| may exceed w.
// What is at its limit then has no jerk; for what else moves 2 J is not proven. Rates wanted anew in the middle of a
// change may be passed by a little before they are reached, never 0 or 1. On an arc J is along the path only.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"

namespace armature {

// A step of the tool between two set-points: of its position and its rotation vector, each divided by a Ts^2, what the
// largest acceleration changes a step by in a tick. All 0 where the tool has no limits.
struct ToolStep {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
};

class PathClock {
 public:
  // Most evaluations of the path in one tick; one while the rate is the one wanted, none while standing.
  static constexpr int kMostEvaluations = 5;

  explicit PathClock(const RobotModel& robot) noexcept;

  // A plan begins, at rest and at this rate, 0..1. What begins at rest can be run at any rate at once. `rate_bend` is
  // w, > 0, or kAnyBend where jerk is not limited.
  void restart(double rate, double rate_bend = kAnyBend) noexcept;
  // From here on w is another one: at an exact stop of the plan, where a change that is under way may begin anew.
  void enter(double rate_bend) noexcept;

  // Path time in ticks since the start of the plan, and its advance in the last tick, 0..1.
  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] double rate() const noexcept { return rate_; }

  // The next set-point. `wanted` is the rate to go to, 0..1; `now` the set-point before; `at(ticks)` gives the joints
  // at a path time, the last of them beyond the end of the plan; `tool_step(from, to)` the ToolStep between two path
  // times, called only while the rate changes; `may_try()` whether two more evaluations of `at` are affordable. Where
  // they are not the rate stays as it is.
  template <class At, class Step, class MayTry>
  [[nodiscard]] PerAxis<Radians> advance(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                         MayTry may_try) noexcept;

  // As fast as the joints' accelerations alone allow, whatever the tool and the jerk: for a stop.
  template <class At, class MayTry>
  [[nodiscard]] PerAxis<Radians> advance_hard(double wanted, const PerAxis<Radians>& now, At at,
                                              MayTry may_try) noexcept;

 private:
  // Below this rate the last step says nothing about the path's curvature, and the model is a line.
  static constexpr double kShortStep = 1e-3;
  static constexpr int kAttempts = kMostEvaluations - 2;  // the rest: a look ahead, and the rate kept after all

  template <class At, class Step, class MayTry>
  [[nodiscard]] PerAxis<Radians> change_rate(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                             MayTry may_try) noexcept;
  // The next rate on the S towards `wanted`.
  [[nodiscard]] double shaped(double wanted) const noexcept;
  // The rate nearest to `wanted` on a model of the path: for each joint and the tool the parabola through the last two
  // set-points and the point `next`, `tool` of the tool, at path time time() + `ticks`.
  [[nodiscard]] double propose(double wanted, const PerAxis<Radians>& now, double ticks, const PerAxis<Radians>& next,
                               const ToolStep& last, const ToolStep& tool) const noexcept;
  [[nodiscard]] bool allowed(const PerAxis<Radians>& now, const PerAxis<Radians>& next) const noexcept;
  [[nodiscard]] static bool allowed(const ToolStep& last, const ToolStep& next) noexcept;
  void take(double rate, const PerAxis<Radians>& now, const PerAxis<Radians>& next) noexcept;

  static constexpr double kLeastCaution = 0x1p-40;

  std::size_t axis_count_;
  PerAxis<double> max_step_rad_{};  // v_max Ts
  PerAxis<double> max_bend_rad_{};  // a_max Ts^2
  double time_ = 0.0;
  double rate_ = 1.0;
  double rate_step_ = 0.0;  // u: last rate minus the one before
  double rate_bend_ = kAnyBend;
  double caution_ = 1.0;  // share of a change that is tried: halved by a tick that fails, doubled by one that does not
  PerAxis<double> step_rad_{};  // last set-point minus the one before; 0 at the start of a plan
};

template <class At, class Step, class MayTry>
PerAxis<Radians> PathClock::advance(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                    MayTry may_try) noexcept {
  const bool as_wanted = rate_bend_ == kAnyBend || (wanted == rate_ && rate_step_ == 0.0);
  return change_rate(as_wanted ? wanted : shaped(wanted), now, at, tool_step, may_try);
}

template <class At, class MayTry>
PerAxis<Radians> PathClock::advance_hard(double wanted, const PerAxis<Radians>& now, At at, MayTry may_try) noexcept {
  return change_rate(
      wanted, now, at, [](double, double) { return ToolStep{}; }, may_try);
}

template <class At, class Step, class MayTry>
PerAxis<Radians> PathClock::change_rate(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                        MayTry may_try) noexcept {
  if (wanted == rate_) {
    const PerAxis<Radians> next = rate_ == 0.0 ? now : at(time_ + rate_);
    take(rate_, now, next);
    return next;
  }
  const PerAxis<Radians> ahead = at(time_ + 1.0);
  const auto at_rate = [&](double rate) { return rate == 0.0 ? now : rate == 1.0 ? ahead : at(time_ + rate); };
  const ToolStep last = tool_step(time_ - rate_, time_);
  const double proposed = propose(wanted, now, 1.0, ahead, last, tool_step(time_, time_ + 1.0));
  double rate = caution_ == 1.0 ? proposed : rate_ + caution_ * (proposed - rate_);
  const bool tries = rate != rate_;
  for (int attempt = 0; attempt < kAttempts && rate != rate_ && may_try(); ++attempt) {
    const PerAxis<Radians> next = at_rate(rate);
    const ToolStep tool = tool_step(time_, time_ + rate);
    if (allowed(now, next) && allowed(last, tool)) {
      caution_ = std::min(1.0, 2.0 * caution_);
      take(rate, now, next);
      return next;
    }
    // The point that was tried makes a better model; should it not help, half the change may.
    const double halfway = rate_ + 0.5 * (rate - rate_);
    const double better = rate < kShortStep ? halfway : propose(wanted, now, rate, next, last, tool);
    rate = std::fabs(better - rate_) < std::fabs(rate - rate_) ? better : halfway;
  }
  if (tries) caution_ = std::max(kLeastCaution, 0.5 * caution_);
  const PerAxis<Radians> next = at_rate(rate_);
  take(rate_, now, next);
  return next;
}

}  // namespace armature
