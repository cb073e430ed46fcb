// The geometry of a chain: from what is asked for to the segments of a plan, their shapes and how the tool turns on
// them. Times come later (chain_timing.hpp).
//
// On a five-axis arm the tool is held in the arm's plane, five_axis_turning.hpp; its tool point is on the path exactly
// whatever the tool.
#pragma once

#include <span>

#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"

namespace armature {

// Fills start, target (the same), tool_T_flange, count and the segments of `plan`: path, turning, limits and tag; laws
// and times are left empty. `base_T_tool` is where the tool is at `start`. Segment i + 1 begins where segment i ends.
//
// Everything that is wrong with the requests by themselves is found here, segment by segment; kNone when nothing is:
//   kTooManySegments  more than CartesianPlan::kMostSegments; `segment` is the first that is too many
//   kInvalidLimits    a limit that is not above 0, or beyond kLargestPathLimit; jerks of S-curves only
//   kInvalidPose      a target that is no pose
//   kNoCircle         an arc or a circle whose points determine none
//   kOrientation      an end orientation that misses what a five-axis arm can hold by more than
//                     ArmPlane::max_residual_rad(); `at` is 1
// With a problem the plan is of no use.
[[nodiscard]] PathProblem lay_out_path(CartesianPlan& plan, const ArmPlane& plane, const JointAngles& start,
                                       const Transform& base_T_tool, std::span<const SegmentRequest> chain) noexcept;

}  // namespace armature
