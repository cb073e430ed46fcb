#include "controller/trajectory/joint_move.hpp"

#include "controller/core/timebase.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature {

JointPlan plan_joint_move(const RobotModel& robot, const PerAxis<Radians>& start, const PerAxis<Radians>& target,
                          double speed, SyncRule rule) noexcept {
  PerAxis<double> distance_rad;
  PerAxis<ProfileLimits> limits;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& model = robot.axes[axis];
    distance_rad[axis] = (target[axis] - start[axis]).value();
    limits[axis] = {.speed = speed * AxisUnits{model}.max_speed_rad_s(), .accel = model.max_accel_rad_s2};
  }
  const SynchronisedProfiles synchronised = synchronise(distance_rad, limits, rule);
  return {.start = start, .target = target, .profiles = synchronised.axes, .duration = synchronised.duration};
}

PerAxis<Radians> position(const JointPlan& plan, double t_s) noexcept {
  // start + distance can miss the target by a rounding.
  if (t_s >= static_cast<double>(plan.duration.value()) * kTickSeconds) return plan.target;
  PerAxis<Radians> joints;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    joints[axis] = plan.start[axis] + Radians{position(plan.profiles[axis], t_s)};
  }
  return joints;
}

}  // namespace armature
