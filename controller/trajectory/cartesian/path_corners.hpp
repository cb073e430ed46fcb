// The joints between the segments of a plan: which are passed, and how corners are rounded.
//
//   smooth   the tool and its rotation continue in the same direction: passed on the path, at the speed that the limits
//            allow. With limited jerk a jump of the curvature is passed slowly, unless it is rounded with `blend_mm`
//   rounded  the direction changes and `blend_mm` is above 0: a piece of path with a continuous curvature
//            (cartesian_plan.hpp)
//   stop     everything else: a direction that changes without `blend_mm`; beside a segment that only, or almost
//            only, rotates; a reversal; on a five-axis arm a segment whose heading follows the tool point beside one
//            that rotates in space
//
// blend_mm is a deviation: the largest distance of the rounded path from the corner point and from the two segments. It
// is used as far as half of the shorter segment allows. A rotation counts as well, as the way of a point kTurnLever_mm
// from the tool point.
#pragma once

#include <cstdint>
#include <span>

#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/segment_request.hpp"

namespace armature {

// A change of direction up to this is smooth. Coordinates with four decimals give less on segments above 1 mm.
inline constexpr double kSmooth_rad = 1e-3;

enum class PathJoint : std::uint8_t { kStop, kSmooth, kRounded };

// Lengths and angles up to these are rounding and count as 0.
inline constexpr double kNoLength_mm = 1e-9;
inline constexpr double kNoAngle_rad = 1e-12;

[[nodiscard]] inline bool has_length(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm > kNoLength_mm;
}
[[nodiscard]] inline bool is_empty(const CartesianSegment& segment) noexcept {
  return segment.path.length_mm <= kNoLength_mm && turn_angle_rad(segment) <= kNoAngle_rad;
}

// What the tool does at a point of its path: the derivatives of its position and rotation by the parameter.
struct PathDirection {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();         // mm
  Eigen::Vector3d turn_per_mm = Eigen::Vector3d::Zero();  // in the space to which the limits of rotation apply
};
// At a share of a segment; the turn in space is that at its start.
[[nodiscard]] PathDirection direction_at(const CartesianSegment& segment, double share) noexcept;

// The second derivative of the position by the parameter at a share of a segment.
[[nodiscard]] Eigen::Vector3d bend_at(const CartesianSegment& segment, double share) noexcept;

// The joint between segments `first` and `first` + 1 of a plan whose parameters are laid out.
[[nodiscard]] PathJoint joint_after(const CartesianPlan& plan, std::size_t first) noexcept;

// Sets from, length and corner of all segments. `rounds`: false makes a stop of each corner that could be rounded.
void lay_out_corners(CartesianPlan& plan, std::span<const SegmentRequest> chain, bool rounds) noexcept;

// The same for segments behind `last`, the last one of the plan so far, whose corner may now be up to `longest`.
void add_corners(CartesianPlan& plan, std::size_t last, double blend_mm, double longest,
                 std::span<const SegmentRequest> added) noexcept;

// Length of the whole parameter.
[[nodiscard]] inline double length_of(const CartesianPlan& plan) noexcept {
  return plan.count == 0 ? 0.0 : plan.segments[plan.count - 1].from + plan.segments[plan.count - 1].length;
}

}  // namespace armature
