// A synchronised move of all joints from one joint position to another.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/timebase.hpp"
#include "controller/core/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/synchronise.hpp"
#include "controller/trajectory/trapezoid.hpp"

namespace armature {

struct JointPlan {
  PerAxis<Radians> start{};
  PerAxis<Radians> target{};
  PerAxis<TrapezoidProfile> profiles{};  // rad, rad/s, rad/s^2; relative to `start`
  Ticks duration{};
};

// A longer move is a mistake in its speed: 24 h. Far below what the arithmetic of a plan could hold.
inline constexpr Ticks kLongestMove{std::int64_t{24} * 3600 * kClkFreqHz / kTickCycles.value()};

// `speed` scales the speed limits, (0, 1]; accelerations stay. Each joint moves monotonically, so a plan whose start
// and target are inside the soft limits is inside them all the way. Not to be executed when its duration is above
// kLongestMove.
[[nodiscard]] JointPlan plan_joint_move(const RobotModel& robot, const PerAxis<Radians>& start,
                                        const PerAxis<Radians>& target, double speed, SyncRule rule) noexcept;

// The plan at `t_s` from its start: exactly `start` before, exactly `target` from the end on.
[[nodiscard]] PerAxis<Radians> position(const JointPlan& plan, double t_s) noexcept;

}  // namespace armature
