// One pass over all set-points of a plan, in order, at every tick. It checks that they can be reached inside the
// joints' limits, and where the motion must be slower (path_check.hpp).
//
// After a set-point that cannot be reached, a pass continues to the end of the segment, to find how far the rest of the
// segment exceeds the reach.
#pragma once

#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/check/joint_trail.hpp"
#include "controller/trajectory/check/kink_check.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/path/path_problem.hpp"

namespace armature {

class PathPass {
 public:
  // kDone: every set-point can be reached. kFailed: see problem().
  enum class Progress : std::uint8_t { kWorking, kDone, kFailed };

  // Robot and arm must outlive the pass.
  PathPass(const RobotModel& robot, const Arm& arm) noexcept;

  // On a bend the tool point may be off its path by this much: rounding.
  static constexpr double kPointTolerance_mm = 1e-8;

  // Starts where `plan` starts, which takes at least one tick and must be the same for all step()s of a pass.
  void begin(const CartesianPlan& plan) noexcept;
  // Processes the next set-point with one inverse kinematics. More are computed at a passage of the wrist singularity
  // (FollowedTool::inverses), before a kink of a time law and at the first set-point (KinkCheck). Stores the
  // orientation error residual_rad and jerk_use in the plan's segments.
  Progress step(CartesianPlan& plan) noexcept;

  // Inverse kinematics computed by the last step(), at most kMaxInverses.
  static constexpr int kMaxInverses = (KinkCheck::kMax + 1) * FollowedTool::kMaxInverses;
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

  // The last set-point; at the end of a pass with kDone it is the end of the plan.
  [[nodiscard]] const JointAngles& joints() const noexcept { return joints_; }

  // The joints at some set-points of the last pass.
  [[nodiscard]] const JointTrail& trail() const noexcept { return trail_; }

  // The excess that the last step() found.
  [[nodiscard]] const PathCheck::Place& latest() const noexcept { return latest_; }

  // Valid with kFailed: kUnreachable, kOutsideLimits, kOrientation, kInvalidPose or kOtherConfiguration.
  [[nodiscard]] const PathProblem& problem() const noexcept { return problem_; }
  // kFailed on a segment with a rounded corner, so an exact stop there might be possible.
  [[nodiscard]] bool failed_in_corner() const noexcept { return failed_in_corner_; }

 private:
  // Sets the rotation of `sample` to that of the arm, and the status of `tracking` if the tool leaves its point or
  // turns away too far.
  void check_bend(const CartesianPlan& plan, IkTracking& tracking, ToolSample& sample) const noexcept;
  [[nodiscard]] ToolSample sample_between(const CartesianPlan& plan, double t_s) noexcept;
  // Of a plan that continues another one: the last tick whose differences do not count.
  static constexpr std::int64_t kKnownTicks = 6;
  static_assert(kKnownTicks < CartesianPlan::kSharedTicks.value());

  void record_failure(const CartesianPlan& plan, const IkTracking& tracking) noexcept;

  const Arm& arm_;
  PathCheck check_;
  KinkCheck kinks_;
  JointTrail trail_;
  std::int64_t tick_ = 0;
  int inverses_ = 0;
  JointAngles joints_{};
  PathCheck::Place latest_{};
  PathProblem problem_{};
  bool failed_in_corner_ = false;
  std::int64_t failed_until_ = 0;  // > 0: failed; the set-points up to this tick are still checked
};

}  // namespace armature
