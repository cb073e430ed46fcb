#include "controller/trajectory/joint/joint_move.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"

namespace armature {

namespace {

// Slows every joint's fastest S-curve down to the duration of the slowest, in whole ticks.
void synchronise_scurves(const PerAxis<double>& distance_rad, const PerAxis<TimeLawLimits>& limits, JointPlan& plan) {
  double longest_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    plan.profiles[axis] = plan_time_law(ProfileKind::kSCurve, distance_rad[axis], limits[axis]);
    longest_s = std::max(longest_s, plan.profiles[axis].duration_s());
  }
  plan.duration = whole_ticks(longest_s);
  const double duration_s = seconds(plan.duration);
  for (TimeLaw& law : plan.profiles) law = scale_in_time(law, duration_s);
}

void synchronise_trapezoids(const PerAxis<double>& distance_rad, const PerAxis<TimeLawLimits>& limits, SyncRule rule,
                            JointPlan& plan) {
  const auto trapezoid_limits = make_per_axis(
      [&](std::size_t axis) { return ProfileLimits{.speed = limits[axis].speed, .accel = limits[axis].accel}; });
  const SynchronisedProfiles synchronised = synchronise(distance_rad, trapezoid_limits, rule);
  plan.duration = synchronised.duration;
  for (std::size_t axis = 0; axis < kAxes; ++axis) plan.profiles[axis].trapezoid = synchronised.axes[axis];
}

}  // namespace

JointPlan plan_joint_move(const RobotModel& robot, const PerAxis<Radians>& start, const PerAxis<Radians>& target,
                          double speed, SyncRule rule, ProfileKind kind, double accel) noexcept {
  PerAxis<double> distance_rad;
  PerAxis<TimeLawLimits> limits;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    distance_rad[axis] = (target[axis] - start[axis]).value();
    limits[axis] = axis_limits(robot.axes[axis], speed, accel);
  }
  JointPlan plan{.start = start, .target = target};
  if (kind == ProfileKind::kSCurve) {
    synchronise_scurves(distance_rad, limits, plan);
  } else {
    synchronise_trapezoids(distance_rad, limits, rule, plan);
  }
  return plan;
}

PerAxis<Radians> position(const JointPlan& plan, double t_s) noexcept {
  // start + distance can differ from the target by rounding.
  if (t_s >= seconds(plan.duration)) return plan.target;
  PerAxis<Radians> joints;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const TimeLaw& law = plan.profiles[axis];
    const double way = law.kind == ProfileKind::kSCurve ? position(law.scurve, t_s) : position(law.trapezoid, t_s);
    joints[axis] = plan.start[axis] + Radians{way};
  }
  return joints;
}

}  // namespace armature
