// The limits of the tool along the path of a plan: speed, acceleration (along and across the path) and the
// same of the rotation, as limits of the law of its parameter.
#pragma once

#include <cstddef>

#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/law/law_limits.hpp"

namespace armature {

// A ramp lasts for at least this many ticks. Then the values that PathCheck measures over ticks are those of the law; a
// ramp of one tick would have 1.25 times as much between ticks.
inline constexpr double kRampTicks = 3.0;

// The length of the parameter between the stops before and after a segment. Ramps of the law last for kRampTicks at
// least, so short runs have lower limits.
[[nodiscard]] double run_around(const CartesianPlan& plan, std::size_t segment) noexcept;

// Outside of the corners, at this share of the segment. They are the same on a whole line or arc. On a spline they are
// less by kCornerShare, because they change between the points of the grid.
inline constexpr double kCornerShare = 0.997;
[[nodiscard]] LawLimits limits_of_tool(const CartesianSegment& segment, double share, double run_length) noexcept;

// At `s` in the corner after segment `first`, with the limits of one of its two segments, `half`, less kCornerShare.
[[nodiscard]] LawLimits limits_in_corner(const CartesianPlan& plan, std::size_t first, const CartesianSegment& half,
                                         double s, double run_length) noexcept;

}  // namespace armature
