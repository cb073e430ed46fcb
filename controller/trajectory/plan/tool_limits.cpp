#include "controller/trajectory/plan/tool_limits.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/plan/blend.hpp"
#include "controller/trajectory/plan/path_corners.hpp"

namespace armature {
namespace {

constexpr double kCornerStep = 0.01;  // of the corner, for its derivatives

double power2(double x) {
  return x * x;
}

// The limits of a motion with these derivatives of position and rotation.
void add_tool(LawLimits& limits, const PathLimits& most, const PathDirection& slope, const PathDirection& bend,
              double run_length) {
  const double move = slope.move.norm(), turn = slope.turn_per_mm.norm();
  double speed = kLargestPathLimit, accel = kLargestPathLimit;
  if (move > 0.0) speed = most.speed_mm_s / move, accel = most.accel_mm_s2 / move;
  if (turn > 0.0) {
    speed = std::min(speed, most.turn_speed_rad_s / turn);
    accel = std::min(accel, most.turn_accel_rad_s2 / turn);
  }
  limits.most_square = power2(speed);
  // Ramps last for kRampTicks at least, see blend.hpp.
  constexpr double kRamp_s = kRampTicks * kTickSeconds;
  const double ramp = std::min(speed / kRamp_s, run_length / power2(kRamp_s));
  const double share = std::min(1.0, ramp / accel);
  const auto ellipse = [share](const Eigen::Vector3d& c, const Eigen::Vector3d& d, double limit) {
    const double scale = 1.0 / power2(limit * share);
    return LawLimits::Ellipse{c.squaredNorm() * scale, c.dot(d) * scale, d.squaredNorm() * scale};
  };
  limits.ellipses = {ellipse(slope.move, bend.move, most.accel_mm_s2),
                     ellipse(slope.turn_per_mm, bend.turn_per_mm, most.turn_accel_rad_s2)};
}

}  // namespace

double run_around(const CartesianPlan& plan, std::size_t segment) noexcept {
  std::size_t first = segment, last = segment;
  while (first > 0 && joint_after(plan, first - 1) != PathJoint::kStop) --first;
  while (last + 1 < plan.count && joint_after(plan, last) != PathJoint::kStop) ++last;
  return plan.segments[last].from + plan.segments[last].length - plan.segments[first].from;
}

LawLimits limits_of_tool(const CartesianSegment& segment, double run_length) noexcept {
  const PathDirection slope = direction_at(segment, 0.0);
  PathDirection bend;
  // Only its size, and that it is at a right angle to the slope, matter. path.x is so at the start of an arc.
  const double radius_mm = curve_radius_mm(segment.path, 0.0);
  if (std::isfinite(radius_mm)) bend.move = segment.path.x * (slope.move.squaredNorm() / radius_mm);
  LawLimits result;
  add_tool(result, segment.limits, slope, bend, run_length);
  return result;
}

LawLimits limits_in_corner(const CartesianPlan& plan, std::size_t first, const PathLimits& limits, double s,
                           double run_length) noexcept {
  const double delta = kCornerStep * plan.segments[first].corner;
  const ToolSample a = tool_on_path(plan, s - delta), b = tool_on_path(plan, s), c = tool_on_path(plan, s + delta);
  const auto at = [](const ToolSample& sample) { return sample.tool.base_T_tool.position_mm; };
  const Eigen::Vector3d before = limited_turn(a, b), after = limited_turn(b, c);
  const PathDirection slope{(at(c) - at(a)) / (2.0 * delta), (after + before) / (2.0 * delta)};
  const PathDirection bend{(at(c) - 2.0 * at(b) + at(a)) / power2(delta), (after - before) / power2(delta)};
  LawLimits result;
  add_tool(result, limits, slope, bend, run_length);
  slow_down(result, kCornerShare);
  return result;
}

}  // namespace armature
