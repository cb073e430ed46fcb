// Six-axis arms, poses and measures of error for the tests of their kinematics.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>

#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/robot/arm_geometry.hpp"
#include "controller/robot/robot_model.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

inline ArmGeometry six_r_geometry(double a1, double a2, double a3, double d1, double d4, double d6) {
  ArmGeometry arm;
  arm.family = ArmFamily::kSixR;
  arm.a1_mm = a1;
  arm.a2_mm = a2;
  arm.a3_mm = a3;
  arm.d1_mm = d1;
  arm.d4_mm = d4;
  arm.d6_mm = d6;
  return arm;
}

// Dimensions and vendor's maps of ROS-Industrial's models.
inline ArmGeometry irb120_geometry() {
  ArmGeometry arm = six_r_geometry(0, 270, 70, 290, 302, 72);
  arm.sign = {+1, -1, -1, +1, -1, +1};
  arm.offset_rad = {0, 90 * kDeg, 0, 0, 0, 180 * kDeg};
  return arm;
}
inline ArmGeometry kr6_r900() {
  ArmGeometry arm = six_r_geometry(25, 455, 35, 400, 420, 80);
  arm.sign = {-1, -1, -1, -1, -1, -1};
  arm.offset_rad = {0, 0, 90 * kDeg, 0, 0, 180 * kDeg};
  return arm;
}
inline ArmGeometry lrmate200id() {
  ArmGeometry arm = six_r_geometry(50, 330, 35, 330, 335, 80);
  arm.sign = {+1, -1, +1, -1, +1, -1};
  arm.offset_rad = {0, 90 * kDeg, 0, 0, 0, 0};
  return arm;
}
inline std::array<ArmGeometry, 3> vendor_arms() {
  return {irb120_geometry(), kr6_r900(), lrmate200id()};
}

// Wide limits, and speeds that the pulse generators do not restrict.
inline RobotModel robot_with(const ArmGeometry& arm) {
  RobotModel robot = paper_robot();
  for (AxisModel& axis : robot.axes) {
    axis.min_rad = -400 * kDeg;
    axis.max_rad = 400 * kDeg;
  }
  robot.arm = arm;
  return robot;
}

inline double forearm_mm(const ArmGeometry& arm) {
  return std::hypot(arm.a3_mm, arm.d4_mm);
}
inline double reach_mm(const ArmGeometry& arm) {
  return arm.a2_mm + forearm_mm(arm);
}

inline Theta random_angles(Random& random, double largest_rad = std::numbers::pi) {
  Theta theta;
  for (double& angle : theta) angle = random.real(-largest_rad, largest_rad);
  return theta;
}

inline Transform transform_of(const nlohmann::json& rows) {
  Transform pose;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const nlohmann::json& values = rows[static_cast<std::size_t>(row)];
    for (Eigen::Index column = 0; column < 3; ++column) {
      pose.rotation(row, column) = values[static_cast<std::size_t>(column)].get<double>();
    }
    pose.position_mm(row) = values[3].get<double>();
  }
  return pose;
}

// Largest difference of any entry.
inline double rotation_error(const Transform& a, const Transform& b) {
  return (a.rotation - b.rotation).cwiseAbs().maxCoeff();
}
inline double position_error_mm(const Transform& a, const Transform& b) {
  return (a.position_mm - b.position_mm).cwiseAbs().maxCoeff();
}

// Largest difference of any angle, modulo turns.
inline double angle_error(const Theta& a, const Theta& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::fabs(wrapped(a[i] - b[i])));
  return worst;
}

}  // namespace armature::test
