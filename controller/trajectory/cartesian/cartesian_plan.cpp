#include "controller/trajectory/cartesian/cartesian_plan.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// Larger than the change of theta_5 in half a tick: 40 rad/s.
constexpr double kWristInSight_rad = 1e-3;
// Share of the change of sin(theta_5) over two ticks: a quarter is half a tick. A little more, so that of two positions
// a tick apart at least one is in the middle.
constexpr double kMiddle = 0.26;

PlaneAngles at(const PlaneAngles& start, const PlaneAngles& change, double share) {
  return {.pitch_rad = start.pitch_rad + share * change.pitch_rad,
          .roll_rad = start.roll_rad + share * change.roll_rad};
}

// The last segment for which `begun` is true; those before it are as well. The first one if there is none.
template <class Begun>
std::size_t last_segment(const CartesianPlan& plan, Begun begun) {
  std::size_t low = 0, high = plan.count;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (begun(plan.segments[middle]) ? low : high) = middle;
  }
  return low;
}

struct SegmentPoint {
  const CartesianSegment& segment;
  double share;
};

// `next`: the segment that has begun before the first has ended, or null. Both have the same kind of rotation.
ToolSample sample_of(const SegmentPoint& first, const SegmentPoint* next, const Transform& tool_T_flange) {
  Eigen::Vector3d position_mm = point(first.segment.path, first.share);
  if (next != nullptr) position_mm += point(next->segment.path, next->share) - next->segment.path.start_mm;

  if (first.segment.turning == Turning::kFollowing) {
    const PlaneTurn& turn = first.segment.plane_turn;
    PlaneAngles angles = at(turn.start, turn.change, first.share);
    if (next != nullptr) angles = at(angles, next->segment.plane_turn.change, next->share);
    ToolSample sample{.tool = hold_tool(angles, position_mm, inverse(tool_T_flange)), .in_plane = angles};
    sample.rotation = sample.tool.base_T_tool.rotation;
    return sample;
  }
  ToolSample sample;
  sample.rotation = rotation(first.segment.orientation, first.share);
  if (next != nullptr) sample.rotation = sample.rotation * turned(next->segment.orientation, next->share);
  sample.tool.base_T_tool = {sample.rotation, position_mm};
  const bool next_projected = next != nullptr && next->segment.turning == Turning::kIntoPlane;
  if (first.segment.turning == Turning::kIntoPlane || next_projected) {
    sample.tool = into_plane(sample.tool.base_T_tool, inverse(tool_T_flange));
  }
  return sample;
}

}  // namespace

CartesianPlan& CartesianPlan::operator=(const CartesianPlan& other) noexcept {
  start = other.start;
  target = other.target;
  tool_T_flange = other.tool_T_flange;
  end_base_T_tool = other.end_base_T_tool;
  std::copy_n(other.segments.begin(), other.count, segments.begin());
  count = other.count;
  std::copy_n(other.splines.begin(), other.spline_count, splines.begin());
  spline_count = other.spline_count;
  for (std::size_t i = 0; i < count && spline_count > 0; ++i) {
    const Spline*& spline = segments[i].path.spline;
    if (spline != nullptr) spline = splines.data() + (spline - other.splines.data());
  }
  table = other.table;
  bends = other.bends;
  duration = other.duration;
  outputs = other.outputs;
  continues = other.continues;
  origin = other.origin;
  same_until_ticks = other.same_until_ticks;
  dropped = other.dropped;
  known = other.known;
  outputs_over = other.outputs_over;
  after_unasked_stop = other.after_unasked_stop;
  first_run = other.first_run;
  return *this;
}

double turn_angle_rad(const CartesianSegment& segment) noexcept {
  if (segment.turning != Turning::kFollowing) return segment.orientation.angle_rad;
  return math::hypot(segment.plane_turn.change.pitch_rad, segment.plane_turn.change.roll_rad);
}

double share_at(const CartesianPlan& plan, std::size_t segment, double t_s) noexcept {
  const CartesianSegment& path = plan.segments[segment];
  return path.length > 0.0 ? std::clamp((plan.table.position(t_s) - path.from) / path.length, 0.0, 1.0) : 1.0;
}

std::size_t segment_at(const CartesianPlan& plan, double t_s) noexcept {
  const auto begun = [t_s](const CartesianSegment& segment) { return seconds(segment.start) <= t_s; };
  return last_segment(plan, begun);
}

std::size_t segment_on_path(const CartesianPlan& plan, double s) noexcept {
  return last_segment(plan, [s](const CartesianSegment& segment) { return segment.from <= s; });
}

Transform held_tool_pose(const CartesianPlan& plan, const Arm& arm, const JointAngles& joints) noexcept {
  return arm.forward(joints) * inverse(plan.tool_T_flange);
}

ToolSample tool_sample(const CartesianSegment& segment, double share, const Transform& tool_T_flange) noexcept {
  return sample_of({segment, share}, nullptr, tool_T_flange);
}

