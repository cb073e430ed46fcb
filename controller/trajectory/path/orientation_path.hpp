// Turning from one orientation to another about one fixed axis, Vo 2021 eq. (20)-(22), corrected: the trace of (20) is
// r11 + r22 + r33, the axis of (21) is u and not r, alpha(T) is theta. Robust at 0 and at 180 degrees, where the
// printed arccos loses half of the digits and the axis is 0/0.
#pragma once

#include <Eigen/Core>

namespace armature {

// R(s) = start * Rot(axis, s * angle), s = 0..1.
struct OrientationPath {
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d end = Eigen::Matrix3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // unit, in the frame of `start`; 0 when the angle is 0
  double angle_rad = 0.0;                          // 0..pi
};

// A turn that is this close to half a turn counts as one, so that rounding does not decide which way the tool turns.
inline constexpr double kHalfTurnRounding_rad = 1e-14;

// The shorter way round. At 180 degrees both are equally long: the axis' component of largest magnitude (the first of
// equal ones) is then positive.
[[nodiscard]] OrientationPath turn(const Eigen::Matrix3d& start, const Eigen::Matrix3d& end) noexcept;

// Exactly `start` at s <= 0 and `end` at s >= 1.
[[nodiscard]] Eigen::Matrix3d rotation(const OrientationPath& path, double s) noexcept;

// Rot(axis, s * angle): the turn from `start`, in the frame of `start`. Identity at s <= 0, the whole turn at s >= 1.
[[nodiscard]] Eigen::Matrix3d turned(const OrientationPath& path, double s) noexcept;

}  // namespace armature
