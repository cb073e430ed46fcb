#include "controller/motion/move_reports.hpp"

namespace armature {
namespace {

MoveReport report_of(const JointPlan& plan) {
  MoveReport report{
      .kind = MoveKind::kJoint, .tag = plan.tag, .duration = plan.duration, .residual_rad = plan.residual_rad};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    report.shape[axis] = plan.profiles[axis].shape();
    report.peak_speed_rad_s[axis] = plan.profiles[axis].peak_speed();
    report.accel_rad_s2[axis] = plan.profiles[axis].peak_accel();
  }
  return report;
}

MoveReport report_of(const CartesianPlan& plan, std::size_t index) {
  const CartesianSegment& segment = plan.segments[index];
  MoveReport report{.kind = segment.path.shape == PositionPath::Shape::kArc ? MoveKind::kArc : MoveKind::kLine,
                    .tag = segment.tag,
                    .duration = segment.duration,
                    .path = segment.path,
                    .stretch = segment.stretch,
                    .stretched_for = segment.stretched_for,
                    .residual_rad = segment.residual_rad};
  if (index > 0) report.continues = segment.start < end_of(plan.segments[index - 1]);
  return report;
}

}  // namespace

MoveReport report_of(const MotionPlan& plan, std::size_t index, Ticks start) noexcept {
  const CartesianPlan* path = plan.path();
  MoveReport report = path != nullptr ? report_of(*path, index) : report_of(*plan.joint());
  report.start_tick = start;
  return report;
}

MoveRefusal dropped(const MotionPlan& plan, std::size_t index) noexcept {
  const CartesianPlan* path = plan.path();
  return {.reason = Refusal::kNotReady, .tag = path != nullptr ? path->segments[index].tag : plan.joint()->tag};
}

}  // namespace armature
