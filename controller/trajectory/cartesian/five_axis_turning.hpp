// How the tool of a five-axis arm rotates along a segment. Its approach must stay in the vertical plane through axis 1
// that contains the tool point. So a rotation about one axis in space, as on a six-axis arm, is possible in two cases:
//   - an upright tool that stays upright, the same way up: pick and place. Joint 5 turns against joint 1.
//   - a straight line across axis 1, in the present plane of the arm, with a rotation in that plane or none. The pitch
//     relative to the tool point would jump there.
// In all other cases pitch and roll change linearly with the share of the path, each in the shorter direction (half a
// turn: upwards in value), and the heading follows the tool point: a tilted tool turns with the arm along a line or an
// arc. Within one vertical plane this is the same as a rotation in space about one axis if only one of the two angles
// changes.
//
// On request a tilted tool rotates about one axis in space, too. Each orientation is turned into the plane of the arm
// by the smallest angle, which must not be more than ArmPlane::max_residual_rad() anywhere on the segment.
//
// Where pitch and roll change, limits of rotation apply to hypot(pitch rate, roll rate), the tool's angular speed in
// the arm's plane. The heading is not included, because it belongs to the position: speed_mm_s and the joints limit it.
// So a tool that "does not rotate" is not slowed down by limits of rotation.
#pragma once

#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/arm_plane.hpp"

namespace armature {

// The tool at the end of a segment that rotates.
struct TurningEnd {
  Transform base_T_tool{};  // the start of the next segment
  // From the requested orientation to that of base_T_tool; 0 if none was requested. A rotation in space that is turned
  // into the plane: the largest angle on the segment.
  double residual_rad = 0.0;
  double refused_from = 1.0;  // share of the segment where the residual first exceeds ArmPlane::max_residual_rad()
};

// Sets how `segment`, whose path is known, rotates from `from` to `to`. The arm can hold `from`; the position of `to`
// is the end of the path. `keeps`: the rotation of `to` is that of ArmPlane::kept(). Only for an arm with a plane.
[[nodiscard]] TurningEnd lay_out_turning(CartesianSegment& segment, const ArmPlane& plane, const Transform& from,
                                         const Transform& to, bool keeps) noexcept;

// The same as SegmentRequest::Turning of `request` says. A tool that turns with the tangent of the path: the arm can
// hold that exactly where an upright tool goes along a horizontal path, and on an arc about axis 1.
[[nodiscard]] TurningEnd lay_out_requested_turning(CartesianSegment& segment, const ArmPlane& plane,
                                                   const Transform& from, const Transform& to,
                                                   const SegmentRequest& request) noexcept;

}  // namespace armature
