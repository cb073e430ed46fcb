#include "controller/trajectory/cartesian/five_axis_turning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/trajectory/path/orientation_path.hpp"

namespace armature {
namespace {

constexpr double kRounding = 1e-12;  // sines, and lengths as a share of the length

double shorter_turn(double from_rad, double to_rad) {
  const double change = wrapped(to_rad - from_rad);
  return std::fabs(change) >= std::numbers::pi - kHalfTurnRounding_rad ? std::fabs(change) : change;
}

// True for a straight line across axis 1 with a rotation that stays in the plane of the arm.
bool passes_over_axis_1(const CartesianSegment& segment, const ArmPlane& plane, const Transform& from) {
  if (segment.path.shape != PositionPath::Shape::kLine) return false;
  if (!plane.passes_over_axis_1(from, segment.path.end_mm)) return false;
  const OrientationPath& turn = segment.orientation;
  if (turn.angle_rad <= kRounding) return true;
  const math::SinCos heading = math::sin_cos(plane.heading_rad(from));
  const Eigen::Vector3d normal{-heading.sin, heading.cos, 0.0}, axis = turn.start * turn.axis;
  return (axis - axis.dot(normal) * normal).norm() <= kRounding;
}

// Rotates in space, turned into the plane of the arm.
TurningEnd turn_in_space(CartesianSegment& segment, const ArmPlane& plane, const Transform& from,
                         const OrientationPath& turning) {
  constexpr int kSamples = 41;  // a prime number: the samples of several turns of a path are at different angles
  segment.orientation = turning;
  const Transform to{turning.end, segment.path.end_mm};
  if (passes_over_axis_1(segment, plane, from)) return {.base_T_tool = to};
  segment.turning = Turning::kIntoPlane;
  TurningEnd end{.base_T_tool = into_plane(to, plane.flange_T_tool()).base_T_tool};
  // The first turn shows all orientations.
  const double first_turn = kTurn_rad / std::max(turning.angle_rad, kTurn_rad);
  for (int i = 1; i <= kSamples; ++i) {
    const double share = first_turn * i / kSamples;
    const Transform tool{rotation(turning, share), point(segment.path, share)};
    const Transform held = into_plane(tool, plane.flange_T_tool()).base_T_tool;
    end.residual_rad = std::max(end.residual_rad, turn(tool.rotation, held.rotation).angle_rad);
    const bool first = end.refused_from == 1.0 && end.residual_rad > plane.max_residual_rad();
    if (first) end.refused_from = share;
  }
  return end;
}

}  // namespace

TurningEnd lay_out_turning(CartesianSegment& segment, const ArmPlane& plane, const Transform& from, const Transform& to,
                           bool keeps) noexcept {
  segment.orientation = turn(from.rotation, to.rotation);
  const int upright = plane.upright(from);
  if (upright != 0 && plane.upright(to) == upright) {
    // An exactly vertical tool is in every plane and needs no change, even where the heading is undefined.
    if (plane.tilt(from) <= kRounding && plane.tilt(to) <= kRounding) return {.base_T_tool = to};
    segment.turning = Turning::kIntoPlane;
    const Transform end = into_plane(to, plane.flange_T_tool()).base_T_tool;
    return {.base_T_tool = end, .residual_rad = keeps ? 0.0 : turn(to.rotation, end.rotation).angle_rad};
  }
  if (passes_over_axis_1(segment, plane, from)) return {.base_T_tool = to};

  const PlaneAngles start = plane.nearest(from).angles;
  const ArmPlane::Nearest end = keeps ? ArmPlane::Nearest{.angles = start} : plane.nearest(to);
  segment.turning = Turning::kFollowing;
  segment.orientation = {};
  segment.plane_turn = {.start = start,
                        .change = {.pitch_rad = shorter_turn(start.pitch_rad, end.angles.pitch_rad),
                                   .roll_rad = shorter_turn(start.roll_rad, end.angles.roll_rad)}};
  return {.base_T_tool = hold_tool(end.angles, to.position_mm, plane.flange_T_tool()).base_T_tool,
          .residual_rad = end.residual_rad};
}

TurningEnd lay_out_requested_turning(CartesianSegment& segment, const ArmPlane& plane, const Transform& from,
                                     const Transform& to, const SegmentRequest& request) noexcept {
  switch (request.turning) {
    case SegmentRequest::Turning::kSteady:
      break;
    case SegmentRequest::Turning::kSlerp: {
      const bool upright = plane.upright(from) != 0 && plane.upright(to) == plane.upright(from);
      if (upright) break;  // steady is a slerp
      return turn_in_space(segment, plane, from, turn(from.rotation, to.rotation));
    }
    case SegmentRequest::Turning::kTangent: {
      const OrientationPath turning = turn_with(segment.path, from.rotation);
      if (turning.angle_rad == 0.0) return lay_out_turning(segment, plane, from, to, true);
      const Eigen::Vector3d normal = turning.start * turning.axis;
      const bool horizontal = std::fabs(normal.z()) >= 1.0 - kRounding;
      if (!horizontal || plane.upright(from) == 0) return turn_in_space(segment, plane, from, turning);
      const Transform end{turning.end, segment.path.end_mm};
      segment.orientation = turning;
      if (plane.tilt(from) <= kRounding) return {.base_T_tool = end};
      segment.turning = Turning::kIntoPlane;
      return {.base_T_tool = into_plane(end, plane.flange_T_tool()).base_T_tool};
    }
  }
  return lay_out_turning(segment, plane, from, to, request.keeps_orientation);
}

}  // namespace armature
