#include "controller/trajectory/cartesian/path_cursor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "controller/base/timebase.hpp"

namespace armature {

PathCursor::PathCursor(const RobotModel& robot, const Arm& arm, const CartesianPlan& plan, Place place) noexcept
    : robot_{robot},
      arm_{arm},
      plan_{plan},
      ticks_{place == Place::kStart ? 0.0 : static_cast<double>(plan.duration.value())},
      joints_{place == Place::kStart ? plan.start : plan.target} {}

void PathCursor::move_towards(double ticks) noexcept {
  ticks_ = std::clamp(ticks, ticks_ - kStrideTicks, ticks_ + kStrideTicks);
  int inverses = 0;
  joints_ = position(plan_, arm_, ticks_ * kTickSeconds, joints_, inverses);
  inverses_ += inverses;
}

const JointAngles& PathCursor::joints_at(double ticks) noexcept {
  while (ticks_ != ticks) move_towards(ticks);
  return joints_;
}

bool PathCursor::approach(double ticks, std::int64_t inverses) noexcept {
  const std::int64_t end = inverses_ + inverses;
  const auto is_near = [&] { return std::fabs(ticks - ticks_) <= kStrideTicks; };
  while (!is_near() && inverses_ < end) move_towards(ticks);
  return is_near();
}

PerAxis<AxisState> PathCursor::state_at(std::int64_t tick) noexcept {
  std::array<JointAngles, 2 * kAround + 1> q;
  if (tick <= 0 || tick >= plan_.duration.value()) {
    q.fill(joints_at(static_cast<double>(tick)));
  } else {
    std::int64_t at = tick - kAround;
    for (JointAngles& joints : q) joints = joints_at(static_cast<double>(at++));
  }
  return make_per_axis([&](std::size_t axis) {
    // From the middle, for less rounding.
    const auto way = [&](std::size_t point) { return (q[point][axis] - q[kAround][axis]).value(); };
    AxisState state{.position = q[kAround][axis].value()};
    if (axis >= robot_.axis_count) return state;
    state.velocity = (8.0 * (way(3) - way(1)) - (way(4) - way(0))) / (12.0 * kTickSeconds);
    state.accel = (16.0 * (way(3) + way(1)) - (way(4) + way(0))) / (12.0 * kTickSeconds * kTickSeconds);
    return state;
  });
}

}  // namespace armature
