// Turns the plan that is being executed into one set-point per tick.
#pragma once

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"
#include "controller/trajectory/run/path_clock.hpp"

namespace armature {

class Sampler {
 public:
  // Stands at `position`. Robot and arm must outlive the sampler.
  Sampler(const RobotModel& robot, const Arm& arm, const PerAxis<Radians>& position) noexcept;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  // Gives up what it does and stands at `position`.
  void stand_at(const PerAxis<Radians>& position) noexcept;

  // Executes `plan`, which begins where the sampler stands, at `rate` 0..1. Only while it stands.
  void start(const MotionPlan& plan, double rate) noexcept;

  // The set-point of the next tick; the last one again while there is no plan. The rate goes towards `rate`, 0..1, as
  // fast as the joints and the limits of the move let it; see path_clock.hpp.
  const PerAxis<Radians>& advance(double rate) noexcept;

  // The same for a protective stop: the rate goes to 0 as fast as the joints' accelerations let it. The limits of the
  // tool are not looked at, nor is jerk.
  const PerAxis<Radians>& brake() noexcept;

  // A plan is under way; it may stand, at a rate of 0.
  [[nodiscard]] bool busy() const noexcept { return busy_; }
  [[nodiscard]] const PerAxis<Radians>& position() const noexcept { return position_; }
  // Path time per time in the last tick, 0..1; 0 when no plan was under way.
  [[nodiscard]] double rate() const noexcept { return rate_; }

  // The plan that was started last, and how far it has been executed, in ticks of its own time.
  [[nodiscard]] const MotionPlan& plan() const noexcept { return plan_; }
  [[nodiscard]] double elapsed() const noexcept { return clock_.time(); }

  // Inverse kinematics that the last advance() or brake() computed, at most kMostInverses: none for a plan of joints,
  // one while the rate is the one wanted, at most PathClock::kMostEvaluations while it changes; up to
  // FollowedTool::kMostInverses times as many where |sin(theta_5)| < 1e-3 (follow_tool()), where fewer rates are tried.
  static constexpr int kMostInverses = 3 * FollowedTool::kMostInverses;
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

 private:
  [[nodiscard]] PerAxis<Radians> at(double ticks) noexcept;
  [[nodiscard]] ToolStep tool_step(double from, double to) const noexcept;
  void arrive_when_over() noexcept;
  [[nodiscard]] bool may_try() const noexcept { return inverses_ + 2 * FollowedTool::kMostInverses <= kMostInverses; }

  const RobotModel& robot_;
  const Arm& arm_;
  PerAxis<Radians> position_;
  MotionPlan plan_;
  Ticks duration_{};
  PathClock clock_;
  PlanRun run_{};  // of a path
  bool busy_ = false;
  double rate_ = 0.0;
  int inverses_ = 0;
};

}  // namespace armature
