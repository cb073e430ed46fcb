// The arms of the benchmarks.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "controller/robot/robot_model.hpp"

namespace armature::bench {

inline constexpr double kDeg = std::numbers::pi / 180.0;

// ABB IRB 120: six axes.
inline RobotModel irb_120() {
  constexpr std::array<double, 6> lowest_deg{-165, -110, -110, -160, -120, -400};
  constexpr std::array<double, 6> highest_deg{165, 110, 70, 160, 120, 400};
  constexpr std::array<double, 6> speed_deg_s{250, 250, 250, 320, 320, 420};
  RobotModel robot;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    robot.axes[axis].gear_ratio = 50.0;
    robot.axes[axis].pulses_per_rev = robot.axes[axis].counts_per_rev = 10'000;
    robot.axes[axis].min_rad = lowest_deg[axis] * kDeg;
    robot.axes[axis].max_rad = highest_deg[axis] * kDeg;
    robot.axes[axis].max_speed_rad_s = speed_deg_s[axis] * kDeg;
  }
  robot.arm.family = ArmFamily::kSixR;
  robot.arm.a2_mm = 270.0;
  robot.arm.a3_mm = 70.0;
  robot.arm.d1_mm = 290.0;
  robot.arm.d4_mm = 302.0;
  robot.arm.d6_mm = 72.0;
  robot.arm.sign = {1, -1, -1, 1, -1, 1};
  robot.arm.offset_rad = {0, 90 * kDeg, 0, 0, 0, 180 * kDeg};
  return robot;
}

// Hu 2012 Table 1: five axes; the table's lengths as mm.
inline ArmGeometry hu_2012() {
  ArmGeometry arm;
  arm.family = ArmFamily::kFiveR;
  arm.a1_mm = 1.1;
  arm.a2_mm = 10.0;
  arm.a3_mm = 9.5;
  arm.a4_mm = 3.2;
  arm.d5_mm = 14.5;
  return arm;
}

}  // namespace armature::bench
