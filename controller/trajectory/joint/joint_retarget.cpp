#include "controller/trajectory/joint/joint_retarget.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"

namespace armature {
void set_peaks(RetargetPlan& plan) noexcept {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    plan.peak_speed_rad_s[axis] = plan.laws[axis].peak_speed();
    plan.peak_accel_rad_s2[axis] = plan.laws[axis].peak_accel();
  }
}

PerAxis<AxisState> state_at(const RetargetPlan& plan, double t_s) noexcept {
  return make_per_axis([&](std::size_t axis) { return plan.laws[axis].at(t_s); });
}

PerAxis<AxisState> state_at(const JointPlan& plan, double t_s) noexcept {
  const PerAxis<Radians> joints = position(plan, t_s);
  return make_per_axis([&](std::size_t axis) {
    const TimeLaw& law = plan.profiles[axis];
    return AxisState{joints[axis].value(), velocity(law, t_s), acceleration(law, t_s)};
  });
}

PerAxis<Radians> position(const RetargetPlan& plan, double t_s) noexcept {
  // The last set-point is exact, even if a law takes a rounding error longer.
  if (t_s >= seconds(plan.duration)) return plan.target;
  return make_per_axis([&](std::size_t axis) { return Radians{plan.laws[axis].at(t_s).position}; });
}

std::optional<std::size_t> axis_outside(const RetargetPlan& plan, const RobotModel& robot) noexcept {
  std::optional<std::size_t> worst;
  // Rounding at a limit is no excess.
  double most_rad = 1e-9;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const PhaseLaw::Extent extent = plan.laws[axis].extent();
    const AxisModel& model = robot.axes[axis];
    const double excess_rad = std::max(model.min_rad - extent.least, extent.largest - model.max_rad);
    if (excess_rad <= most_rad) continue;
    most_rad = excess_rad;
    worst = axis;
  }
  return worst;
}

}  // namespace armature
