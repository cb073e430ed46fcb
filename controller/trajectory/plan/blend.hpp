// Corners between segments that are rounded by superposition, and the limits of a segment's time law.
//
// While two segments overlap, the first one brakes along its direction t1 and the second one speeds up along t2. With
// the angle theta between them the tool accelerates by up to |t2 - t1| = 2 sin(theta / 2) times what each may alone,
// and jerks by up to max(|t2 - t1|, |t2 + t1|) times, because jerks of either sign meet. Speeds need no such care:
// neither overlap is longer than a ramp, so one fades out while the other fades in.
//
// A trapezoid is planned with limits divided by that at its gentle ends only, which last as long as the overlap
// (eased_trapezoid.hpp). Two such ends of equal length drive a parabola through the corner with the full acceleration,
// and as the divisor of two lines is at most 2 they take no longer than an exact stop. An S-curve is planned with the
// divided limits as a whole, which often costs more than the overlap gains: whether a corner pays is for the planner.
//
// For turning the same holds with the two axes of rotation. The angle between them stays what it is at the corner,
// since the first turn moves the second axis about the first one. What this leaves out - the gyroscopic w1 x w2 of two
// turns, ramps of different shapes - is small and is left to PathCheck.
//
// Where the heading of a five-axis arm follows the tool point, pitch and roll add up, and the directions of turning are
// those in the plane of both angles. A corner between such a segment and one that turns in space, as where a vertical
// hand begins to tilt, has no sum that the arm could hold: the tool stops there.
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

// What a path shorter than rounding is: nothing to drive along.
inline constexpr double kNoLength_mm = 1e-9;
inline constexpr double kNoAngle_rad = 1e-12;

[[nodiscard]] inline bool has_length(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm > kNoLength_mm;
}
[[nodiscard]] inline bool is_empty(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm <= kNoLength_mm && turn_angle_rad(segment) <= kNoAngle_rad;
}

// For both sides of a corner that is left by `blend_mm`; none where the tool stops anyway: blend_mm of 0, a neighbour
// without length, or one that turns in the other way. On arcs the divisor holds the centripetal acceleration, at most
// 2 blend_mm / r of the eased one, and the turning of the tangent, blend_mm / r of it.
[[nodiscard]] Easing easing(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept;
[[nodiscard]] Easing strongest(const Easing& a, const Easing& b) noexcept;

// A ramp lasts for this many ticks at least, and each of the four jerks of an S-curve. What PathCheck measures over
// ticks then is what the law has; a ramp of one tick would have 1.25 times as much between ticks.
inline constexpr double kRampTicks = 3.0;
inline constexpr double kJerkTicks = 4.0;

// Limits of s = 0..1 for a segment that is not empty: position and orientation keep theirs both. On an arc the speed is
// at most sqrt(sqrt(3)/2 a r), where the centripetal acceleration leaves half of a for speeding up, and the
// acceleration along the path is what v^2 / r leaves, sqrt(a^2 - (v^2 / r)^2): the tool's total stays within a.
[[nodiscard]] TimeLawLimits law_limits(const CartesianSegment& segment, const PathLimits& limits,
                                       const Easing& easing) noexcept;

// What a corner asks of the laws on both sides. Without a blend: nothing, the tool stops.
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
  // How much of its path may lie in the corner: half, or a third where its other end may be rounded, too.
  double most = 0.5;
};

// The corner at the largest speed that its tolerance and both sides allow. No blend where the tool stops anyway.
[[nodiscard]] Corner rounded_corner(const CornerSide& first, const CornerSide& second, double blend_mm) noexcept;

// The fastest law of a segment by itself between two corners; an empty one takes no time.
[[nodiscard]] TimeLaw fastest_law(ProfileKind profile, const CartesianSegment& segment, const PathLimits& limits,
                                  const Corner& before, const Corner& after) noexcept;

// How long the second segment may run before the first has ended: the largest number of whole ticks such that neither
// the rest of the first nor the covered part of the second exceeds blend_mm or half of either length, and at most the
// gentle ends of either law or, where there are none, its ramp and half of its duration. 0 where the tool stops.
[[nodiscard]] Ticks overlap(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept;

}  // namespace armature
