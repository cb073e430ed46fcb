#include "controller/language/job/execute/planned_arm.hpp"

#include "controller/language/job/state/rconf.hpp"

namespace armature::job {

void PlannedArm::set(const std::optional<JointAngles>& joints, const Transform& base_T_tool) noexcept {
  joints_ = joints;
  if (positions_.cell().arm.known()) base_T_tool_ = joints ? positions_.tool_at(*joints) : base_T_tool;
}

bool PlannedArm::know_joints(Step& step) noexcept {
  if (joints_) return true;
  if (!step.wait_until_done()) return false;
  joints_ = step.port().joints();
  return true;
}

bool PlannedArm::know_pose(Step& step) noexcept {
  if (base_T_tool_) return true;
  if (!know_joints(step)) return false;
  base_T_tool_ = positions_.tool_at(*joints_);
  return true;
}

// The joints before it decide only about an angle that is free, and about whole turns. Without a solution they may,
// too.
bool PlannedArm::solve(Step& step, Solve wanted, Target& target) noexcept {
  if (target.joints || (target.rconf & Position::kHasRconf) == 0) return true;
  if (needs_joints_ && !know_joints(step)) return false;
  step.port().charge_inverses(static_cast<std::int64_t>(IkSolutions::kMax));
  const RobotCell& cell = positions_.cell();
  const auto found = job::joints_of(cell.robot, cell.arm, target.base_T_tool * inverse(cell.flange_T_tool),
                                    target.rconf, joints_.value_or(JointAngles{}));
  const bool only = found && !found->free_angle && !(found->several_turns && wanted == Solve::kJoints);
  if (!joints_ && !only) {
    needs_joints_ = true;
    return solve(step, wanted, target);
  }
  if (!found) return step.fail(Alarm::kPosture);
  target.joints = found->joints;
  return true;
}

bool PlannedArm::solve_joint_move(Step& step, Target& target) noexcept {
  if (!solve(step, Solve::kJoints, target)) return false;
  if (target.joints) return true;
  // No posture is stated: the one nearest to the joints before. Where these are not known, the dispatcher chooses it.
  if (!joints_ && !step.port().done()) return true;
  if (!know_joints(step)) return false;
  step.port().charge_inverses(static_cast<std::int64_t>(IkSolutions::kMax));
  const RobotCell& cell = positions_.cell();
  const IkTracking solution = cell.arm.soonest(target.base_T_tool * inverse(cell.flange_T_tool), *joints_);
  if (!solved(solution.status)) return step.fail(Alarm::kReach);
  target.joints = solution.joints;
  return true;
}

}  // namespace armature::job
