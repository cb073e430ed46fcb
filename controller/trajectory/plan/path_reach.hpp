// Checks with one inverse kinematics each whether the requested points of a chain can be reached, before the path to
// them is checked.
#pragma once

#include <cstddef>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"

namespace armature {

// The largest number of such points, each with one inverse kinematics.
[[nodiscard]] std::size_t points_of(std::span<const SegmentRequest> chain) noexcept;

// The points are the ends of the segments, via points of arcs, second and third points of circles, and points of
// splines; `plan` is the result of lay_out_path() for `chain`. Returns kNone, or the problem of the first point in the
// order of the path that has no solution with any branch:
//   kUnreachable  with `margin_mm`: beyond the reach, or closer to axis 1 than the tool is aside of a five-axis arm's
//                 plane
//   kOrientation  with `residual_rad`
// `at` is the share of its segment at the point, 1 for an end. Joint limits are not checked here, because they depend
// on the branch that the path leads to. A point within the blend of a corner is skipped, because the tool need not pass
// it, unless it is beyond the reach by more than the blend radius.
[[nodiscard]] PathProblem find_unreachable(const CartesianPlan& plan, const Arm& arm,
                                           std::span<const SegmentRequest> chain) noexcept;

}  // namespace armature
