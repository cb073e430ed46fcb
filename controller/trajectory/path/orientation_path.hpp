// Turning from one orientation to another about one fixed axis, Vo 2021 eq. (20)-(22), corrected: the trace of (20) is
// r11 + r22 + r33, the axis of (21) is u and not r, alpha(T) is theta. Robust at 0 and at 180 degrees, where the
// printed arccos loses half of the digits and the axis is 0/0.
#pragma once

#include <Eigen/Core>

#include "controller/trajectory/path/position_path.hpp"

namespace armature {

// R(s) = start * Rot(axis, s * angle), s = 0..1.
struct OrientationPath {
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d end = Eigen::Matrix3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // unit, in the frame of `start`; 0 when the angle is 0
  double angle_rad = 0.0;                          // 0..pi; turn_with(): that of the path
};

// An angle this close to 180 degrees counts as 180 degrees, so that rounding does not decide the direction of rotation.
inline constexpr double kHalfTurnRounding_rad = 1e-14;

// The shorter direction of rotation. At 180 degrees both are equally long; then the axis' component of largest
// magnitude (the first of equal ones) is positive.
[[nodiscard]] OrientationPath turn(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end) noexcept;

// The rotation of a tool that turns with the tangent of a path: on arcs, circles and helices about their axis by their
// angle, which may be several turns; none on a line. Where the path ends at its start, the end is exactly the start.
[[nodiscard]] OrientationPath turn_with(const PositionPath& path, const Eigen::Matrix3d& start) noexcept;

// Exactly `start` for s <= 0 and `end` for s >= 1.
[[nodiscard]] Eigen::Matrix3d rotation(const OrientationPath& path, double s) noexcept;

// Rot(axis, s * angle): the rotation from `start`, in the frame of `start`. Identity for s <= 0, the whole rotation for
// s >= 1.
[[nodiscard]] Eigen::Matrix3d turned(const OrientationPath& path, double s) noexcept;

}  // namespace armature
