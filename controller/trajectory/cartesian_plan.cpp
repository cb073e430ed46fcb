#include "controller/trajectory/cartesian_plan.hpp"

#include <cmath>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// More than theta_5 can change in half a tick: 40 rad/s.
constexpr double kWristInSight_rad = 1e-3;

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

FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous) noexcept {
  const auto flange = [&](double at_s) { return tool_pose(plan, at_s) * plan.tool_T_flange; };
  const Transform here = flange(t_s);
  const FollowedTool plain{arm.track(here, previous), false};
  if (!plain.tracking.found || std::fabs(arm.wrist_sine(plain.tracking.joints)) >= kWristInSight_rad) return plain;

  // From `previous`, not from `here`: its theta_4 may be anything.
  const IkTracking before = arm.track(flange(t_s - kTickSeconds), previous);
  const IkTracking after = arm.track(flange(t_s + kTickSeconds), before.joints);
  if (!before.found || !after.found) return plain;
  const double sine_before = arm.wrist_sine(before.joints), sine_after = arm.wrist_sine(after.joints);
  if (!(sine_before * sine_after < 0.0)) return plain;
  JointAngles middle = before.joints;
  middle[3] = Radians{0.5 * (before.joints[3].value() + after.joints[3].value())};
  const IkTracking through = arm.track_keeping_theta4(here, middle);
  const bool nearest = std::fabs(arm.wrist_sine(through.joints)) < 0.25 * std::fabs(sine_after - sine_before);
  return nearest ? FollowedTool{through, true} : plain;
}

JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous) noexcept {
  if (t_s <= 0.0) return plan.start;
  if (t_s >= seconds(plan.duration)) return plan.target;
  const IkTracking tracking = follow_tool(plan, arm, t_s, previous).tracking;
  return tracking.found ? tracking.joints : previous;
}

}  // namespace armature
