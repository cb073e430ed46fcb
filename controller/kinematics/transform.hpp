// Rigid transforms. Names read from left to right: base_T_tool is the pose of the tool expressed in the base, and
// products chain: base_T_flange * flange_T_tool = base_T_tool.
//
// Eigen is compiled without explicit vectorisation (EIGEN_DONT_VECTORIZE), so that sums have one order everywhere.
#pragma once

#include <Eigen/Core>

#include "controller/base/members.hpp"

namespace armature {

struct Transform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // orthonormal, determinant +1
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();

  [[nodiscard]] const void* misfit() const noexcept;  // see is_rigid()
  ARMATURE_MEMBERS(Transform, rotation, position_mm)
};

[[nodiscard]] inline Transform operator*(const Transform& a_T_b, const Transform& b_T_c) noexcept {
  return {a_T_b.rotation * b_T_c.rotation, a_T_b.rotation * b_T_c.position_mm + a_T_b.position_mm};
}

[[nodiscard]] inline Eigen::Vector3d operator*(const Transform& a_T_b, const Eigen::Vector3d& point_b) noexcept {
  return a_T_b.rotation * point_b + a_T_b.position_mm;
}

[[nodiscard]] inline Transform inverse(const Transform& a_T_b) noexcept {
  return {a_T_b.rotation.transpose(), -(a_T_b.rotation.transpose() * a_T_b.position_mm)};
}

// Largest coordinate of a position that the kinematics accept.
inline constexpr double kFarthest_mm = 1e9;

// True for a rigid pose: the rotation is orthonormal and right-handed within 1e-6 (the accuracy of six decimals), the
// position is finite and within kFarthest_mm. The inverse kinematics refuse any other pose as kInvalidInput.
[[nodiscard]] bool is_rigid(const Transform& a_T_b) noexcept;

// Rotations about the fixed axes x, then y, then z: R = Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] Eigen::Matrix3d rotation_from_rpy(double roll_rad, double pitch_rad, double yaw_rad) noexcept;

struct RollPitchYaw {
  double roll_rad = 0.0, pitch_rad = 0.0, yaw_rad = 0.0;
};
// The inverse, pitch in [-pi/2, pi/2]. The roll is 0 where only roll + yaw or their difference is determined.
[[nodiscard]] RollPitchYaw rpy_from_rotation(const Eigen::Matrix3d& rotation) noexcept;

}  // namespace armature
