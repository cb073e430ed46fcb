// One pass over all set-points of a plan, in order, at every tick: can they be reached, inside the joints' limits, and
// how much slower would the segments have to be (path_check.hpp)?
//
// A pass that meets a set-point that cannot be reached goes on to the end of its segment, to know by how much the rest
// of the segment is beyond.
#pragma once

#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/kink_check.hpp"
#include "controller/trajectory/plan/path_check.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"

namespace armature {

class PathPass {
 public:
  // kDone: every set-point can be reached; excess() tells whether it is slow enough. kFailed: problem() tells.
  enum class Progress : std::uint8_t { kWorking, kDone, kFailed };

  // Robot and arm must outlive the pass.
  PathPass(const RobotModel& robot, const Arm& arm) noexcept;

  // At the start of `plan`, which takes at least one tick and is the same for all step()s of a pass.
  void begin(const CartesianPlan& plan) noexcept;
  // The next set-point, by one inverse kinematics; at a passage of the wrist singularity by FollowedTool::inverses, and
  // before a kink of a time law, and at the first set-point, by those of KinkCheck.
  // Notes in the plan's segments by how much they miss orientations, residual_rad, and when it is kDone rate_bend.
  Progress step(CartesianPlan& plan) noexcept;

  // Inverse kinematics that the last step() computed, at most kMostInverses.
  static constexpr int kMostInverses = (KinkCheck::kMost + 1) * FollowedTool::kMostInverses;
  [[nodiscard]] int inverses() const noexcept { return inverses_; }

  // The last set-point: at the end of a pass that is kDone, where the plan ends.
  [[nodiscard]] const JointAngles& joints() const noexcept { return joints_; }

  // kDone.
  [[nodiscard]] PathCheck::PerSegment excess(const CartesianPlan& plan) const noexcept { return check_.excess(plan); }

  // kFailed: kUnreachable, kOutsideLimits, kOrientation or kInvalidPose.
  [[nodiscard]] const PathProblem& problem() const noexcept { return problem_; }
  // kFailed: two segments were under way, so an exact stop there might do.
  [[nodiscard]] bool failed_in_corner() const noexcept { return failed_in_corner_; }

 private:
  void note_failure(const CartesianPlan& plan, const IkTracking& tracking) noexcept;

  const Arm& arm_;
  PathCheck check_;
  KinkCheck kinks_;
  BendMeter bend_;
  std::int64_t tick_ = 0;
  int inverses_ = 0;
  JointAngles joints_{};
  PathProblem problem_{};
  bool failed_in_corner_ = false;
  std::int64_t failed_until_ = 0;  // > 0: failed; the set-points up to this tick are looked at, too
};

}  // namespace armature
