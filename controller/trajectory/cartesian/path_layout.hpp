// The geometry of a chain: from the requests to the segments of a plan, with their shapes and rotations. Times follow
// later (chain_law.hpp).
//
// On a five-axis arm the tool is held in the arm's plane (five_axis_turning.hpp). The tool point is exactly on the path
// for any tool.
#pragma once

#include <span>

#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"

namespace armature {

// Sets start, target (the same), tool_T_flange, count, the splines and the segments of `plan`: path, rotation, limits
// and tag. Laws and times stay empty. `base_T_tool` is the tool at `start`. Segment i + 1 begins where segment i ends.
//
// Finds all errors of the requests themselves, segment by segment; kNone if there is none:
//   kTooManySegments  more than CartesianPlan::kMaxSegments, or more splines than kMaxSplines; `segment` is the first
//                     one too many
//   kInvalidLimits    a limit that is not above 0, or beyond kLargestPathLimit; jerks of S-curves only
//   kInvalidPose      a target that is not a rigid pose
//   kNoCircle         an arc or a circle whose points do not determine one
//   kNoSpline         points that Spline::through() refuses
//   kOrientation      an end orientation that a five-axis arm misses by more than ArmPlane::max_residual_rad(); `at`
//                     is 1
// With a problem the plan is not valid.
[[nodiscard]] PathProblem lay_out_path(CartesianPlan& plan, const ArmPlane& plane, const JointAngles& start,
                                       const Transform& base_T_tool, std::span<const SegmentRequest> chain) noexcept;

// Adds segments to the end of the plan: path, rotation, limits and tag. `segment` of a problem is an index in `chain`.
[[nodiscard]] PathProblem add_segments(CartesianPlan& plan, const ArmPlane& plane,
                                       std::span<const SegmentRequest> chain) noexcept;

// Whether a request, or the move from which it is made, can be part of a plan that continues another one: without a
// spline and a wanted bend, and with outputs on its own segment only.
template <class Request>
[[nodiscard]] bool may_continue(const Request& request) noexcept {
  return request.kind != SegmentRequest::Kind::kSpline && request.at_singularity != AtSingularity::kBend &&
         are_on_own_move(request.outputs);
}

}  // namespace armature
