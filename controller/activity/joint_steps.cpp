#include "controller/activity/joint_steps.hpp"

#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"

namespace armature {

PerAxis<double> speed_limits_rad_s(const RobotModel& robot) noexcept {
  PerAxis<double> limits{};
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    limits[axis] = AxisUnits{robot.axes[axis]}.max_speed_rad_s();
  }
  return limits;
}

std::uint8_t axis_beyond_limits(const RobotModel& robot, const PerAxis<double>& max_speed_rad_s,
                                const JointSteps& steps, double share) noexcept {
  for (std::uint8_t axis = 0; axis < robot.axis_count; ++axis) {
    const AxisModel& model = robot.axes[axis];
    const auto number = static_cast<std::uint8_t>(axis + 1);
    const double step = (steps.next[axis] - steps.position[axis]).value();
    const double last = (steps.position[axis] - steps.previous[axis]).value();
    const double accel = model.max_accel_rad_s2 * kTickSeconds * kTickSeconds;
    if (!(std::fabs(step) <= max_speed_rad_s[axis] * kTickSeconds * (1.0 + kLimitRounding) * share)) return number;
    if (!(std::fabs(step - last) <= accel * (1.0 + kLimitRounding) * share)) return number;
    // The last step to a limit can be smaller than `accel`.
    const double stop = steps.next[axis].value() + step * (0.5 * std::fabs(step) / accel + 0.5);
    if (step > 0.0 && stop > model.max_rad + accel) return number;
    if (step < 0.0 && stop < model.min_rad - accel) return number;
  }
  return 0;
}

}  // namespace armature
