#include "controller/trajectory/joint/joint_passage.hpp"

#include <algorithm>
#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"
#include "controller/trajectory/state/axis_passage.hpp"

namespace armature {

RetargetPlan plan_passage(const RobotModel& robot, const PerAxis<AxisState>& start, const PerAxis<AxisState>& end,
                          double speed, ProfileKind kind, double accel) noexcept {
  const auto passage = make_per_axis([&](std::size_t axis) {
    return AxisPassage{kind, start[axis], end[axis], axis_limits(robot.axes[axis], speed, accel)};
  });
  RetargetPlan plan{.kind = kind};
  for (std::size_t axis = 0; axis < kAxes; ++axis) plan.target[axis] = Radians{end[axis].position};
  PerAxis<PhaseLaw> laws;
  std::size_t hardest = 0;  // the axis that had no motion in the latest trial that failed
  const auto fits = [&](std::int64_t ticks) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      const std::size_t axis = (hardest + i) % kAxes;
      if (passage[axis].motion(seconds(Ticks{ticks}), laws[axis])) continue;
      hardest = axis;
      return false;
    }
    plan.laws = laws;
    plan.duration = Ticks{ticks};
    return true;
  };
  double longest_s = 0.0;
  for (const AxisPassage& axis : passage) longest_s = std::max(longest_s, axis.shortest_s());
  std::int64_t does_not = whole_ticks(longest_s).value() - 1, does = does_not + 1;
  for (std::int64_t stride = 1; does <= kLongestMove.value() && !fits(does); stride *= 2) {
    does_not = does;
    does += stride;
  }
  plan.duration = Ticks{does};
  while (does <= kLongestMove.value() && does - does_not > 1) {
    const std::int64_t middle = does_not + (does - does_not) / 2;
    (fits(middle) ? does : does_not) = middle;
  }
  set_peaks(plan);
  return plan;
}

}  // namespace armature
