#include "controller/language/job/execute/positions.hpp"

#include <Eigen/Geometry>

#include "controller/base/angle_units.hpp"
#include "controller/language/job/state/rconf.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::job {
namespace {

constexpr double kLeastArea = 1e-6;  // of the triangle of a frame, over the squares of its sides

// The value of a pose; `like` has its tool and its posture.
PositionValue cartesian_value(const Transform& frame_T_tool, Frame frame, double user,
                              const PositionValue& like) noexcept {
  const RollPitchYaw angles = rpy_from_rotation(frame_T_tool.rotation);
  const Eigen::Vector3d& p = frame_T_tool.position_mm;
  return {.value = {p.x(), p.y(), p.z(), angles.roll_rad * kDegPerRad, angles.pitch_rad * kDegPerRad,
                    angles.yaw_rad * kDegPerRad},
          .frame = frame,
          .user = static_cast<std::uint8_t>(user),
          .tool = like.tool,
          .rconf = like.rconf,
          .set = true};
}

// Nothing when the points are on one line.
std::optional<Transform> frame_through(const std::array<Eigen::Vector3d, 3>& points_mm) noexcept {
  const Eigen::Vector3d x = points_mm[1] - points_mm[0], in_plane = points_mm[2] - points_mm[0];
  const Eigen::Vector3d z = x.cross(in_plane);
  if (!(z.norm() > kLeastArea * (x.squaredNorm() + in_plane.squaredNorm()))) return std::nullopt;
  Transform frame{.position_mm = points_mm[0]};
  frame.rotation.col(0) = x / x.norm();
  frame.rotation.col(2) = z / z.norm();
  frame.rotation.col(1) = frame.rotation.col(2).cross(frame.rotation.col(0));
  return frame;
}

}  // namespace

Transform Shift::shifted(const Transform& base_T_tool) const noexcept {
  if (in_base) {
    return {.rotation = in_base->rotation * base_T_tool.rotation,
            .position_mm = base_T_tool.position_mm + in_base->position_mm};
  }
  return in_tool ? base_T_tool * *in_tool : base_T_tool;
}

Transform Positions::pose_of(const PositionValue& position) noexcept {
  const auto& v = position.value;
  return {.rotation = rotation_from_rpy(direction_rad(v[3]), direction_rad(v[4]), direction_rad(v[5])),
          .position_mm = {v[0], v[1], v[2]}};
}

JointAngles Positions::joints_of(const PositionValue& position) const noexcept {
  JointAngles joints{};
  for (std::size_t i = 0; i < cell_.robot.axis_count; ++i) {
    const double unit = position.frame == Frame::kPulse ? AxisUnits{cell_.robot.axes[i]}.rad_per_pulse() : kRadPerDeg;
    joints[i] = Radians{position.value[i] * unit};
  }
  return joints;
}

PositionValue Positions::pulses_of(const JointAngles& joints) const noexcept {
  PositionValue position{.tool = tools_.present(), .set = true};
  for (std::size_t i = 0; i < cell_.robot.axis_count; ++i) {
    position.value[i] = static_cast<double>(AxisUnits{cell_.robot.axes[i]}.to_pulses(joints[i]).value());
  }
  return position;
}

std::uint8_t Positions::posture_of(const JointAngles& joints) const noexcept {
  return static_cast<std::uint8_t>(rconf_of(cell_.arm, joints) | Position::kHasRconf);
}

Alarm Positions::find(const PositionValue& position, const Shift& shift, Target& target) const noexcept {
  target = {.rconf = position.rconf};
  if (position.is_cartesian()) {
    Transform base_T_frame;
    const Alarm alarm = find_frame(position.frame, position.user, base_T_frame);
    if (alarm != Alarm::kNone) return alarm;
    target.base_T_tool = base_T_frame * pose_of(position);
  } else {
    const JointAngles joints = joints_of(position);
    const bool known = cell_.arm.known();
    if (known) target.base_T_tool = tool_at(joints);
    if (!known || !shift.any()) {
      target.joints = joints;
      return !known && shift.in_base ? Alarm::kReach : Alarm::kNone;
    }
    target.rconf = posture_of(joints);
    target.base_T_tool = target.base_T_tool * tools_.arm_T_tool(position.tool);
  }
  target.base_T_tool = shift.shifted(target.base_T_tool) * inverse(tools_.arm_T_tool(position.tool));
  return Alarm::kNone;
}

