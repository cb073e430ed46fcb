// Whether the points that a chain asks for can be reached at all: found by one inverse kinematics each, before the path
// to them is looked at.
#pragma once

#include <cstddef>
#include <span>

#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/path/path_problem.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"

namespace armature {

// How many points that is at most; an inverse kinematics each.
[[nodiscard]] std::size_t points_of(std::span<const SegmentRequest> chain) noexcept;

// The points are the ends of the segments, via points of arcs, second and third points of circles; `plan` is what
// lay_out_path() made of `chain`. The answer is kNone or, of the first point in the order of the path that has no
// solution whatever the branch,
//   kUnreachable  with `margin_mm`: beyond the reach, or nearer to axis 1 than the tool is aside of a five-axis arm's
//                 plane
//   kOrientation  with `residual_rad`
// and `at`, the share of its segment where the point is: 1 for an end. Joint limits are not looked at, they depend on
// the branch that the path leads to. A point within the blend of a corner is left out where the tool need not come
// there: unless it is farther beyond the reach than the corner may be missed by.
[[nodiscard]] PathProblem find_unreachable(const CartesianPlan& plan, const Arm& arm,
                                           std::span<const SegmentRequest> chain) noexcept;

}  // namespace armature
