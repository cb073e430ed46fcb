#include "controller/trajectory/joint/retarget_planner.hpp"

#include <algorithm>

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

}  // namespace

void RetargetPlanner::begin(const PerAxis<AxisState>& start, const RetargetGoal& goal) noexcept {
  start_ = start;
  goal_ = goal;
  part_ = 0;
}

void RetargetPlanner::step() noexcept {
  switch (part_++) {
    case 0:
      find_duration();
      break;
    case 1:
      find_laws();
      break;
    default:
      if (plan_.duration > kLongestMove) break;
      set_peaks(plan_);
      outside_ = axis_outside(plan_, robot_);
  }
}

void RetargetPlanner::find_duration() noexcept {
  limits_ = make_per_axis([&](std::size_t axis) { return axis_limits(robot_.axes[axis], goal_.speed, goal_.accel); });
  reach_.emplace(make_per_axis([&](std::size_t axis) { return AxisReach{goal_.kind, start_[axis], limits_[axis]}; }));
  outside_.reset();
  plan_.kind = goal_.kind;
  plan_.target = goal_.target;
  double longest_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    longest_s = std::max(longest_s, (*reach_)[axis].shortest_s(goal_.target[axis].value()));
  }
  plan_.duration = whole_ticks(longest_s);
}

void RetargetPlanner::find_laws() noexcept {
  if (plan_.duration > kLongestMove) return;
  for (int attempt = 0; attempt < kMaxAttempts && !fill(); ++attempt) plan_.duration += Ticks{1};
}

// Returns whether all laws end at the target within the duration.
bool RetargetPlanner::fill() noexcept {
  const double duration_s = seconds(plan_.duration);
  bool fits = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    PhaseLaw& law = plan_.laws[axis];
    const double miss = (*reach_)[axis].motion(goal_.target[axis].value(), duration_s, law);
    const double way = 3.0 + limits_[axis].speed * duration_s;
    fits = fits && miss <= kMaxMiss * way && law.duration_s() <= duration_s + kMaxExcess * kTickSeconds;
  }
  return fits;
}

RetargetPlan plan_retarget(const RobotModel& robot, const PerAxis<AxisState>& start, const PerAxis<Radians>& target,
                           double speed, ProfileKind kind, double accel) noexcept {
  RetargetPlanner planner{robot};
  planner.begin(start, {.target = target, .speed = speed, .accel = accel, .kind = kind});
  planner.step();
  planner.step();
  RetargetPlan plan = planner.plan();
  set_peaks(plan);
  return plan;
}

}  // namespace armature
