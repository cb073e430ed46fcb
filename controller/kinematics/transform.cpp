#include "controller/kinematics/transform.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "controller/base/math.hpp"

namespace armature {

bool is_rigid(const Transform& a_T_b) noexcept {
  constexpr double kTolerance = 1e-6;
  const auto x = a_T_b.rotation.col(0), y = a_T_b.rotation.col(1), z = a_T_b.rotation.col(2);
  const Eigen::Vector3d right_handed = x.cross(y) - z;
  // Written so that a NaN returns false.
  return std::fabs(x.squaredNorm() - 1.0) <= kTolerance && std::fabs(y.squaredNorm() - 1.0) <= kTolerance &&
         std::fabs(x.dot(y)) <= kTolerance && std::fabs(right_handed.x()) <= kTolerance &&
         std::fabs(right_handed.y()) <= kTolerance && std::fabs(right_handed.z()) <= kTolerance &&
         std::fabs(a_T_b.position_mm.x()) <= kFarthest_mm && std::fabs(a_T_b.position_mm.y()) <= kFarthest_mm &&
         std::fabs(a_T_b.position_mm.z()) <= kFarthest_mm;
}

const void* Transform::misfit() const noexcept {
  if (is_rigid(*this)) return nullptr;
  const bool rotates = is_rigid({.rotation = rotation});
  return rotates ? static_cast<const void*>(&position_mm) : &rotation;
}

Eigen::Matrix3d rotation_from_rpy(double roll_rad, double pitch_rad, double yaw_rad) noexcept {
  const auto [sr, cr] = math::sin_cos(roll_rad);
  const auto [sp, cp] = math::sin_cos(pitch_rad);
  const auto [sy, cy] = math::sin_cos(yaw_rad);
  Eigen::Matrix3d rotation;
  rotation << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,          //
      -sp, cp * sr, cp * cr;
  return rotation;
}

RollPitchYaw rpy_from_rotation(const Eigen::Matrix3d& rotation) noexcept {
  const double horizontal = math::hypot(rotation(0, 0), rotation(1, 0));  // |cos(pitch)|
  const double pitch_rad = math::atan2(-rotation(2, 0), horizontal);
  constexpr double kGimbalLock = 1e-9;
  const double roll_rad = horizontal < kGimbalLock ? 0.0 : math::atan2(rotation(2, 1), rotation(2, 2));
  // Yaw from the second column with the roll removed: correct for any chosen roll, so also in and near gimbal lock.
  const auto [sr, cr] = math::sin_cos(roll_rad);
  const double yaw_rad =
      math::atan2(sr * rotation(0, 2) - cr * rotation(0, 1), cr * rotation(1, 1) - sr * rotation(1, 2));
  return {roll_rad, pitch_rad, yaw_rad};
}

}  // namespace armature
