// Robots for tests.
#pragma once

#include <numbers>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::test {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDeg = kPi / 180.0;

// The arm of Figure 9 of Vo 2021: 120 deg/s, 600 deg/s^2 (axis 6: 660), 50:1, a pulse is a count is 7.2e-4 deg; drives
// of 40 Hz.
inline RobotModel paper_robot() {
  RobotModel robot;
  robot.axes.fill({.gear_ratio = 50.0,
                   .pulses_per_rev = 10'000,
                   .counts_per_rev = 10'000,
                   .min_rad = -170.0 * kDeg,
                   .max_rad = 170.0 * kDeg,
                   .max_speed_rad_s = 120.0 * kDeg,
                   .max_accel_rad_s2 = 600.0 * kDeg,
                   .following_error_limit_rad = 5.0 * kDeg,
                   .drive_natural_rad_s = 2.0 * std::numbers::pi * 40.0,
                   .drive_damping = 1.0});
  robot.axes[5].max_accel_rad_s2 = 660.0 * kDeg;
  return robot;
}

// 131072 pulses and counts per revolution, 219.7 deg/s: 200 pulses a tick.
inline RobotModel fine_robot() {
  RobotModel robot = paper_robot();
  for (AxisModel& axis : robot.axes) {
    axis.pulses_per_rev = axis.counts_per_rev = 131'072;
    axis.max_speed_rad_s = 219.7265625 * kDeg;
    axis.max_accel_rad_s2 = 2'000.0 * kDeg;
    axis.following_error_limit_rad = 10.0 * kDeg;
  }
  return robot;
}

inline PerAxis<Radians> degrees(const PerAxis<double>& deg) {
  return make_per_axis([&](std::size_t axis) { return Radians{deg[axis] * kDeg}; });
}

inline const PerAxis<double> kFigure9Deg{80.4, -60.0, 50.0, 17.4, -17.4, 70.0};

}  // namespace armature::test
