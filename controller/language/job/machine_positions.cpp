// How the machine calculates with positions and frames.
#include <Eigen/Geometry>
#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/language/job/machine.hpp"
#include "controller/language/job/rconf.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::job {
namespace {

constexpr double kUnitsPerMm = 1'000.0;
constexpr double kUnitsPerDegree = 10'000.0;
constexpr double kLeastArea = 1e-6;  // of the triangle of a frame, over the squares of its sides

// How many units of SETE and GETE one unit of a position has.
double units_of(const PositionValue& position, std::size_t element) noexcept {
  if (position.frame == Frame::kPulse) return 1.0;
  return position.is_cartesian() && element < 3 ? kUnitsPerMm : kUnitsPerDegree;
}

}  // namespace

// ADD and SUB of two positions of one kind; MUL and DIV by a number.
Machine::Outcome Machine::calculate_position(std::size_t at, PositionValue& result) noexcept {
  if (!result.set) return (void)fail(Alarm::kNotSet), outcome_;
  const Op op = here().op;
  if (op == Op::kMul || op == Op::kDiv) {
    double factor = 0.0;
    if (is_position_variable(at)) return (void)fail(Alarm::kTypes), outcome_;
    if (!number(at, factor)) return outcome_;
    if (op == Op::kDiv && factor == 0.0) return (void)fail(Alarm::kDivision), outcome_;
    for (double& value : result.value) value = op == Op::kMul ? value * factor : value / factor;
    return Outcome::kNext;
  }
  if ((op != Op::kAdd && op != Op::kSub) || !is_position_variable(at)) return (void)fail(Alarm::kTypes), outcome_;
  const PositionValue* other = position_variable(at);
  if (other == nullptr) return outcome_;
  if (!other->set) return (void)fail(Alarm::kNotSet), outcome_;
  const bool alike = result.is_cartesian() ? other->is_cartesian() : other->frame == result.frame;
  if (!alike) return (void)fail(Alarm::kTypes), outcome_;
  for (std::size_t i = 0; i < result.value.size(); ++i) {
    result.value[i] += op == Op::kAdd ? other->value[i] : -other->value[i];
  }
  return Outcome::kNext;
}

Machine::Outcome Machine::set_element() noexcept {
  std::size_t at = 0;
  PositionValue* position = position_variable(at);
  if (position == nullptr) return outcome_;
  double element = 0.0, value = 0.0;
  if (!number(++at, element)) return outcome_;
  if (!number(++at, value)) return outcome_;
  if (!(element >= 0.0 && element <= 6.0)) return (void)fail(Alarm::kIndex), outcome_;
  // A variable that was not set becomes a position in the base.
  if (!position->set) *position = {.frame = Frame::kBase, .set = true};
  for (std::size_t i = 0; i < position->value.size(); ++i) {
    if (element == 0.0 || i + 1 == static_cast<std::size_t>(element))
      position->value[i] = value / units_of(*position, i);
  }
  return Outcome::kNext;
}

Machine::Outcome Machine::get_element() noexcept {
  std::size_t at = 0;
  VariableId id;
  if (!variable(at, id)) return outcome_;
  const PositionValue* position = position_variable(at);
  if (position == nullptr) return outcome_;
  double element = 0.0;
  if (!number(++at, element)) return outcome_;
  if (!(element >= 1.0 && element <= 6.0)) return (void)fail(Alarm::kIndex), outcome_;
  if (!position->set) return (void)fail(Alarm::kNotSet), outcome_;
  const std::size_t i = static_cast<std::size_t>(element) - 1;
  // 1e-6 of a unit is rounding: 0.3 mm are 300 units, not 299.
  const double units = position->value[i] * units_of(*position, i);
  const double rounded = std::floor(units + 0.5);
  const bool whole = std::fabs(units - rounded) < 1e-6;
  return check(variables_.store(id, whole ? rounded : units)) ? Outcome::kNext : outcome_;
}

// $PX000: the present pulses. $PX001: the present pose in the base. $RV: the value of RET.
Machine::Outcome Machine::get_system() noexcept {
  std::size_t from = 0, at = 0;
  skip(from);
  const Operand& system = operand(from);
  if (system.kind == OperandKind::kVariable && system.what == static_cast<std::uint8_t>(VariableType::kReturn)) {
    VariableId id;
    return variable(at, id) && check(variables_.store(id, returned_)) ? Outcome::kNext : outcome_;
  }
  const bool pose =
      system.what == static_cast<std::uint8_t>(VariableType::kP) && (system.flags & Operand::kSystem) != 0;
  if (!pose || system.a > 1) return (void)fail(Alarm::kUnsupported), outcome_;
  if (!wait_until_done()) return outcome_;
  PositionValue* position = position_variable(at);
  if (position == nullptr) return outcome_;
  const JointAngles joints = port_->joints();
  if (system.a == 1) {
    *position =
        cartesian_value(tool_at(joints) * arm_T_tool(tool_.value_or(0)), Frame::kBase, 0, {.tool = tool_.value_or(0)});
    position->rconf = static_cast<std::uint8_t>(rconf_of(setup_.cell.arm, joints) | Position::kHasRconf);
    return Outcome::kNext;
  }
  *position = {.tool = tool_.value_or(0), .set = true};
  for (std::size_t i = 0; i < setup_.cell.robot.axis_count; ++i) {
    position->value[i] = static_cast<double>(AxisUnits{setup_.cell.robot.axes[i]}.to_pulses(joints[i]).value());
  }
  return Outcome::kNext;
}

