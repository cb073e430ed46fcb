// The rate at which a plan is executed: as planned, more slowly under a feed override, decreasing to a hold or a stop,
// and increasing again. Only the timing changes: every set-point is a point of the plan's path, in its order.
//
// The clock keeps the path time and the rate. The rate is the advance of the path time in the last tick, as a share of
// a tick. In each tick the rate changes towards the wanted one as far as neither a joint nor the tool exceeds its
// limits. The limits are checked on the set-points, not on measured positions:
//
//   joints  |q[k+1] - 2 q[k] + q[k-1]| <= a_max Ts^2     |q[k+1] - q[k]| <= v_max Ts
//   tool    the same for its position and its rotation, with the acceleration limits of the move
//
// In a change one point of the path is evaluated: at the rate that is foreseen, which changes as it did in the last
// tick. The parabola through it and the last two set-points gives the rate, and the set-point if this rate is as close
// to the foreseen one as 0.01: at most 1e-10 rad from the path, where the plan's acceleration jumps; otherwise at most
// 1e-12. Only for another rate the path is evaluated again.
//
// The present rate can always be kept: at a rate of 1 or less it needs no more than the plan does. So the rate stays
// constant while it cannot change in the wanted direction. This happens when a joint already brakes at its limit, so
// that nothing may slow down, and when a joint turns round and slowing down would increase its acceleration. Both
// situations end as the path advances. If a change fails because the path bends more than its model, the next tick
// tries half of the change, and so on. Otherwise an arm at rest could try the same change in vain for ever.
//
// Where jerk is limited, rate_change.hpp determines the rate. Chains of joint moves limit the second difference of the
// rate instead: du = r[k+1] - 2 r[k] + r[k-1] with |du| <= w, slowing down on u^2 = 2 w |wanted - r|. With w from
// rate_bend() the jerk of plan and change together stays within 2 J; see there. Where accelerations limit the rate,
// |du| may exceed w. If the wanted rate changes in the middle of a change, the rate may overshoot it slightly, but
// never 0 or 1.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"
#include "controller/trajectory/run/rate_change.hpp"

namespace armature {

inline constexpr double kNoJerkLimit = std::numeric_limits<double>::infinity();

// A step of the tool between two set-points: of its position and its rotation vector, each divided by a Ts^2, the
// largest change of a step in a tick. All 0 where the tool has no limits.
struct ToolStep {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  // The largest change of these changes in a tick, in the same unit; infinite where jerk is not limited.
  double move_jerk = kNoJerkLimit;
  double turn_jerk = kNoJerkLimit;
};

class PathClock {
 public:
  // Largest number of evaluations of the path in one tick: one while the rate is constant, and in most ticks of a
  // change; none while standing.
  static constexpr int kMaxEvaluations = 4;

  explicit PathClock(const RobotModel& robot) noexcept;

  // Starts a plan with this rate, 0..1. A plan that begins at rest can start with any rate, a plan that begins in
  // motion only with 1; the clock then keeps its last steps, if `in_motion`. `rate_bend` is w, > 0, with kAny.
  void restart(double rate, RateJerk jerk = RateJerk::kAny, double rate_bend = kAnyBend,
               bool in_motion = false) noexcept;
  // The path time is counted from tick `origin` of the present plan on. For a plan that continues the present one.
  void move_origin(Ticks origin) noexcept;
  // The largest acceleration of a joint in the plan, after restart() of a joint move.
  void set_peak(std::size_t axis, double accel_rad_s2) noexcept;
  // In motion, for a plan that continues the present one: not from kAny while the rate changes.
  void continue_with_jerk(RateJerk jerk) noexcept { jerk_ = jerk; }
  // From here on, at an exact stop of the plan, where a new change of the rate may begin.
  void set_jerk(RateJerk jerk) noexcept;

  // Path time in ticks since the start of the plan, and its advance in the last tick, 0..1.
  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] double rate() const noexcept { return rate_; }
  // The rate did not change in the last tick.
  [[nodiscard]] bool steady() const noexcept { return rate_step_ == 0.0; }
  // Changes of the rate limit the jerk.
  [[nodiscard]] bool limits_jerk() const noexcept { return jerk_ != RateJerk::kAny || rate_bend_ != kAnyBend; }
  // The last set-point minus the previous one, and the same a tick before.
  [[nodiscard]] const PerAxis<double>& step_rad() const noexcept { return step_rad_; }
  [[nodiscard]] const PerAxis<double>& previous_step_rad() const noexcept { return previous_step_rad_; }

  // The next set-point. `wanted` is the wanted rate, 0..1; `now` the previous set-point. `at(ticks)` returns the joints
  // at a path time, beyond the end of the plan the last ones. `tool_step(from, to)` returns the ToolStep between two
  // path times; it is called only while the rate changes. `may_try()` returns whether two more evaluations of `at` are
  // affordable; if not, the rate stays constant. `plan_jerk(from, to)` returns the largest jerk of the plan between two
  // path times as a share of the limits.
  template <class At, class Step, class MayTry, class PlanJerk>
  [[nodiscard]] PerAxis<Radians> advance(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                         MayTry may_try, PlanJerk plan_jerk) noexcept;

