#include "controller/trajectory/cartesian/path_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/trajectory/cartesian/five_axis_turning.hpp"

namespace armature {
namespace {

using Kind = PathProblem::Kind;

// Written so that a NaN is refused.
bool is_limit(double value) {
  return value > 0.0 && value <= kLargestPathLimit;
}

bool are_limits(const PathLimits& limits, ProfileKind profile) {
  const bool jerks = is_limit(limits.jerk_mm_s3) && is_limit(limits.turn_jerk_rad_s3);
  return is_limit(limits.speed_mm_s) && is_limit(limits.accel_mm_s2) && is_limit(limits.turn_speed_rad_s) &&
         is_limit(limits.turn_accel_rad_s2) && limits.joint_accel > 0.0 && limits.joint_accel <= 1.0 &&
         (jerks || profile == ProfileKind::kTrapezoid);
}

// Sets `from` to the end of the segment.
PathProblem lay_out_orientation(CartesianSegment& segment, const ArmPlane& plane, Transform& from,
                                const SegmentRequest& request) {
  const Transform to{request.target.rotation, segment.path.end_mm};
  if (!plane.exists()) {
    const bool tangent = request.turning == SegmentRequest::Turning::kTangent;
    segment.orientation = tangent ? turn_with(segment.path, from.rotation) : turn(from.rotation, to.rotation);
    from = {segment.orientation.end, to.position_mm};
    return {};
  }
  const TurningEnd end = lay_out_requested_turning(segment, plane, from, to, request);
  if (!(end.residual_rad <= plane.max_residual_rad())) {
    return {.kind = Kind::kOrientation, .at = end.refused_from, .residual_rad = end.residual_rad};
  }
  segment.residual_rad = end.residual_rad;
  from = end.base_T_tool;
  return {};
}

// Sets `from` to the end of the segment.
PathProblem lay_out_segment(CartesianPlan& plan, CartesianSegment& segment, const ArmPlane& plane, Transform& from,
                            const SegmentRequest& request) {
  if (!are_limits(request.limits, request.profile)) return {.kind = Kind::kInvalidLimits};
  if (!is_rigid(request.target)) return {.kind = Kind::kInvalidPose};
  const bool is_spline = request.kind == SegmentRequest::Kind::kSpline;
  if (is_spline && plan.spline_count == plan.splines.size()) return {.kind = Kind::kTooManySegments};
  const std::optional<PositionPath> path =
      path_of(request, from.position_mm, plan.splines[plan.spline_count % plan.splines.size()]);
  if (!path) return {.kind = is_spline ? Kind::kNoSpline : Kind::kNoCircle};
  if (is_spline) ++plan.spline_count;
  segment = {};
  segment.path = *path;
  segment.limits = request.limits;
  segment.at_singularity = request.at_singularity;
  segment.orientation_tolerance_rad = request.orientation_tolerance_rad;
  segment.configuration = request.configuration;
  segment.profile = request.profile;
  segment.rapid = request.rapid;
  segment.tag = request.tag;
  return lay_out_orientation(segment, plane, from, request);
}

}  // namespace

PathProblem lay_out_path(CartesianPlan& plan, const ArmPlane& plane, const JointAngles& start,
                         const Transform& base_T_tool, std::span<const SegmentRequest> chain) noexcept {
  plan.start = plan.target = start;
  plan.tool_T_flange = inverse(plane.flange_T_tool());
  plan.count = 0;
  plan.spline_count = 0;
  plan.duration = {};
  plan.table.clear();
  plan.outputs.clear();
  plan.bends.count = 0;
  plan.continues = false;
  plan.dropped = plan.known = plan.outputs_over = 0;
  plan.end_base_T_tool = base_T_tool;
  return add_segments(plan, plane, chain);
}

PathProblem add_segments(CartesianPlan& plan, const ArmPlane& plane, std::span<const SegmentRequest> chain) noexcept {
  const std::size_t room = CartesianPlan::kMaxSegments - plan.count;
  if (chain.size() > room) {
    return {.kind = Kind::kTooManySegments, .segment = static_cast<std::uint8_t>(std::min<std::size_t>(room, 255))};
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    PathProblem problem = lay_out_segment(plan, plan.segments[plan.count], plane, plan.end_base_T_tool, chain[i]);
    problem.segment = static_cast<std::uint8_t>(i);
    if (problem.kind != Kind::kNone) return problem;
    ++plan.count;
  }
  return {};
}

}  // namespace armature
