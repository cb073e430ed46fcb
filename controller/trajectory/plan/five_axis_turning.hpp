// How the tool of a five-axis arm turns along a segment. Its approach has to stay in the vertical plane through axis 1
// that the tool point is in, so turning about one axis in space, as the tool of a six-axis arm does, is possible in two
// cases, and is done in these:
//   - an upright hand that stays upright, the same way up: picking and placing. Joint 5 turns against joint 1.
//   - a straight line over axis 1, in the plane that the arm is in, with a turn in that plane or none. Pitch, seen from
//     the tool point, would jump there.
// Everywhere else pitch and roll change linearly with the share of the path, each the shorter way (by half a turn:
// upwards in value), and the heading follows the tool point: a tilted tool is carried along a line or around an arc as
// the arm turns. Within one vertical plane that is the same as turning in space about one axis if only one of both
// changes.
//
// Limits of turning are then those of hypot(pitch rate, roll rate), the tool's angular speed seen in the arm's plane.
// The heading's share is left out: it is the position's, speed_mm_s and the joints limit it, and a tool that "does not
// turn" is not slowed down by limits of turning.
#pragma once

#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"

namespace armature {

// The end of a segment that turns.
struct TurningEnd {
  Transform base_T_tool{};    // where the next segment begins
  double residual_rad = 0.0;  // from the orientation asked for to that; 0 when none was
};

// Fills how `segment`, whose path is known, turns from `from`, which the arm holds, to `to`, whose position is that of
// the path's end. `keeps`: the rotation of `to` is the one of ArmPlane::kept(). On an arm with a plane only.
[[nodiscard]] TurningEnd lay_out_turning(CartesianSegment& segment, const ArmPlane& plane, const Transform& from,
                                         const Transform& to, bool keeps) noexcept;

}  // namespace armature
