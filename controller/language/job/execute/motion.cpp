#include "controller/language/job/execute/motion.hpp"

#include "controller/base/angle_units.hpp"
#include "controller/language/job/execute/circle_points.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::job {
namespace {

constexpr double kSamePlace_mm = 1e-6;
constexpr double kSameTurn = 1e-9;  // of the elements of rotations

bool is_line(const Record& record) noexcept {
  return record.op == Op::kMovl || record.op == Op::kSmovl || (record.flags & Record::kArcFirst) != 0;
}

// True when the input of UNTIL, where `until` stands, has the level that ends the move.
bool read_until(Step& step, OperandReader until, bool& reached) noexcept {
  double index = 0.0;
  until.next();
  if (!until.io_number(index)) return false;
  if (!(index >= 1.0 && index <= static_cast<double>(PinLevels::kPins))) return step.fail(Alarm::kPin);
  until.next();  // =
  reached = step.port().level(static_cast<std::uint8_t>(index), false) == until.is(Word::kOn);
  return true;
}

}  // namespace

void Motion::reset() noexcept {
  joint_speed_ = settings_.joint_speed;
  speed_mm_s_ = settings_.speed_mm_s;
  turn_speed_rad_s_ = settings_.turn_speed_rad_s;
  until_ = Until::kNone;
}

bool Motion::set_speeds(Step& step, OperandReader& operands) noexcept {
  MoveTags tags;
  if (!read_tags(step, operands, tags)) return false;
  if (tags.vj) joint_speed_ = *tags.vj / 100.0;
  if (tags.v) speed_mm_s_ = *tags.v;
  if (tags.vr) turn_speed_rad_s_ = *tags.vr * kRadPerDeg;
  return true;
}

bool Motion::move(Step& step, OperandReader& operands) noexcept {
  OperandReader until = operands;
  if (!until.find(Word::kUntil)) return send_move(step, operands);
  if (until_ != Until::kNone) return watch_until(step, until);
  bool reached = false;
  if (!step.wait_until_done() || !read_until(step, until, reached)) return false;
  if (reached) return true;
  if (!send_move(step, operands)) return false;
  until_ = Until::kMoving;
  return step.wait_in_each_tick();
}

bool Motion::watch_until(Step& step, const OperandReader& until) noexcept {
  if (until_ == Until::kMoving) {
    bool reached = false;
    if (!read_until(step, until, reached)) return false;
    if (reached && step.port().stop()) until_ = Until::kStopping;
  }
  if (!step.port().done()) return step.wait_in_each_tick();
  until_ = Until::kNone;
  arm_.forget();
  return true;
}

bool Motion::send_move(Step& step, OperandReader& operands) noexcept {
  PositionValue position;
  MoveTags tags;
  if (!step.wait_for_room() || !operands.position(position) || !read_tags(step, operands, tags)) return false;
  const Record& record = step.record();
  if (record.op == Op::kMovj) return send_joint_move(step, position, tags);
  if (!positions_.cell().arm.known()) return step.fail(Alarm::kReach);
  if (record.op == Op::kMovs && !is_line(record)) return send_spline(step, operands, tags);
  return send_path_move(step, operands, position, tags);
}

bool Motion::send_joint_move(Step& step, const PositionValue& position, const MoveTags& tags) noexcept {
  if (position.is_cartesian()) {
    if (!positions_.cell().arm.known()) return step.fail(Alarm::kReach);
    if (!step.check(tools_.use(position.tool))) return false;
  }
  Target target;
  if (!step.check(positions_.find(position, target)) || !arm_.solve_joint_move(step, target)) return false;
  const double speed = tags.vj ? *tags.vj / 100.0 : joint_speed_;
  const double accel = tags.accel_share();
  const JointBlend blend{.share = tags.pl.value_or(0.0) / MoveTags::kMaxPl};
  if (target.joints) {
    step.send(JointMove{.target = *target.joints, .speed = speed, .accel = accel, .blend = blend});
  } else {
    const FramedPose pose{.position_mm = target.base_T_tool.position_mm, .rotation = target.base_T_tool.rotation};
    step.send(PoseMove{.target = pose, .speed = speed, .accel = accel, .blend = blend});
  }
  arm_.set(target.joints, target.base_T_tool);
  return true;
}

bool Motion::send_path_move(Step& step, const OperandReader& operands, const PositionValue& position,
                            const MoveTags& tags) noexcept {
  Target target;
  if (!step.check(tools_.use(position.tool)) || !step.check(positions_.find(position, target))) return false;
  if (!arm_.solve(step, PlannedArm::Solve::kSides, target)) return false;
  CartesianMove move{.kind = SegmentRequest::Kind::kLine};
  if (!is_line(step.record())) {
    std::optional<Eigen::Vector3d> via_mm;
    if (!find_arc_middle(step, operands, target.base_T_tool.position_mm, via_mm)) return false;
    if (via_mm) {
      move.kind = SegmentRequest::Kind::kArc;
      move.via_mm = *via_mm;
    }
  }
  if (target.joints) {
    // The path decides about whole turns.
    move.target.configuration = positions_.cell().arm.configuration(*target.joints);
    move.target.configuration.turns.reset();
  }
  return send_path(step, move, tags, target.base_T_tool);
}