  // As advance(), but limited only by the accelerations of the joints, not by the tool and the jerk: for a stop.
  template <class At, class MayTry>
  [[nodiscard]] PerAxis<Radians> advance_hard(double wanted, const PerAxis<Radians>& now, At at,
                                              MayTry may_try) noexcept;

 private:
  // Below this rate the last step contains no information about the path's curvature, and the model is linear.
  static constexpr double kShortStep = 1e-3;
  // The model of the path is exact for rates as close as this to the evaluated one.
  static constexpr double kCloseStep = 0.1;
  // The path is known as close as this to the evaluated rate.
  static constexpr double kKnown = 0.01;
  static constexpr int kAttempts =
      kMaxEvaluations - 2;  // the others: the step that is foreseen, and the step at the constant rate

  template <class At, class Step, class MayTry>
  [[nodiscard]] PerAxis<Radians> change_rate(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                             MayTry may_try) noexcept;
  template <class At, class Step, class MayTry, class PlanJerk>
  [[nodiscard]] PerAxis<Radians> change_smoothly(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                                 MayTry may_try, PlanJerk plan_jerk) noexcept;
  // The next rate on the S-shaped change towards `wanted` with rate_bend_.
  [[nodiscard]] double shaped(double wanted) const noexcept;
  // The tool's steps in the last tick, in the one before, and to path time time() + `ticks`.
  struct ToolSteps {
    ToolStep last, before, next;
  };
  // Adds the motions of joints and tool, whose path is the parabola through the last two set-points and `next` at path
  // time time() + `ticks`.
  void add_motions(RateChange& change, const PerAxis<Radians>& now, double ticks, const PerAxis<Radians>& next,
                   const ToolSteps& tool) const noexcept;
  // The joints near path time time(): for each the parabola through the last two set-points and the point `next` at
  // path time time() + `ticks`.
  struct PathModel {
    PathModel(const PathClock& clock, const PerAxis<Radians>& from, double to, const PerAxis<Radians>& at_end) noexcept;
    // The path is known at this rate: its distance from the parabola is below a third of kKnown a Ts^2, 1e-10 rad.
    [[nodiscard]] bool knows(double rate) const noexcept { return rate == 0.0 || std::fabs(rate - ticks) <= kKnown; }
    // So is the step of the tool: to a thousandth of its limits, where the plan's acceleration jumps.
    [[nodiscard]] bool knows_tool(double rate) const noexcept {
      return rate == 0.0 || std::fabs(rate - ticks) <= 0.1 * kKnown;
    }
    [[nodiscard]] PerAxis<Radians> at(double rate) const noexcept;

    double ticks;
    PerAxis<Radians> now, next;
    PerAxis<double> slope{}, curvature{};
  };
  template <class At>
  [[nodiscard]] PerAxis<Radians> keep_rate(const PerAxis<Radians>& now, const PathModel& model, At at) noexcept;
  // The rate nearest to `wanted` according to the model, and to that of the tool, to which `tool` leads.
  [[nodiscard]] double propose(double wanted, const PathModel& model, const ToolStep& last,
                               const ToolStep& tool) const noexcept;
  [[nodiscard]] bool allowed(const PerAxis<Radians>& now, const PerAxis<Radians>& next) const noexcept;
  [[nodiscard]] static bool allowed(const ToolStep& last, const ToolStep& next) noexcept;
  // The same for the step at this rate, by the parabola that leads to `next` after `ticks`.
  [[nodiscard]] bool keeps_limits(const ToolStep& last, double ticks, const ToolStep& next, double rate) const noexcept;
  void apply(double rate, const PerAxis<Radians>& now, const PerAxis<Radians>& next) noexcept;

  static constexpr double kMinChangeScale = 0x1p-40;

  std::size_t axis_count_;
  PerAxis<double> max_step_rad_{};  // v_max Ts
  PerAxis<double> max_bend_rad_{};  // a_max Ts^2
  PerAxis<double> max_jerk_rad_{};  // j_max Ts^3; infinite where the robot has none
  PerAxis<double> peak_rad_{};      // of the acceleration of the plan, per tick^2
  double time_ = 0.0;
  double last_time_ = 0.0, time_before_ = 0.0;  // a tick ago, and two
  double rate_ = 1.0;
  double rate_step_ = 0.0;  // u: last rate minus the previous one
  RateJerk jerk_ = RateJerk::kAny;
  double rate_bend_ = kAnyBend;
  double change_scale_ = 1.0;   // share of a change that is tried; halved after a failed tick, doubled after a good one
  PerAxis<double> step_rad_{};  // last set-point minus the previous one
  PerAxis<double> previous_step_rad_{};
};

// Here, because it is a large part of a tick of a joint move.
inline void PathClock::apply(double rate, const PerAxis<Radians>& now, const PerAxis<Radians>& next) noexcept {
  time_before_ = last_time_;
  last_time_ = time_;
  time_ += rate;
  rate_step_ = rate - rate_;
  rate_ = rate;
  previous_step_rad_ = step_rad_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) step_rad_[axis] = (next[axis] - now[axis]).value();
}

