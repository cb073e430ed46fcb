// The arm of Hu 2012 Table 1 and what the tests of FiveR share. Lengths are the table's, taken as mm.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

inline ArmGeometry hu_arm(double a1_mm = 1.1, double max_projection_rad = 0.0) {
  ArmGeometry arm;
  arm.family = ArmFamily::kFiveR;
  arm.a1_mm = a1_mm;
  arm.a2_mm = 10.0;
  arm.a3_mm = 9.5;
  arm.a4_mm = 3.2;
  arm.d5_mm = 14.5;
  arm.max_projection_rad = max_projection_rad;
  return arm;
}

// One Denavit-Hartenberg link, written out on its own: the product of five is the oracle of forward().
inline Transform link(double theta, double d, double a, double alpha) {
  const double c = std::cos(theta), s = std::sin(theta), ca = std::round(std::cos(alpha)),
               sa = std::round(std::sin(alpha));
  Transform transform;
  transform.rotation << c, -s * ca, s * sa, s, c * ca, -c * sa, 0.0, sa, ca;
  transform.position_mm << a * c, a * s, d;
  return transform;
}

inline Transform product_of_links(const ArmGeometry& arm, const Theta& theta) {
  return link(theta[0], 0.0, arm.a1_mm, -kPi / 2) * link(theta[1], 0.0, arm.a2_mm, 0.0) *
         link(theta[2], 0.0, arm.a3_mm, 0.0) * link(theta[3], 0.0, arm.a4_mm, -kPi / 2) *
         link(theta[4], arm.d5_mm, 0.0, 0.0);
}

inline Theta random_theta(Random& random) {
  Theta theta{};
  for (std::size_t joint = 0; joint < 5; ++joint) theta[joint] = random.real(-kPi, kPi);
  return theta;
}

// Largest difference of any angle modulo whole turns.
inline double angle_distance(const Theta& a, const Theta& b) {
  double worst = 0.0;
  for (std::size_t joint = 0; joint < a.size(); ++joint) {
    worst = std::max(worst, std::fabs(std::remainder(a[joint] - b[joint], 2.0 * kPi)));
  }
  return worst;
}

inline double rotation_difference(const Transform& a, const Transform& b) {
  return (a.rotation - b.rotation).cwiseAbs().maxCoeff();
}

inline double position_difference_mm(const Transform& a, const Transform& b) {
  return (a.position_mm - b.position_mm).cwiseAbs().maxCoeff();
}

// The angle of the rotation from a to b, good to 1e-15 near 0.
inline double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d difference = a.transpose() * b;
  const Eigen::Vector3d axis{difference(2, 1) - difference(1, 2), difference(0, 2) - difference(2, 0),
                             difference(1, 0) - difference(0, 1)};
  return std::atan2(axis.norm(), difference.trace() - 1.0);
}

// Rodrigues' formula.
inline Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d u = axis.normalized();
  Eigen::Matrix3d cross;
  cross << 0.0, -u.z(), u.y(), u.z(), 0.0, -u.x(), -u.y(), u.x(), 0.0;
  return Eigen::Matrix3d::Identity() + std::sin(angle) * cross + (1.0 - std::cos(angle)) * cross * cross;
}

inline Eigen::Vector3d random_direction(Random& random) {
  Eigen::Vector3d direction;
  do {
    direction << random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0);
  } while (direction.norm() < 0.1 || direction.norm() > 1.0);
  return direction.normalized();
}

}  // namespace armature::test
