#include "controller/trajectory/cartesian_plan.hpp"

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

double seconds(Ticks ticks) {
  return static_cast<double>(ticks.value()) * kTickSeconds;
}

bool ended(const CartesianSegment& segment, double t_s) {
  return t_s >= seconds(segment.start + segment.duration);
}

}  // namespace

double share_at(const CartesianSegment& segment, double t_s) noexcept {
  return ended(segment, t_s) ? 1.0 : position(segment.law, t_s - seconds(segment.start));
}

std::size_t segment_at(const CartesianPlan& plan, double t_s) noexcept {
  std::size_t index = plan.count;
  while (index > 1 && seconds(plan.segments[index - 1].start) > t_s) --index;
  return index == 0 ? 0 : index - 1;
}

Transform tool_pose(const CartesianPlan& plan, double t_s) noexcept {
  const std::size_t index = segment_at(plan, t_s);
  const CartesianSegment& segment = plan.segments[index];
  const double s = share_at(segment, t_s);
  const bool blended = index > 0 && !ended(plan.segments[index - 1], t_s);
  if (!blended) return {rotation(segment.orientation, s), point(segment.path, s)};
  // No third segment can be under way: neighbours overlap by at most half of each.
  const CartesianSegment& before = plan.segments[index - 1];
  const double s_before = share_at(before, t_s);
  return {rotation(before.orientation, s_before) * turned(segment.orientation, s),
          point(before.path, s_before) + (point(segment.path, s) - segment.path.start_mm)};
}

JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous) noexcept {
  if (t_s <= 0.0) return plan.start;
  if (t_s >= seconds(plan.duration)) return plan.target;
  const IkTracking tracking = arm.track(tool_pose(plan, t_s) * plan.tool_T_flange, previous);
  return solved(tracking.status) ? tracking.joints : previous;
}

}  // namespace armature
