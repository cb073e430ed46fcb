// How the machine knows where the arm and the positions of a program are: poses of the tool, and joints.
//
// The end of a path is known as a pose, and its joints only when the arm stands there. So nothing here waits for them
// where they do not decide.
#include "controller/base/angle_units.hpp"
#include "controller/language/job/machine.hpp"
#include "controller/language/job/rconf.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::job {

Transform Machine::pose_of(const PositionValue& position) noexcept {
  const auto& v = position.value;
  return {.rotation = rotation_from_rpy(direction_rad(v[3]), direction_rad(v[4]), direction_rad(v[5])),
          .position_mm = {v[0], v[1], v[2]}};
}

Transform Machine::tool_at(const JointAngles& joints) const noexcept {
  return setup_.cell.arm.forward(joints) * setup_.cell.flange_T_tool;
}

bool Machine::know_joints() noexcept {
  if (planned_.joints) return true;
  if (!wait_until_done()) return false;
  planned_.joints = port_->joints();
  return true;
}

bool Machine::know_pose() noexcept {
  if (planned_.base_T_tool) return true;
  if (!know_joints()) return false;
  planned_.base_T_tool = tool_at(*planned_.joints);
  return true;
}

bool Machine::pose_at(const PositionValue& target, Transform& base_T_tool, std::optional<JointAngles>& joints,
                      Solve solve) noexcept {
  joints.reset();
  std::uint8_t posture = target.rconf;
  if (!target.is_cartesian()) {
    JointAngles stated{};
    for (std::size_t i = 0; i < setup_.cell.robot.axis_count; ++i) {
      const double unit =
          target.frame == Frame::kPulse ? AxisUnits{setup_.cell.robot.axes[i]}.rad_per_pulse() : kRadPerDeg;
      stated[i] = Radians{target.value[i] * unit};
    }
    joints = stated;
    if (!setup_.cell.arm.known()) return base_shift_ ? fail(Alarm::kReach) : true;
    base_T_tool = tool_at(stated);
    if (!base_shift_ && !tool_shift_) return true;
    posture = static_cast<std::uint8_t>(rconf_of(setup_.cell.arm, stated) | Position::kHasRconf);
    base_T_tool = base_T_tool * arm_T_tool(target.tool);
  } else {
    Transform base_T_frame;
    if (!frame_of(target.frame, target.user, base_T_frame)) return false;
    base_T_tool = base_T_frame * pose_of(target);
  }
  if (base_shift_) {
    base_T_tool.position_mm += *shift_mm_;
    base_T_tool.rotation = base_shift_->rotation * base_T_tool.rotation;
  } else if (tool_shift_) {
    base_T_tool = base_T_tool * *tool_shift_;
  }
  base_T_tool = base_T_tool * inverse(arm_T_tool(target.tool));
  joints.reset();
  if (solve == Solve::kNothing || (posture & Position::kHasRconf) == 0) return true;
  return solve_posture(base_T_tool, posture, solve, joints);
}

// The joints before it decide only about an angle that is free, and about whole turns. Without a solution they may,
// too.
bool Machine::solve_posture(const Transform& base_T_tool, std::uint8_t posture, Solve solve,
                            std::optional<JointAngles>& joints) noexcept {
  if (needs_joints_ && !know_joints()) return false;
  port_->charge_inverses(static_cast<std::int64_t>(IkSolutions::kMax));
  const auto found = joints_of(setup_.cell.robot, setup_.cell.arm, base_T_tool * inverse(setup_.cell.flange_T_tool),
                               posture, planned_.joints.value_or(JointAngles{}));
  const bool only = found && !found->free_angle && !(found->several_turns && solve == Solve::kJoints);
  if (!planned_.joints && !only) {
    needs_joints_ = true;
    return solve_posture(base_T_tool, posture, solve, joints);
  }
  if (!found) return fail(Alarm::kPosture);
  joints = found->joints;
  return true;
}

bool Machine::target_of(const PositionValue& target, std::optional<JointAngles>& joints,
                        Transform& base_T_tool) noexcept {
  if (!pose_at(target, base_T_tool, joints, Solve::kJoints)) return false;
  if (joints) return true;
  // No posture is stated: the one nearest to the joints before. Where these are not known, the dispatcher chooses it.
  if (!planned_.joints && !port_->done()) return true;
  if (!know_joints()) return false;
  port_->charge_inverses(static_cast<std::int64_t>(IkSolutions::kMax));
  const IkTracking solution =
      setup_.cell.arm.soonest(base_T_tool * inverse(setup_.cell.flange_T_tool), *planned_.joints);
  if (!solved(solution.status)) return fail(Alarm::kReach);
  joints = solution.joints;
  return true;
}

}  // namespace armature::job
