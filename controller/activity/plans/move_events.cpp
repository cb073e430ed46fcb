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

MoveStarted started(const JointPlan& plan, std::size_t) {
  MoveStarted event{
      .kind = plan.is_dwell ? MoveKind::kDwell : MoveKind::kJoint, .tag = plan.tag, .residual_rad = plan.residual_rad};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    event.shape[axis] = plan.profiles[axis].shape();
    event.peak_speed_rad_s[axis] = plan.profiles[axis].peak_speed();
    event.accel_rad_s2[axis] = plan.profiles[axis].peak_accel();
  }
  return event;
}

MoveStarted started(const JointChain& chain, std::size_t index) {
  const RetargetPlan& plan = chain.moves[index];
  MoveStarted event{.kind = MoveKind::kJoint, .tag = plan.tag, .residual_rad = plan.residual_rad};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (plan.laws[axis].duration_s() == 0.0) continue;
    event.shape[axis] = plan.kind == ProfileKind::kSCurve ? ProfileShape::kSCurve : ProfileShape::kTrapezoid;
    event.peak_speed_rad_s[axis] = plan.peak_speed_rad_s[axis];
    event.accel_rad_s2[axis] = plan.peak_accel_rad_s2[axis];
  }
  event.continues = index > 0 && chain.end_of(index - 1) < chain.starts[index - 1] + chain.moves[index - 1].duration;
  return event;
}

MoveStarted started(const CartesianPlan& plan, std::size_t index) {
  const CartesianSegment& segment = plan.segments[index];
  MoveStarted event{.kind = kind_of(segment.path.shape),
                    .tag = segment.tag,
                    .path = segment.path,
                    .stretch = segment.stretch,
                    .stretched_for = segment.stretched_for,
                    .rapid = segment.rapid,
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

Tag tag_of(const JointPlan& plan, std::size_t) {
  return plan.tag;
}
Tag tag_of(const JointChain& chain, std::size_t index) {
  return chain.moves[index].tag;
}
Tag tag_of(const CartesianPlan& plan, std::size_t index) {
  return plan.segments[index].tag;
}

}  // namespace

Tag tag_of(const Plan& plan, std::size_t index) noexcept {
  const Piece& piece = plan.piece_with(index);
  return piece.visit([&](const auto& whole) { return tag_of(whole, index - piece.first_move); });
}

MoveStarted started(const Plan& plan, std::size_t index, Ticks start) noexcept {
  const Piece& piece = plan.piece_with(index);
  MoveStarted event = piece.visit([&](const auto& whole) { return started(whole, index - piece.first_move); });
  if (index == piece.first_move) event.continues = piece.in_motion;
  const MoveSpan span = span_of(plan, index);
  event.duration = span.end - span.start;
  event.start_tick = start;
  return event;
}

MoveRefused dropped(const Plan& plan, std::size_t index, Refusal reason) noexcept {
  return {.reason = reason, .tag = tag_of(plan, index)};
}

}  // namespace armature
