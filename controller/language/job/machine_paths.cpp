// How the machine moves the tool along lines, arcs and curves.
#include "controller/base/angle_units.hpp"
#include "controller/language/job/circle_points.hpp"
#include "controller/language/job/machine.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature::job {
namespace {

bool is_line(Op op, std::uint8_t flags) noexcept {
  return op == Op::kMovl || op == Op::kSmovl || (flags & Record::kArcFirst) != 0;
}

}  // namespace

// A line to the target, or an arc from the point before.
Machine::Outcome Machine::move_path(const PositionValue& target, const MoveTags& tags) noexcept {
  if (!use_tool(target.tool)) return outcome_;
  Transform base_T_tool;
  std::optional<JointAngles> joints;
  if (!pose_at(target, base_T_tool, joints, Solve::kSides)) return outcome_;
  CartesianMove move{.kind = SegmentRequest::Kind::kLine};
  if (!is_line(here().op, here().flags)) {
    std::optional<Eigen::Vector3d> via_mm;
    if (!arc_middle(pc_, base_T_tool, via_mm)) return outcome_;
    if (via_mm) {
      move.kind = SegmentRequest::Kind::kArc;
      move.via_mm = *via_mm;
    }
  }
  if (joints) {
    // The path decides about whole turns.
    move.target.configuration = setup_.cell.arm.configuration(*joints);
    move.target.configuration.turns.reset();
  }
  return send_path(move, tags, base_T_tool);
}

// The middle of the arc to a point of a run: on the circle through the point before, this one and the next one of the
// same arc; at the end of an arc through its last three points. None: these are on one line.
bool Machine::arc_middle(std::uint16_t at, const Transform& target, std::optional<Eigen::Vector3d>& via_mm) noexcept {
  const auto point_at = [this](std::uint16_t point, Eigen::Vector3d& point_mm) {
    PositionValue value;
    Transform base_T_tool;
    std::optional<JointAngles> joints;
    if (!position_of(point, value) || !pose_at(value, base_T_tool, joints, Solve::kNothing)) return false;
    point_mm = base_T_tool.position_mm;
    return true;
  };
  const bool ends = (record(at).flags & Record::kArcEnds) != 0;
  const std::uint16_t before = record(at).partner;
  const std::uint16_t third = ends ? record(before).partner : record(at).target;
  Eigen::Vector3d before_mm, third_mm;
  if (!point_at(before, before_mm) || !point_at(third, third_mm)) return false;
  const auto middles = ends ? middles_of_arcs(third_mm, before_mm, target.position_mm)
                            : middles_of_arcs(before_mm, target.position_mm, third_mm);
  if (middles) via_mm = ends ? middles->second_mm : middles->first_mm;
  return true;
}

// MOVS: one curve through the points of the run, sent with the second of them. The others are part of it.
Machine::Outcome Machine::move_on_spline() noexcept {
  if ((record(here().partner).flags & Record::kArcFirst) == 0) return Outcome::kNext;
  CartesianMove move{.kind = SegmentRequest::Kind::kSpline};
  Transform base_T_tool;
  std::optional<JointAngles> joints;
  MoveTags tags;
  for (std::uint16_t point = pc_; point != kNowhere; point = record(point).target) {
    PositionValue target;
    if (!position_of(point, target) || !use_tool(target.tool)) return outcome_;
    if (!pose_at(target, base_T_tool, joints, Solve::kNothing)) return outcome_;
    if (record(point).target == kNowhere) break;
    if (move.through.count == ThroughPoints::kMax) return (void)fail(Alarm::kArc), outcome_;
    move.through.mm[move.through.count++] = base_T_tool.position_mm;
  }
  if (!read_tags(0, tags)) return outcome_;
  return send_path(move, tags, base_T_tool);
}

Machine::Outcome Machine::send_path(CartesianMove& move, const MoveTags& tags, const Transform& base_T_tool) noexcept {
  if (!keeps_tool_path(base_T_tool)) return outcome_;
  const double accel = share_of_acceleration(tags);
  move.target.position_mm = base_T_tool.position_mm;
  move.target.rotation = base_T_tool.rotation;
  move.limits = {.speed_mm_s = tags.v.value_or(speed_mm_s_),
                 .accel_mm_s2 = setup_.settings.accel_mm_s2 * accel,
                 .jerk_mm_s3 = kLargestPathLimit,
                 .turn_speed_rad_s = tags.vr ? *tags.vr * kRadPerDeg : turn_speed_rad_s_,
                 .turn_accel_rad_s2 = setup_.settings.turn_accel_rad_s2 * accel,
                 .turn_jerk_rad_s3 = kLargestPathLimit,
                 .joint_accel = accel};
  move.blend_mm = tags.cr ? *tags.cr : setup_.settings.pl_radius_mm[static_cast<std::size_t>(tags.pl.value_or(0.0))];
  move.exact_stop = tags.pl && *tags.pl == 0.0 && move.blend_mm == 0.0;
  port_->send(move, place());
  planned_ = {.base_T_tool = base_T_tool};
  return Outcome::kNext;
}

// IMOV: by a position variable. Pulses and angles are added to the joints; mm and degrees along the axes of a frame.
Machine::Outcome Machine::move_relative() noexcept {
  if (!port_->has_room()) return Outcome::kWait;
  std::size_t at = 0;
  const PositionValue* by = position_variable(at);
  if (by == nullptr) return outcome_;
  if (!by->set) return (void)fail(Alarm::kNotSet), outcome_;
  MoveTags tags;
  if (!read_tags(at, tags)) return outcome_;
  if (!by->is_cartesian()) {
    if (!know_joints()) return outcome_;
    PositionValue target{.frame = Frame::kAngle, .set = true};
    for (std::size_t i = 0; i < setup_.cell.robot.axis_count; ++i) {
      const double unit =
          by->frame == Frame::kPulse ? AxisUnits{setup_.cell.robot.axes[i]}.rad_per_pulse() / kRadPerDeg : 1.0;
      target.value[i] = (*planned_.joints)[i].value() / kRadPerDeg + by->value[i] * unit;
    }
    return move_joints(target, tags);
  }
  if (!setup_.cell.arm.known()) return (void)fail(Alarm::kReach), outcome_;
  if (!know_pose()) return outcome_;
  while (at < operands_.size() && operand(at).kind == OperandKind::kTag) {
    double ignored = 0.0;
    if (!tag_number(at, 1.0, ignored)) return outcome_;
  }
  const Transform way = pose_of(*by);
  const Transform arm_T_present = arm_T_tool(tool_.value_or(0));
  Transform target = *planned_.base_T_tool * arm_T_present;
  if (is_word(at, Word::kToolFrame)) {
    target = target * way;
  } else {
    Transform base_T_frame;
    if (!frame_at(at, base_T_frame)) return outcome_;
    const Eigen::Matrix3d& r = base_T_frame.rotation;
    target.position_mm += r * way.position_mm;
    target.rotation = r * way.rotation * r.transpose() * target.rotation;
  }
  CartesianMove move{.kind = SegmentRequest::Kind::kLine};
  return send_path(move, tags, target * inverse(arm_T_present));
}

}  // namespace armature::job
