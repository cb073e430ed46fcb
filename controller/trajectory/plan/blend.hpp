// Rounding of corners between segments by superposition in time, and the limits of a segment's time law: for plans
// without a table, which have an S-curve.
//
// While two segments overlap, the first one brakes along its direction t1 and the second one accelerates along t2. With
// the angle theta between them the acceleration of the tool reaches |t2 - t1| = 2 sin(theta / 2) times that of one
// segment. Its jerk reaches max(|t2 - t1|, |t2 + t1|) times, because jerks of either sign meet. Speeds need no
// reduction: an overlap is not longer than a ramp, so one speed decreases while the other increases.
//
// The limits of the segments are divided by these factors. A trapezoid uses the divided limits only at its gentle ends,
// which last as long as the overlap (eased_trapezoid.hpp). Two such ends of equal length make a parabola through the
// corner with the full acceleration. The divisor of two lines is at most 2, so they take no longer than an exact stop.
// An S-curve uses the divided limits as a whole. This often costs more time than the overlap saves; the planner decides
// which corners are rounded.
//
// The same holds for rotations with their two axes. The angle between the axes stays constant through the corner, since
// the first rotation moves the second axis about the first one. Not included are the gyroscopic w1 x w2 of two
// rotations and ramps of different shapes. They are small, and PathCheck checks them.
//
// Where the heading of a five-axis arm follows the tool point, pitch and roll are added, and the direction of rotation
// is that in the plane of both angles. A corner between such a segment and one that rotates in space (for example where
// a vertical tool begins to tilt) cannot be superposed, because the arm could not hold the sum. The tool stops there.
#pragma once

#include "controller/core/units.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// Divisors of limits, >= 1.
struct Easing {
  double accel = 1.0;
  double jerk = 1.0;
  double turn_accel = 1.0;
  double turn_jerk = 1.0;
};

// Lengths and angles up to these are rounding and count as 0.
inline constexpr double kNoLength_mm = 1e-9;
inline constexpr double kNoAngle_rad = 1e-12;

[[nodiscard]] inline bool has_length(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm > kNoLength_mm;
}
[[nodiscard]] inline bool is_empty(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm <= kNoLength_mm && turn_angle_rad(segment) <= kNoAngle_rad;
}

// For both sides of a corner that is rounded within `blend_mm`. No easing where the tool stops in any case: blend_mm of
// 0, a neighbour without length, or one with another kind of rotation. On arcs the divisor includes the centripetal
// acceleration, at most 2 blend_mm / r of the eased one, and the rotation of the tangent, blend_mm / r of it.
[[nodiscard]] Easing easing(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept;
[[nodiscard]] Easing strongest(const Easing& a, const Easing& b) noexcept;

// A ramp lasts for at least this many ticks, and so does each of the four jerk phases of an S-curve. Then the values
// that PathCheck measures over ticks are those of the law; a ramp of one tick would have 1.25 times as much between
// ticks.
inline constexpr double kRampTicks = 3.0;
inline constexpr double kJerkTicks = 4.0;

// Limits of s = 0..1 for a segment that is not empty: position and orientation both keep their limits. On an arc the
// speed is at most sqrt(sqrt(3)/2 a r), where the centripetal acceleration leaves half of a for the motion along the
// path. The acceleration along the path is the rest, sqrt(a^2 - (v^2 / r)^2), so the tool's total acceleration stays
// within a.
[[nodiscard]] TimeLawLimits law_limits(const CartesianSegment& segment, const PathLimits& limits,
                                       const Easing& easing) noexcept;

// The requirements of a corner on the laws of both sides. Without a blend there are none: the tool stops.
struct Corner {
  double blend_mm = 0.0;
  Easing easing{};
  GentleEnd end_of_first{};  // of s = 0..1, for trapezoids
  GentleEnd start_of_second{};
};

// One side of a corner.
struct CornerSide {
  const CartesianSegment& segment;
  const PathLimits& limits;
  // Largest share of its path that may be in the corner: half, or a third if its other end may be rounded too.
  double most = 0.5;
};

// The corner at the largest speed that its tolerance and both sides allow. No blend where the tool stops in any case.
[[nodiscard]] Corner rounded_corner(const CornerSide& first, const CornerSide& second, double blend_mm) noexcept;

// The fastest law of a segment alone between two corners; an empty one takes no time.
[[nodiscard]] TimeLaw fastest_law(ProfileKind profile, const CartesianSegment& segment, const PathLimits& limits,
                                  const Corner& before, const Corner& after) noexcept;

// How long the second segment may run before the first has ended: the largest number of whole ticks for which neither
// the rest of the first nor the covered part of the second exceeds blend_mm or half of either length. It is also at
// most the gentle ends of both laws or, without them, the ramp and half of the duration. 0 where the tool stops.
[[nodiscard]] Ticks overlap(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept;

}  // namespace armature