template <class At, class Step, class MayTry, class PlanJerk>
PerAxis<Radians> PathClock::advance(double wanted, const PerAxis<Radians>& now, At at, Step tool_step, MayTry may_try,
                                    PlanJerk plan_jerk) noexcept {
  if (jerk_ != RateJerk::kAny && (wanted != rate_ || rate_step_ != 0.0)) {
    return change_smoothly(wanted, now, at, tool_step, may_try, plan_jerk);
  }
  const bool as_wanted = rate_bend_ == kAnyBend || (wanted == rate_ && rate_step_ == 0.0);
  return change_rate(as_wanted ? wanted : shaped(wanted), now, at, tool_step, may_try);
}

template <class At, class MayTry>
PerAxis<Radians> PathClock::advance_hard(double wanted, const PerAxis<Radians>& now, At at, MayTry may_try) noexcept {
  return change_rate(
      wanted, now, at, [](double, double) { return ToolStep{}; }, may_try);
}

template <class At>
PerAxis<Radians> PathClock::keep_rate(const PerAxis<Radians>& now, const PathModel& model, At at) noexcept {
  const PerAxis<Radians> next = model.knows(rate_) ? model.at(rate_) : at(time_ + rate_);
  apply(rate_, now, next);
  return next;
}

template <class At, class Step, class MayTry>
PerAxis<Radians> PathClock::change_rate(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                        MayTry may_try) noexcept {
  if (wanted == rate_) {
    const PerAxis<Radians> next = rate_ == 0.0 ? now : at(time_ + rate_);
    apply(rate_, now, next);
    return next;
  }
  const double foreseen = std::clamp(rate_ + rate_step_, kShortStep, 1.0);
  PathModel model{*this, now, foreseen, at(time_ + foreseen)};
  const ToolStep last = tool_step(last_time_, time_);
  const double proposed = propose(wanted, model, last, tool_step(time_, time_ + foreseen));
  double rate = change_scale_ == 1.0 ? proposed : rate_ + change_scale_ * (proposed - rate_);
  const bool tries = rate != rate_;
  for (int attempt = 0; attempt < kAttempts && rate != rate_; ++attempt) {
    const bool known = model.knows(rate);
    if (!known && !may_try()) break;
    const PerAxis<Radians> next = known ? model.at(rate) : at(time_ + rate);
    const bool tool_known = model.knows_tool(rate);
    const ToolStep tool = tool_known ? ToolStep{} : tool_step(time_, time_ + rate);
    if (allowed(now, next) && (tool_known || allowed(last, tool))) {
      change_scale_ = std::min(1.0, 2.0 * change_scale_);
      apply(rate, now, next);
      return next;
    }
    if (known) break;
    // The point that was tried improves the model. If the new proposal is not smaller, half of the change is tried.
    model = {*this, now, rate, next};
    const double halfway = rate_ + 0.5 * (rate - rate_);
    const double better = rate < kShortStep ? halfway : propose(wanted, model, last, tool);
    rate = std::fabs(better - rate_) < std::fabs(rate - rate_) ? better : halfway;
  }
  if (tries) change_scale_ = std::max(kMinChangeScale, 0.5 * change_scale_);
  return keep_rate(now, model, at);
}

template <class At, class Step, class MayTry, class PlanJerk>
PerAxis<Radians> PathClock::change_smoothly(double wanted, const PerAxis<Radians>& now, At at, Step tool_step,
                                            MayTry may_try, PlanJerk plan_jerk) noexcept {
  ToolSteps tool{.last = tool_step(last_time_, time_), .before = tool_step(time_before_, last_time_), .next = {}};
  double ticks = std::clamp(rate_ + rate_step_, kShortStep, 1.0);
  PerAxis<Radians> next = at(time_ + ticks);
  for (int attempt = 0;; ++attempt) {
    RateChange change{rate_, rate_step_, wanted, jerk_};
    tool.next = tool_step(time_, time_ + ticks);
    add_motions(change, now, ticks, next, tool);
    const double ahead = change.ahead();
    const double rate = change.rate(ahead > 0.0 ? plan_jerk(time_, time_ + ahead) : 0.0);
    const bool exact = std::fabs(rate - ticks) <= (rate_ < kShortStep ? kShortStep : kCloseStep);
    const PathModel model{*this, now, ticks, next};
    const bool known = model.knows(rate);
    ticks = rate;
    next = known ? model.at(rate) : at(time_ + rate);
    if (!known && !exact && attempt < kAttempts - 1 && may_try()) continue;
    // Speed and acceleration keep their limits, whatever the model of the path: the present rate needs no more than the
    // plan does.
    const bool tool_allowed = model.knows_tool(rate) ? keeps_limits(tool.last, model.ticks, tool.next, rate)
                                                     : allowed(tool.last, tool_step(time_, time_ + rate));
    if (tool_allowed && allowed(now, next)) {
      apply(rate, now, next);
      return next;
    }
    return keep_rate(now, model, at);
  }
}

}  // namespace armature
