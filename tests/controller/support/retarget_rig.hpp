// Joint moves that begin at once and replace the motion, and the limits of a whole run.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

inline const PathLimits kPathLimits{.speed_mm_s = 300,
                                    .accel_mm_s2 = 3'000,
                                    .jerk_mm_s3 = 60'000,
                                    .turn_speed_rad_s = 2,
                                    .turn_accel_rad_s2 = 20,
                                    .turn_jerk_rad_s3 = 1'000};

inline RobotModel robot_to_retarget() {
  RobotModel robot = paper_robot();
  robot.arm = irb120().arm;
  for (AxisModel& axis : robot.axes) {
    axis.max_jerk_rad_s3 = 6'000 * kDeg;
  }
  return robot;
}

inline JointMove now_to(const PerAxis<double>& deg, std::uint32_t tag = 99) {
  return {.target = degrees(deg), .now = true, .tag = tag};
}

// Position, speed and acceleration of every set-point of the run.
inline void expect_limits(const ControllerRig& rig, const std::string& what) {
  for (std::size_t k = 2; k < rig.rows.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto q = [&](std::size_t back) { return rig.rows[k - back].reference[axis].value(); };
      const AxisModel& model = rig.robot.axes[axis];
      const double accel = model.max_accel_rad_s2 * kTickSeconds * kTickSeconds;
      ASSERT_LE(std::fabs(q(0) - q(1)), model.max_speed_rad_s * kTickSeconds * (1 + 1e-5)) << what << " tick " << k;
      ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)), accel * (1 + 1e-5)) << what << " tick " << k << " axis " << axis;
      ASSERT_LE(q(0), model.max_rad + 1e-9) << what;
      ASSERT_GE(q(0), model.min_rad - 1e-9) << what;
    }
  }
}

}  // namespace armature::test
