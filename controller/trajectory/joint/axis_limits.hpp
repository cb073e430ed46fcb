// The limits of the time laws of an axis, from its model.
#pragma once

#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// Rounding may make the set-points of a motion that just reaches a limit exceed it by this share.
inline constexpr double kLimitRounding = 1e-6;

// In rad/s, rad/s^2 and rad/s^3. `speed` and `accel` are shares of the limits of the axis, in (0, 1]. The jerk is 0 for
// an axis without a jerk limit.
[[nodiscard]] inline TimeLawLimits axis_limits(const AxisModel& model, double speed = 1.0,
                                               double accel = 1.0) noexcept {
  return {.speed = speed * AxisUnits{model}.max_speed_rad_s(),
          .accel = accel * model.max_accel_rad_s2,
          .jerk = model.max_jerk_rad_s3};
}

}  // namespace armature
