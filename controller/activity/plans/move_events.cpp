#include "controller/activity/plans/move_events.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace armature {
namespace {

MoveKind kind_of(PositionPath::Shape shape) {
  switch (shape) {
    case PositionPath::Shape::kLine:
      break;
    case PositionPath::Shape::kArc:
      return MoveKind::kArc;
    case PositionPath::Shape::kSpline:
      return MoveKind::kSpline;
  }
  return MoveKind::kLine;
}

MoveStarted started(const JointPlan& plan) {
  MoveStarted event{.kind = plan.is_dwell ? MoveKind::kDwell : MoveKind::kJoint,
                    .tag = plan.tag,
                    .duration = plan.duration,
                    .residual_rad = plan.residual_rad};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    event.shape[axis] = plan.profiles[axis].shape();
    event.peak_speed_rad_s[axis] = plan.profiles[axis].peak_speed();
    event.accel_rad_s2[axis] = plan.profiles[axis].peak_accel();
  }
  return event;
}

MoveStarted started(const JointChain& chain, std::size_t index) {
  const RetargetPlan& plan = chain.moves[index];
  MoveStarted event{.kind = MoveKind::kJoint,
                    .tag = plan.tag,
                    .duration = chain.end_of(index) - chain.starts[index],
                    .residual_rad = plan.residual_rad};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const PhaseLaw& law = plan.laws[axis];
    if (law.duration_s() == 0.0) continue;
    event.shape[axis] = plan.kind == ProfileKind::kSCurve ? ProfileShape::kSCurve : ProfileShape::kTrapezoid;
    event.peak_speed_rad_s[axis] = law.peak_speed();
    event.accel_rad_s2[axis] = law.peak_accel();
  }
  event.continues = index > 0 && chain.end_of(index - 1) < chain.starts[index - 1] + chain.moves[index - 1].duration;
  return event;
}

MoveStarted started(const CartesianPlan& plan, std::size_t index) {
  const CartesianSegment& segment = plan.segments[index];
  MoveStarted event{.kind = kind_of(segment.path.shape),
                    .tag = segment.tag,
                    .duration = segment.duration,
                    .path = segment.path,
                    .stretch = segment.stretch,
                    .stretched_for = segment.stretched_for,
                    .residual_rad = segment.residual_rad};
  if (const Spline* spline = segment.path.spline) {
    const auto inner = spline->points_mm().subspan(1, spline->points_mm().size() - 2);
    event.through.count = static_cast<std::uint8_t>(inner.size());
    std::copy(inner.begin(), inner.end(), event.through.mm.begin());
  }
  event.unasked_stop = index == 0 && plan.after_unasked_stop;
  if (index > 0) event.continues = segment.start < end_of(plan.segments[index - 1]);
  return event;
}

MoveStarted started(const PartMove& move) {
  const MotionPlan::Part& part = move.part;
  MoveStarted event = part.path != nullptr ? started(*part.path, move.move) : started(*part.chain, move.move);
  if (move.move == 0) event.continues = part.in_motion;
  return event;
}

Tag tag_of(const PartMove& move) {
  return move.part.path != nullptr ? move.part.path->segments[move.move].tag : move.part.chain->moves[move.move].tag;
}

}  // namespace

Tag tag_of(const MotionPlan& plan, std::size_t index) noexcept {
  if (const CartesianPlan* path = plan.path()) return path->segments[index].tag;
  if (const JointChain* chain = plan.joint_chain()) return chain->moves[index].tag;
  if (plan.is_joined()) return tag_of(part_move(plan, index));
  return plan.joint()->tag;
}

MoveStarted started(const MotionPlan& plan, std::size_t index, Ticks start) noexcept {
  const CartesianPlan* path = plan.path();
  const JointChain* chain = plan.joint_chain();
  MoveStarted event = path != nullptr    ? started(*path, index)
                      : chain != nullptr ? started(*chain, index)
                      : plan.is_joined() ? started(part_move(plan, index))
                                         : started(*plan.joint());
  if (plan.is_joined()) {
    const MoveSpan span = span_of(plan, index);
    event.duration = span.end - span.start;
  }
  event.start_tick = start;
  return event;
}

MoveRefused dropped(const MotionPlan& plan, std::size_t index, Refusal reason) noexcept {
  return {.reason = reason, .tag = tag_of(plan, index)};
}

}  // namespace armature
