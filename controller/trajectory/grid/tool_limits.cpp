#include "controller/trajectory/grid/tool_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"

namespace armature {
namespace {

constexpr double kJerkShare = 0.985;
constexpr double kCornerStep = 0.01;  // of the corner, for its derivatives

// First, second and third derivative of position and rotation.
struct Derivatives {
  PathDirection slope{}, bend{}, jolt{};
};

void add_jerk(LawLimits::Jerk& jerk, const Eigen::Vector3d& slope, const Eigen::Vector3d& bend,
              const Eigen::Vector3d& jolt, double most) {
  const double third = math::cbrt(jolt.norm() / most);
  jerk.by_change = std::max(jerk.by_change, slope.norm() / most);
  jerk.by_both = std::max(jerk.by_both, 3.0 * bend.norm() / most);
  jerk.by_speed = std::max(jerk.by_speed, third * third);
}

void add_tool(LawLimits& limits, const PathLimits& most, ProfileKind profile, const Derivatives& by_s,
              double run_length) {
  const PathDirection &slope = by_s.slope, &bend = by_s.bend;
  const double move = slope.move.norm(), turn = slope.turn_per_mm.norm();
  double speed = kLargestPathLimit, accel = kLargestPathLimit;
  if (move > 0.0) speed = most.speed_mm_s / move, accel = most.accel_mm_s2 / move;
  if (turn > 0.0) {
    speed = std::min(speed, most.turn_speed_rad_s / turn);
    accel = std::min(accel, most.turn_accel_rad_s2 / turn);
  }
  limits.most_square = math::square(speed);
  constexpr double kRamp_s = kRampTicks * kTickSeconds;
  const double ramp = std::min(speed / kRamp_s, run_length / math::square(kRamp_s));
  const double share = std::min(1.0, ramp / accel);
  const auto ellipse = [share](const Eigen::Vector3d& c, const Eigen::Vector3d& d, double limit) {
    const double scale = 1.0 / math::square(limit * share);
    return LawLimits::Ellipse{c.squaredNorm() * scale, c.dot(d) * scale, d.squaredNorm() * scale};
  };
  limits.ellipses = {ellipse(slope.move, bend.move, most.accel_mm_s2),
                     ellipse(slope.turn_per_mm, bend.turn_per_mm, most.turn_accel_rad_s2)};
  if (profile != ProfileKind::kSCurve) return;
  add_jerk(limits.jerk, slope.move, bend.move, by_s.jolt.move, kJerkShare * most.jerk_mm_s3);
  add_jerk(limits.jerk, slope.turn_per_mm, bend.turn_per_mm, by_s.jolt.turn_per_mm, kJerkShare * most.turn_jerk_rad_s3);
}

PathDirection third_derivative(const CartesianPlan& plan, double s, double delta) {
  std::array<ToolSample, 5> at;
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = tool_on_path(plan, s + (static_cast<double>(i) - 2.0) * delta);
  const auto place = [&](std::size_t i) { return at[i].tool.base_T_tool.position_mm; };
  const auto turn = [&](std::size_t i) { return limited_turn(at[i], at[i + 1]); };
  const double cube = 2.0 * delta * math::square(delta);
  return {(place(4) - 2.0 * place(3) + 2.0 * place(1) - place(0)) / cube,
          (turn(3) - turn(2) - turn(1) + turn(0)) / cube};
}

// The third derivative of the position on a spline. At a point of the spline it is the larger one of both sides.
Eigen::Vector3d largest_jolt(const CartesianSegment& segment, double share) {
  constexpr double kBeside = 1e-9;  // of the length
  const Spline& curve = *segment.path.spline;
  const double length_mm = curve.length_mm();
  const auto jolt = [&](double at) { return curve.at(std::clamp(at, 0.0, 1.0) * length_mm).jolt; };
  const Eigen::Vector3d before = jolt(share - kBeside), after = jolt(share + kBeside);
  return (before.norm() > after.norm() ? before : after) *
         (math::square(length_mm / segment.length) * length_mm / segment.length);
}

}  // namespace

double run_around(const CartesianPlan& plan, std::size_t segment) noexcept {
  std::size_t first = segment, last = segment;
  while (first > 0 && joint_after(plan, first - 1) != PathJoint::kStop) --first;
  while (last + 1 < plan.count && joint_after(plan, last) != PathJoint::kStop) ++last;
  return plan.segments[last].from + plan.segments[last].length - plan.segments[first].from;
}

LawLimits limits_of_tool(const CartesianSegment& segment, double share, double run_length) noexcept {
  const PositionPath& path = segment.path;
  const bool varies = path.shape == PositionPath::Shape::kSpline, arc = path.shape == PositionPath::Shape::kArc;
  const double at = varies ? share : 0.0;
  Derivatives by_s{.slope = direction_at(segment, at)};
  by_s.bend.move = bend_at(segment, at);
  if (arc) by_s.jolt.move = by_s.slope.move * (by_s.bend.move.norm() / path.radius_mm);  // only its size
  if (varies) by_s.jolt.move = largest_jolt(segment, at);
  LawLimits result;
  add_tool(result, segment.limits, segment.profile, by_s, run_length);
  if (varies) slow_down(result, kCornerShare);
  return result;
}

LawLimits limits_in_corner(const CartesianPlan& plan, std::size_t first, const CartesianSegment& half, double s,
                           double run_length) noexcept {
  const double delta = kCornerStep * plan.segments[first].corner;
  const ToolSample a = tool_on_path(plan, s - delta), b = tool_on_path(plan, s), c = tool_on_path(plan, s + delta);
  const auto at = [](const ToolSample& sample) { return sample.tool.base_T_tool.position_mm; };
  const Eigen::Vector3d before = limited_turn(a, b), after = limited_turn(b, c);
  Derivatives by_s;
  by_s.slope = {(at(c) - at(a)) / (2.0 * delta), (after + before) / (2.0 * delta)};
  by_s.bend = {(at(c) - 2.0 * at(b) + at(a)) / math::square(delta), (after - before) / math::square(delta)};
  if (half.profile == ProfileKind::kSCurve) {
    // The largest one, at the outer end of this half, so that a corner of lines has one limit of speed.
    const CartesianSegment& before_corner = plan.segments[first];
    const double middle = before_corner.from + before_corner.length, outer = before_corner.corner - 2.0 * delta;
    by_s.jolt = third_derivative(plan, &half == &before_corner ? middle - outer : middle + outer, delta);
  }
  LawLimits result;
  add_tool(result, half.limits, half.profile, by_s, run_length);
  slow_down(result, kCornerShare);
  return result;
}

}  // namespace armature