bool Motion::find_arc_middle(Step& step, const OperandReader& operands, const Eigen::Vector3d& end_mm,
                             std::optional<Eigen::Vector3d>& via_mm) const noexcept {
  const auto point_at = [&](std::uint16_t record, Eigen::Vector3d& point_mm) {
    PositionValue position;
    Target target;
    if (!operands.of(step.record(record)).position(position)) return false;
    if (!step.check(positions_.find(position, target))) return false;
    point_mm = target.base_T_tool.position_mm;
    return true;
  };
  const Record& record = step.record();
  const bool ends = (record.flags & Record::kArcEnds) != 0;
  Eigen::Vector3d before_mm, third_mm;
  if (!point_at(record.partner, before_mm)) return false;
  if (!point_at(ends ? step.record(record.partner).partner : record.target, third_mm)) return false;
  const auto middles =
      ends ? middles_of_arcs(third_mm, before_mm, end_mm) : middles_of_arcs(before_mm, end_mm, third_mm);
  if (middles) via_mm = ends ? middles->second_mm : middles->first_mm;
  return true;
}

bool Motion::send_spline(Step& step, const OperandReader& operands, const MoveTags& tags) noexcept {
  if ((step.record(step.record().partner).flags & Record::kArcFirst) == 0) return true;
  CartesianMove move{.kind = SegmentRequest::Kind::kSpline};
  Target target;
  for (std::uint16_t point = step.at();; point = step.record(point).target) {
    PositionValue position;
    if (!operands.of(step.record(point)).position(position) || !step.check(tools_.use(position.tool))) return false;
    if (!step.check(positions_.find(position, target))) return false;
    if (step.record(point).target == kNowhere) break;
    if (move.through.count == ThroughPoints::kMax) return step.fail(Alarm::kArc);
    move.through.mm[move.through.count++] = target.base_T_tool.position_mm;
  }
  return send_path(step, move, tags, target.base_T_tool);
}

bool Motion::send_path(Step& step, CartesianMove& move, const MoveTags& tags, const Transform& base_T_tool) noexcept {
  if (!keeps_tool_path(step, base_T_tool)) return false;
  const double accel = tags.accel_share();
  move.target.position_mm = base_T_tool.position_mm;
  move.target.rotation = base_T_tool.rotation;
  move.limits = {.speed_mm_s = tags.v.value_or(speed_mm_s_),
                 .accel_mm_s2 = settings_.accel_mm_s2 * accel,
                 .jerk_mm_s3 = kLargestPathLimit,
                 .turn_speed_rad_s = tags.vr ? *tags.vr * kRadPerDeg : turn_speed_rad_s_,
                 .turn_accel_rad_s2 = settings_.turn_accel_rad_s2 * accel,
                 .turn_jerk_rad_s3 = kLargestPathLimit,
                 .joint_accel = accel};
  move.blend_mm = tags.cr ? *tags.cr : settings_.pl_radius_mm[static_cast<std::size_t>(tags.pl.value_or(0.0))];
  move.exact_stop = tags.pl && *tags.pl == 0.0 && move.blend_mm == 0.0;
  step.send(move);
  arm_.set(std::nullopt, base_T_tool);
  return true;
}

bool Motion::keeps_tool_path(Step& step, const Transform& base_T_tool) noexcept {
  if (tools_.arm_T_tool(tools_.present()).position_mm.norm() < kSamePlace_mm) return true;
  if (!arm_.know_pose(step)) return false;
  const bool turns = (arm_.base_T_tool()->rotation - base_T_tool.rotation).norm() > kSameTurn;
  return !turns || step.fail(Alarm::kToolTurns);
}

bool Motion::move_relative(Step& step, OperandReader& operands) noexcept {
  if (!step.wait_for_room()) return false;
  const PositionValue* by = operands.set_position_variable();
  MoveTags tags;
  if (by == nullptr || !read_tags(step, operands, tags)) return false;
  return by->is_cartesian() ? send_line_by(step, operands, *by, tags) : send_joints_by(step, *by, tags);
}

bool Motion::send_joints_by(Step& step, const PositionValue& by, const MoveTags& tags) noexcept {
  if (!arm_.know_joints(step)) return false;
  const RobotModel& robot = positions_.cell().robot;
  PositionValue target{.frame = Frame::kAngle, .set = true};
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const double unit = by.frame == Frame::kPulse ? AxisUnits{robot.axes[i]}.rad_per_pulse() / kRadPerDeg : 1.0;
    target.value[i] = (*arm_.joints())[i].value() / kRadPerDeg + by.value[i] * unit;
  }
  return send_joint_move(step, target, tags);
}

bool Motion::send_line_by(Step& step, OperandReader& operands, const PositionValue& by, const MoveTags& tags) noexcept {
  if (!positions_.cell().arm.known()) return step.fail(Alarm::kReach);
  if (!arm_.know_pose(step)) return false;
  while (operands.is(OperandKind::kTag)) operands.skip();
  const Transform way = Positions::pose_of(by);
  const Transform arm_T_present = tools_.arm_T_tool(tools_.present());
  Transform target = *arm_.base_T_tool() * arm_T_present;
  if (operands.is(Word::kToolFrame)) {
    target = target * way;
  } else {
    Positions::FrameOperand frame;
    if (!positions_.read_frame(step, operands, frame)) return false;
    const Eigen::Matrix3d& r = frame.base_T_frame.rotation;
    target.position_mm += r * way.position_mm;
    target.rotation = r * way.rotation * r.transpose() * target.rotation;
  }
  CartesianMove move{.kind = SegmentRequest::Kind::kLine};
  return send_path(step, move, tags, target * inverse(arm_T_present));
}

}  // namespace armature::job
