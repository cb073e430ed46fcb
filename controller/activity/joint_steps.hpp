// The limits of the joints from set-point to set-point.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// The speed limit of each axis, rad/s; 0 for axes that the robot does not have.
[[nodiscard]] PerAxis<double> speed_limits_rad_s(const RobotModel& robot) noexcept;

// Three set-points in a row.
struct JointSteps {
  const PerAxis<Radians>& previous;
  const PerAxis<Radians>& position;
  const PerAxis<Radians>& next;
};

// The first axis whose step to `next` exceeds a share of its limits of speed or acceleration, or after which it cannot
// stop before its soft limit; 1..6. 0: there is none. A value that is no number exceeds its limit.
[[nodiscard]] std::uint8_t axis_beyond_limits(const RobotModel& robot, const PerAxis<double>& max_speed_rad_s,
                                              const JointSteps& steps, double share = 1.0) noexcept;

}  // namespace armature