PositionValue Machine::cartesian_value(const Transform& frame_T_tool, Frame frame, std::uint8_t user,
                                       const PositionValue& like) const noexcept {
  const RollPitchYaw angles = rpy_from_rotation(frame_T_tool.rotation);
  const Eigen::Vector3d& p = frame_T_tool.position_mm;
  return {.value = {p.x(), p.y(), p.z(), angles.roll_rad * kDegPerRad, angles.pitch_rad * kDegPerRad,
                    angles.yaw_rad * kDegPerRad},
          .frame = frame,
          .user = user,
          .tool = like.tool,
          .rconf = like.rconf,
          .set = true};
}

// CNVRT: the same place of the tool, in a frame.
Machine::Outcome Machine::convert() noexcept {
  std::size_t at = 0;
  PositionValue* to = position_variable(at);
  if (to == nullptr) return outcome_;
  const PositionValue* from = position_variable(at);
  if (from == nullptr) return outcome_;
  PositionValue source = *from;
  if (!source.set) return (void)fail(Alarm::kNotSet), outcome_;
  std::size_t frame_at_operand = at;
  Transform base_T_frame;
  if (!frame_at(at, base_T_frame)) return outcome_;
  const bool user_frame = operand(frame_at_operand).kind == OperandKind::kIo;
  double user = 0.0;
  if (user_frame && !number(++frame_at_operand, user)) return outcome_;
  std::optional<JointAngles> joints;
  Transform base_T_tool;
  const auto shifts = std::pair{base_shift_, tool_shift_};
  base_shift_.reset(), tool_shift_.reset();  // a conversion is not shifted
  const bool known = pose_at(source, base_T_tool, joints, Solve::kNothing);
  std::tie(base_shift_, tool_shift_) = shifts;
  if (!known) return outcome_;
  if (joints) source.rconf = static_cast<std::uint8_t>(rconf_of(setup_.cell.arm, *joints) | Position::kHasRconf);
  const Frame frame = user_frame                                     ? Frame::kUser
                      : is_word(frame_at_operand, Word::kRobotFrame) ? Frame::kRobot
                                                                     : Frame::kBase;
  *to = cartesian_value(inverse(base_T_frame) * base_T_tool * arm_T_tool(source.tool), frame,
                        static_cast<std::uint8_t>(user), source);
  return Outcome::kNext;
}

// MFRAME: origin, a point on x, a point in the half plane of xy with y above 0.
Machine::Outcome Machine::make_frame() noexcept {
  std::size_t at = 1;
  double user = 0.0;
  if (!number(at, user)) return outcome_;
  if (!(user >= 1.0 && user <= static_cast<double>(kUserFrames))) return (void)fail(Alarm::kFrame), outcome_;
  std::array<Eigen::Vector3d, 3> points_mm;
  for (Eigen::Vector3d& point_mm : points_mm) {
    const PositionValue* position = position_variable(at);
    if (position == nullptr) return outcome_;
    if (!position->set) return (void)fail(Alarm::kNotSet), outcome_;
    Transform base_T_tool;
    std::optional<JointAngles> joints;
    if (!pose_at(*position, base_T_tool, joints, Solve::kNothing)) return outcome_;
    point_mm = (base_T_tool * arm_T_tool(position->tool)).position_mm;
  }
  const Eigen::Vector3d x = points_mm[1] - points_mm[0], in_plane = points_mm[2] - points_mm[0];
  const Eigen::Vector3d z = x.cross(in_plane);
  if (!(z.norm() > kLeastArea * (x.squaredNorm() + in_plane.squaredNorm())))
    return (void)fail(Alarm::kRelation), outcome_;
  Transform frame{.position_mm = points_mm[0]};
  frame.rotation.col(0) = x / x.norm();
  frame.rotation.col(2) = z / z.norm();
  frame.rotation.col(1) = frame.rotation.col(2).cross(frame.rotation.col(0));
  setup_.cell.base_T_user[static_cast<std::size_t>(user) - 1] = frame;
  return Outcome::kNext;
}

bool Machine::frame_of(Frame frame, double user, Transform& base_T_frame) noexcept {
  base_T_frame = {};
  if (frame == Frame::kRobot || frame == Frame::kBase) return true;
  if (frame != Frame::kUser) return fail(Alarm::kUnsupported);
  const bool known = user >= 1.0 && user <= static_cast<double>(kUserFrames) &&
                     setup_.cell.base_T_user[static_cast<std::size_t>(user) - 1].has_value();
  if (!known) return fail(Alarm::kFrame);
  base_T_frame = *setup_.cell.base_T_user[static_cast<std::size_t>(user) - 1];
  return true;
}

// BF, RF or UF#(n) of an operand; none is the base.
bool Machine::frame_at(std::size_t& at, Transform& base_T_frame) noexcept {
  base_T_frame = {};
  if (at >= operands_.size() || is_word(at, Word::kBaseFrame) || is_word(at, Word::kRobotFrame)) return ++at, true;
  if (operand(at).kind != OperandKind::kIo) return fail(Alarm::kUnsupported);
  double user = 0.0;
  ++at;
  return number(at, user) && frame_of(Frame::kUser, user, base_T_frame);
}

}  // namespace armature::job
