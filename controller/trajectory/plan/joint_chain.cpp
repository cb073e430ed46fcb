#include "controller/trajectory/plan/joint_chain.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// Set-points that are compared with the point between two moves: so many over the whole move, then so many between the
// two neighbours of the closest one, and so on. A closer one may be missed: the corner is then rounded less.
constexpr std::int64_t kCompared = 64;

struct Closest {
  double rad = 0.0;
  std::int64_t tick = 0;
};

Closest closest_to(const PerAxis<Radians>& via, const RetargetPlan& plan) {
  std::int64_t first = 0, last = plan.duration.value();
  Closest closest{largest_difference(position(plan, 0.0), via), 0};
  while (true) {
    const std::int64_t stride = (last - first) / kCompared + 1;
    for (std::int64_t tick = first; tick <= last; tick += stride) {
      const double rad = largest_difference(position(plan, seconds(Ticks{tick})), via);
      if (rad < closest.rad) closest = {rad, tick};
    }
    if (stride == 1) return closest;
    first = std::max<std::int64_t>(closest.tick - stride, 0);
    last = std::min(closest.tick + stride, plan.duration.value());
  }
}

// At its end the plan is at rest, although its laws may end a rounding error later.
PerAxis<AxisState> state_at_tick(const RetargetPlan& plan, std::int64_t tick) {
  if (tick < plan.duration.value()) return state_at(plan, seconds(Ticks{tick}));
  return make_per_axis([&](std::size_t axis) { return AxisState{.position = plan.target[axis].value()}; });
}

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
  Closest closest;
  // Whether the next move can begin there.
  const auto fits = [&](std::int64_t start) {
    ++trials;
    added = plan_retarget(robot, state_at_tick(last, start), next.target, next.speed, next.kind, next.accel);
    if (added.duration > kLongestMove || axis_outside(added, robot)) return false;
    closest = closest_to(last.target, added);
    return closest.rad <= blend_rad;
  };
  std::int64_t late = last.duration.value();  // fits: the joints stop exactly
  std::int64_t early = std::max((last.duration.value() + 1) / 2, chain.passed.value());
  bool planned = blend_rad > 0.0 && early < late && fits(early);
  if (planned) {
    late = early;
  } else if (blend_rad > 0.0) {
    while (late - early > 1) {
      const std::int64_t middle = early + (late - early) / 2;
      planned = fits(middle);
      (planned ? late : early) = middle;
    }
  }
  if (!planned) (void)fits(late);
  if (added.duration > kLongestMove) return 0;
  chain.starts[chain.count] = chain.starts[chain.count - 1] + Ticks{late};
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
