// All values that the joint angles of SixR determine, shared by forward kinematics and velocities.
#pragma once

#include <Eigen/Core>

#include "controller/base/math.hpp"

namespace armature {

struct SixRPosture {
  math::SinCos j1, j2, j23, j4, j5, j6;
  Eigen::Matrix3d base_R_forearm;    // R03
  double ex_mm, ey_mm;               // from axis 3 to the wrist centre, in the plane of the arm
  double x_mm, y_mm;                 // from axis 2 to the wrist centre
  double r_mm;                       // its signed distance from axis 1
  Eigen::Vector3d approach_forearm;  // z of the flange in the frame of the forearm

  [[nodiscard]] Eigen::Vector3d approach() const noexcept { return base_R_forearm * approach_forearm; }
};

}  // namespace armature
