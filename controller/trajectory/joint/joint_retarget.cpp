#include "controller/trajectory/joint/joint_retarget.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {
namespace {

// What rounding may add to the end of a law, in rad and in parts of its way. The set-points jump by it at the end.
constexpr double kMaxMiss = 1e-13;
// In ticks; a law that takes longer is cut off.
constexpr double kMaxExcess = 1e-6;
// One tick more is enough for what whole_ticks() rounds down. More would be a defect of the laws.
constexpr int kMaxAttempts = 2;

// Returns whether all laws end at the target within the duration.
bool fill(RetargetPlan& plan, const PerAxis<AxisReach>& reach, const PerAxis<TimeLawLimits>& limits) {
  const double duration_s = seconds(plan.duration);
  bool fits = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    PhaseLaw& law = plan.laws[axis];
    const double miss = reach[axis].motion(plan.target[axis].value(), duration_s, law);
    const double way = 3.0 + limits[axis].speed * duration_s;
    fits = fits && miss <= kMaxMiss * way && law.duration_s() <= duration_s + kMaxExcess * kTickSeconds;
  }
  return fits;
}

}  // namespace

RetargetPlan plan_retarget(const RobotModel& robot, const PerAxis<AxisState>& start, const PerAxis<Radians>& target,
                           double speed, ProfileKind kind, double accel) noexcept {
  const auto limits = make_per_axis([&](std::size_t axis) { return axis_limits(robot.axes[axis], speed, accel); });
  const auto reach = make_per_axis([&](std::size_t axis) { return AxisReach{kind, start[axis], limits[axis]}; });
  RetargetPlan plan{.kind = kind, .target = target};
  double longest_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    longest_s = std::max(longest_s, reach[axis].shortest_s(target[axis].value()));
  }
  plan.duration = whole_ticks(longest_s);
  if (plan.duration > kLongestMove) return plan;
  for (int attempt = 0; attempt < kMaxAttempts && !fill(plan, reach, limits); ++attempt) plan.duration += Ticks{1};
  return plan;
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
