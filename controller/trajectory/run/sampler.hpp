// Converts the plan that is being executed into one set-point per tick.
#pragma once

#include <array>
#include <cstddef>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/jerk_share.hpp"
#include "controller/trajectory/plan/plan.hpp"
#include "controller/trajectory/run/path_clock.hpp"

namespace armature {

class Sampler {
 public:
  // Stands at `position`. Robot and arm must outlive the sampler.
  Sampler(const RobotModel& robot, const Arm& arm, const PerAxis<Radians>& position) noexcept;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  // Cancels the plan and stands at `position`.
  void reset_to(const PerAxis<Radians>& position) noexcept;

  // Starts `plan`, which begins at the present position, at `rate` 0..1. Call only while no plan is active. What its
  // pieces name must stay as it is while it is active.
  void start(const Plan& plan, double rate) noexcept;
  // The same for a joint chain of one move that begins at state(), at the rate 1. It replaces an active plan.
  void start_in_motion(const JointChain& chain) noexcept;
  // True while the active plan can be replaced by `next`, which continues it, also during a change of the rate unless
  // that would have to limit the jerk from then on. Before, it returns false, and afterwards it never returns true
  // again.
  [[nodiscard]] bool can_continue_with(const CartesianPlan& next) const noexcept;
  // True when it is too late for that.
  [[nodiscard]] bool missed(const CartesianPlan& next) const noexcept;
  // Replaces the active plan while can_continue_with().
  void continue_with(const CartesianPlan& next) noexcept;

  // The set-point of the next tick; the last one again if no plan is active. The rate changes towards `rate`, 0..1, as
  // fast as the joints and the limits of the move allow; see path_clock.hpp.
  const PerAxis<Radians>& advance(double rate) noexcept;

  // The same for a protective stop: the rate decreases to 0 as fast as the joints' accelerations allow. The limits of
  // the tool and the jerk are ignored.
  const PerAxis<Radians>& brake() noexcept;

  // True while a plan is active; its rate may be 0.
  [[nodiscard]] bool busy() const noexcept { return busy_; }
  [[nodiscard]] const PerAxis<Radians>& position() const noexcept { return position_; }
  // The state of motion at the last set-point, for a plan that begins there. Exact for joint plans at a constant rate,
  // otherwise that of state_after(): its acceleration is that of a tick ago.
  [[nodiscard]] PerAxis<AxisState> state() const noexcept;
  // The rate may stay as it is in any tick: it does not change, or its changes do not limit the jerk.
  [[nodiscard]] bool may_keep_rate() const noexcept { return clock_.steady() || !clock_.limits_jerk(); }
  // Path time per time in the last tick, 0..1; 0 if no plan was active.
  [[nodiscard]] double rate() const noexcept { return rate_; }

  // The active plan, and how much of it has been executed, in ticks of its own time. That is also valid after its end.
  [[nodiscard]] const Plan& plan() const noexcept { return plan_; }
  [[nodiscard]] double elapsed() const noexcept { return clock_.time(); }

  // Inverse kinematics computed by the last advance() or brake(), at most kMaxInverses: none for a joint plan, one
  // while the rate is constant, at most PathClock::kMaxEvaluations while it changes. Up to FollowedTool::kMaxInverses
  // times as many where |sin(theta_5)| < 1e-3 (follow_tool()); there fewer rates are tried.
  static constexpr int kMaxInverses = 3 * FollowedTool::kMaxInverses;
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  void take(const Plan& plan) noexcept;
  void restart_clock(double rate, bool in_motion) noexcept;
  [[nodiscard]] PerAxis<Radians> at(double ticks) noexcept;
  [[nodiscard]] ToolStep tool_step(double from, double to) noexcept;
  // tool_sample() of a path of the active plan, until the next call that does not `keep` it. A change of the rate needs
  // those of the last two ticks again, and those of the joints that it tries.
  [[nodiscard]] const ToolSample& tool_at(const CartesianPlan& path, double ticks,
                                          const ToolSample* keep = nullptr) noexcept;
  void forget_samples() noexcept;
  [[nodiscard]] double plan_jerk(double from, double to) const noexcept;
  void finish_if_over() noexcept;
  [[nodiscard]] bool may_try() const noexcept { return inverses_ + 2 * FollowedTool::kMaxInverses <= kMaxInverses; }

  const RobotModel& robot_;
  const Arm& arm_;
  PerAxis<Radians> position_;
  Plan plan_{};  // empty before the first one
  Ticks duration_{};
  PathClock clock_;
  PlanRun run_{};  // of a plan that is a path
  struct Sample {
    const CartesianPlan* path = nullptr;
    double ticks = 0.0;
    ToolSample tool{};
  };
  std::array<Sample, 6> samples_{};  // the latest of tool_at(): usually two of each tick
  std::size_t sample_count_ = 0, oldest_sample_ = 0;
  bool busy_ = false;
  double rate_ = 0.0;
  int inverses_ = 0;
};

}  // namespace armature