CornerShares corner_shares(const CartesianSegment& first, const CartesianSegment& second, double c, double u) noexcept {
  const double b = u * u * u * (1.0 - 0.5 * u), width = 2.0 * c;
  return {.first = 1.0 - (c - width * (u - b)) / first.length, .second = width * b / second.length};
}

ToolSample tool_on_path(const CartesianPlan& plan, double s) noexcept {
  const std::size_t index = segment_on_path(plan, s);
  const CartesianSegment& segment = plan.segments[index];
  const double after = s - segment.from;
  const auto in_corner = [&plan](std::size_t first, double u) {
    const CartesianSegment &a = plan.segments[first], &b = plan.segments[first + 1];
    const CornerShares shares = corner_shares(a, b, a.corner, u);
    const SegmentPoint next{b, shares.second};
    return sample_of({a, shares.first}, &next, plan.tool_T_flange);
  };
  const double left = segment.length - after;
  if (segment.corner > 0.0 && left < segment.corner) return in_corner(index, 0.5 - 0.5 * left / segment.corner);
  if (index > 0) {
    const double c = plan.segments[index - 1].corner;
    if (after < c) return in_corner(index - 1, 0.5 + 0.5 * after / c);
  }
  // At the end exactly 1, in spite of rounding.
  const double share = s >= segment.from + segment.length ? 1.0 : after / segment.length;
  return sample_of({segment, share}, nullptr, plan.tool_T_flange);
}

ToolSample tool_sample(const CartesianPlan& plan, double t_s) noexcept {
  return tool_on_path(plan, plan.table.empty() ? 0.0 : plan.table.position(t_s));
}

Eigen::Vector3d limited_turn(const ToolSample& from, const ToolSample& to) noexcept {
  if (from.in_plane && to.in_plane) {
    return {to.in_plane->pitch_rad - from.in_plane->pitch_rad, to.in_plane->roll_rad - from.in_plane->roll_rad, 0.0};
  }
  // sin(angle) equals the angle to 1e-8 of it.
  const Eigen::Matrix3d m = to.rotation * from.rotation.transpose();
  return 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
}

IkTracking joints_on_path(const CartesianPlan& plan, const Arm& arm, double s, const JointAngles& near) noexcept {
  const HeldTool tool = tool_on_path(plan, s).tool;
  if (tool.missing_mm > 0.0) return {.status = IkStatus::kUnreachable, .margin_mm = tool.missing_mm};
  if (const WristBend* bend = plan.bends.at(s)) {
    const Eigen::Vector3d flange_p_tool_mm = inverse(plan.tool_T_flange).position_mm;
    return track_on_bend(*bend, arm, s, tool.base_T_tool.position_mm, flange_p_tool_mm, near);
  }
  return arm.track_keeping_elbow(tool.base_T_tool * plan.tool_T_flange, near);
}

FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous) noexcept {
  return follow_tool(plan, arm, t_s, tool_pose(plan, t_s), previous);
}

FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s, const Transform& base_T_tool,
                         const JointAngles& previous) noexcept {
  if (plan.bends.count > 0) {
    const double s = plan.table.position(t_s);
    if (plan.bends.at(s) != nullptr) return {.tracking = joints_on_path(plan, arm, s, previous), .on_bend = true};
  }
  const auto flange = [&](double at_s) { return tool_pose(plan, at_s) * plan.tool_T_flange; };
  const Transform here = base_T_tool * plan.tool_T_flange;
  FollowedTool plain{.tracking = arm.track(here, previous)};
  if (!plain.tracking.found || std::fabs(arm.wrist_sine(plain.tracking.joints)) >= kWristInSight_rad) return plain;

  // From `previous`, not from `here`, whose theta_4 is arbitrary.
  const IkTracking before = arm.track(flange(t_s - kTickSeconds), previous);
  const IkTracking after = arm.track(flange(t_s + kTickSeconds), before.joints);
  plain.inverses = 3;
  if (!before.found || !after.found) return plain;
  const double sine_before = arm.wrist_sine(before.joints), sine_after = arm.wrist_sine(after.joints);
  if (!(sine_before * sine_after < 0.0)) return plain;
  JointAngles middle = before.joints;
  middle[3] = Radians{0.5 * (before.joints[3].value() + after.joints[3].value())};
  const IkTracking through = arm.track_keeping_theta4(here, middle);
  const bool nearest = std::fabs(arm.wrist_sine(through.joints)) < kMiddle * std::fabs(sine_after - sine_before);
  plain.inverses = 4;
  return nearest ? FollowedTool{.tracking = through, .through_wrist = true, .inverses = 4} : plain;
}

JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous,
                     int& inverses) noexcept {
  return position(plan, t_s, previous, inverses, [&] { return follow_tool(plan, arm, t_s, previous); });
}

JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous) noexcept {
  int inverses = 0;
  return position(plan, arm, t_s, previous, inverses);
}

}  // namespace armature
