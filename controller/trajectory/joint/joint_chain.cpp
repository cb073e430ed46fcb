#include "controller/trajectory/joint/joint_chain.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/corner_search.hpp"

namespace armature {
namespace {

const RetargetPlan& move_at(const JointChain& chain, double& t_s) {
  std::size_t move = chain.count - 1;
  while (move > 0 && t_s < seconds(chain.starts[move])) --move;
  t_s -= seconds(chain.starts[move]);
  return chain.moves[move];
}

}  // namespace

double largest_difference(const PerAxis<Radians>& a, const PerAxis<Radians>& b) noexcept {
  double most_rad = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    most_rad = std::max(most_rad, std::fabs((a[axis] - b[axis]).value()));
  return most_rad;
}

// At its end the plan is at rest, although its laws may end a rounding error later.
PerAxis<AxisState> state_at_tick(const RetargetPlan& plan, std::int64_t tick) noexcept {
  if (tick < plan.duration.value()) return state_at(plan, seconds(Ticks{tick}));
  return make_per_axis([&](std::size_t axis) { return AxisState{.position = plan.target[axis].value()}; });
}

ClosestSetPoint closest_to(const PerAxis<Radians>& via, const RetargetPlan& plan) noexcept {
  return closest_set_point(plan, [&](const PerAxis<Radians>& joints) { return largest_difference(joints, via); });
}

std::int64_t earliest_start(const JointChain& chain) noexcept {
  return std::max((chain.moves[chain.count - 1].duration.value() + 1) / 2, chain.passed.value());
}

JointChain& JointChain::operator=(const JointChain& other) noexcept {
  count = other.count;
  for (std::size_t move = 0; move < count; ++move) {
    moves[move] = other.moves[move];
    starts[move] = other.starts[move];
  }
  target = other.target;
  duration = other.duration;
  passed = other.passed;
  outputs = other.outputs;
  return *this;
}

JointChain& JointChain::operator=(const RetargetPlan& only) noexcept {
  moves[0] = only;
  starts[0] = passed = Ticks{};
  count = 1;
  target = only.target;
  duration = only.duration;
  outputs.clear();
  return *this;
}

int append(JointChain& chain, const RobotModel& robot, const JointRequest& next, double blend_rad) noexcept {
  const RetargetPlan& last = chain.moves[chain.count - 1];
  RetargetPlan& added = chain.moves[chain.count];
  int trials = 0;
  ClosestSetPoint closest;
  // Whether the next move can begin there.
  const auto fits = [&](std::int64_t start) {
    ++trials;
    added = plan_retarget(robot, state_at_tick(last, start), next.target, next.speed, next.kind, next.accel);
    if (added.duration > kLongestMove || axis_outside(added, robot)) return false;
    closest = closest_to(last.target, added);
    return closest.distance <= blend_rad;
  };
  // At the end it fits: the joints stop exactly.
  EarliestFit start{blend_rad > 0.0 ? earliest_start(chain) : last.duration.value(), last.duration.value()};
  while (!start.done()) start.set(fits(start.trial()));
  if (!start.was_last_trial()) (void)fits(start.tick());
  if (added.duration > kLongestMove) return 0;
  chain.starts[chain.count] = chain.starts[chain.count - 1] + Ticks{start.tick()};
  chain.passed = Ticks{closest.tick};
  chain.target = next.target;
  chain.duration = chain.starts[chain.count] + added.duration;
  ++chain.count;
  return trials;
}

PerAxis<AxisState> state_at(const JointChain& chain, double t_s) noexcept {
  const RetargetPlan& move = move_at(chain, t_s);
  return state_at(move, t_s);
}

PerAxis<Radians> position(const JointChain& chain, double t_s) noexcept {
  const RetargetPlan& move = move_at(chain, t_s);
  return position(move, t_s);
}

}  // namespace armature