Alarm Positions::find_frame(Frame frame, double user, Transform& base_T_frame) const noexcept {
  base_T_frame = {};
  if (frame == Frame::kRobot || frame == Frame::kBase) return Alarm::kNone;
  if (frame != Frame::kUser) return Alarm::kUnsupported;
  if (!(user >= 1.0 && user <= static_cast<double>(kUserFrames))) return Alarm::kFrame;
  const std::optional<Transform>& stated = cell_.base_T_user[static_cast<std::size_t>(user) - 1];
  if (!stated) return Alarm::kFrame;
  base_T_frame = *stated;
  return Alarm::kNone;
}

bool Positions::read_frame(Step& step, OperandReader& operands, FrameOperand& frame) const noexcept {
  frame = {};
  if (operands.at_end() || operands.take(Word::kBaseFrame)) return true;
  if (operands.is(OperandKind::kIo)) {
    frame.frame = Frame::kUser;
    return operands.io_number(frame.user) && step.check(find_frame(frame.frame, frame.user, frame.base_T_frame));
  }
  frame.frame = Frame::kRobot;
  return operands.take(Word::kRobotFrame) || step.fail(Alarm::kUnsupported);
}

bool Positions::set_shift(Step& step, OperandReader& operands) noexcept {
  const PositionValue* shift = operands.set_position_variable();
  if (shift == nullptr) return false;
  if (!shift->is_cartesian()) return step.fail(Alarm::kTypes);
  const Transform by = pose_of(*shift);
  if (operands.is(Word::kToolFrame)) {
    shift_ = {.in_tool = by};
    return true;
  }
  FrameOperand frame;
  if (!read_frame(step, operands, frame)) return false;
  const Eigen::Matrix3d& r = frame.base_T_frame.rotation;
  shift_ = {.in_base = Transform{.rotation = r * by.rotation * r.transpose(), .position_mm = r * by.position_mm}};
  return true;
}

bool Positions::end_shift(Step&, OperandReader&) noexcept {
  shift_ = {};
  return true;
}

bool Positions::make_frame(Step& step, OperandReader& operands) noexcept {
  double user = 0.0;
  if (!operands.io_number(user)) return false;
  if (!(user >= 1.0 && user <= static_cast<double>(kUserFrames))) return step.fail(Alarm::kFrame);
  std::array<Eigen::Vector3d, 3> points_mm;
  for (Eigen::Vector3d& point_mm : points_mm) {
    const PositionValue* position = operands.set_position_variable();
    Target target;
    if (position == nullptr || !step.check(find(*position, target))) return false;
    point_mm = (target.base_T_tool * tools_.arm_T_tool(position->tool)).position_mm;
  }
  const std::optional<Transform> frame = frame_through(points_mm);
  if (!frame) return step.fail(Alarm::kRelation);
  cell_.base_T_user[static_cast<std::size_t>(user) - 1] = frame;
  return true;
}

bool Positions::convert(Step& step, OperandReader& operands) const noexcept {
  PositionValue* to = operands.position_variable();
  if (to == nullptr) return false;
  const PositionValue* from = operands.set_position_variable();
  if (from == nullptr) return false;
  PositionValue source = *from;
  FrameOperand frame;
  Target target;
  if (!read_frame(step, operands, frame) || !step.check(find(source, {}, target))) return false;
  if (target.joints) source.rconf = posture_of(*target.joints);
  *to = cartesian_value(inverse(frame.base_T_frame) * target.base_T_tool * tools_.arm_T_tool(source.tool), frame.frame,
                        frame.user, source);
  return true;
}

bool Positions::get_system(Step& step, OperandReader& operands) const noexcept {
  OperandReader source = operands;
  source.skip();
  const Operand& system = source.here();
  if (source.is(OperandKind::kVariable) && system.what == static_cast<std::uint8_t>(VariableType::kReturn)) {
    VariableId id;
    return operands.variable(id) && operands.store(id, operands.variables().returned());
  }
  const bool place =
      system.what == static_cast<std::uint8_t>(VariableType::kP) && (system.flags & Operand::kSystem) != 0;
  if (!place || system.a > 1) return step.fail(Alarm::kUnsupported);
  if (!step.wait_until_done()) return false;
  PositionValue* position = operands.position_variable();
  if (position == nullptr) return false;
  const JointAngles joints = step.port().joints();
  if (system.a == 0) {
    *position = pulses_of(joints);
    return true;
  }
  const std::uint8_t tool = tools_.present();
  *position = cartesian_value(tool_at(joints) * tools_.arm_T_tool(tool), Frame::kBase, 0.0,
                              {.tool = tool, .rconf = posture_of(joints)});
  return true;
}

}  // namespace armature::job
