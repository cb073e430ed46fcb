// One pass over a plan, in order of time. It checks that its set-points can be reached inside the joints' limits, and
// where the motion must be slower (path_check.hpp).
//
// Where bounds show that no set-point exceeds a limit (path_bounds.hpp), none is computed. Those of the other times are
// computed and checked at every tick, with some before and after: a difference over ticks must be within one of both.
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
#include "controller/trajectory/check/path_bounds.hpp"
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
  // Processes the next set-point with one inverse kinematics, or takes a step of the bounds. More are computed at a
  // passage of the wrist singularity (FollowedTool::inverses), before a kink of a time law and at the first set-point
  // (KinkCheck), and after a time without set-points. Stores the orientation error residual_rad and jerk_use in the
  // plan's segments.
  Progress step(CartesianPlan& plan) noexcept;

  // Inverse kinematics computed by the last step(), at most kMaxInverses.
  static constexpr int kMaxInverses = (KinkCheck::kMax + 1) * FollowedTool::kMaxInverses;
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

  // The last set-point; at the end of a pass with kDone it is the end of the plan.
  [[nodiscard]] const JointAngles& joints() const noexcept { return joints_; }

  // The set-point of the plan of the last pass, which was kDone, at a tick. Adds the number of inverse kinematics, at
  // most kMaxInverses.
  [[nodiscard]] JointAngles joints_at(const CartesianPlan& plan, std::int64_t tick,
                                      std::int64_t& inverses) const noexcept;

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

  // Set-points before an unknown time, and behind it: a difference and its kink are over at most so many.
  static constexpr std::int64_t kBefore = 8, kBehind = 4;
  // Of kBefore: their differences are not known yet.
  static constexpr std::int64_t kWithoutDifferences = 5;
  // More set-points than these are left out at a time.
  static constexpr std::int64_t kFewest = 8;

  Progress check_set_point(CartesianPlan& plan) noexcept;
  void step_bounds(CartesianPlan& plan) noexcept;
  void check_between(const CartesianPlan& plan, double from, double to) noexcept;
  void record_failure(const CartesianPlan& plan, const IkTracking& tracking) noexcept;

  const Arm& arm_;
  PathCheck check_;
  KinkCheck kinks_;
  PathBounds bounds_;
  JointTrail trail_;
  std::int64_t tick_ = 0;             // the last set-point that was checked
  std::int64_t until_ = 0;            // those up to here must be
  std::int64_t no_differences_ = -1;  // up to here
  bool first_ = true;
  bool unknown_ = false;  // the last time of the bounds was
  int inverses_ = 0;
  JointAngles joints_{};
  PathCheck::Place latest_{};
  PathProblem problem_{};
  bool failed_in_corner_ = false;
  std::int64_t failed_until_ = 0;  // > 0: failed; the set-points up to this tick are still checked
};

}  // namespace armature
