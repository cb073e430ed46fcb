// A synchronised move of all joints from one joint position to another: all start and stop together.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/tag.hpp"
#include "controller/core/timebase.hpp"
#include "controller/core/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

struct JointPlan {
  PerAxis<Radians> start{};
  PerAxis<Radians> target{};
  PerAxis<TimeLaw> profiles{};  // rad, rad/s, rad/s^2; relative to `start`, each takes exactly `duration`
  Ticks duration{};
  double residual_rad = 0.0;  // of the pose that the joints were found for, see IkSolutions; 0 without one
  Tag tag{};                  // of the command
};

// A longer move is a mistake in its speed: 24 h. Far below what the arithmetic of a plan could hold.
inline constexpr Ticks kLongestMove{std::int64_t{24} * 3600 * kClkFreqHz / kTickCycles.value()};

// `speed` scales the speed limits, (0, 1]; accelerations and jerks stay. Each joint moves monotonically, so a plan
// whose start and target are inside the soft limits is inside them all the way. Not to be executed when its duration is
// above kLongestMove.
//
// kTrapezoid: slowed down to the common duration by `rule`, see synchronise.hpp.
// kSCurve: every joint's own fastest S-curve is slowed down as a whole to the duration of the slowest joint, rounded up
// by whole_ticks(). `rule` has no say: the rules shape trapezoids. Needs max_jerk_rad_s3 > 0 of every joint that moves;
// the caller has checked.
//
// A joint that does not move has an empty profile, whatever its limits: those of axes beyond axis_count are 0.
[[nodiscard]] JointPlan plan_joint_move(const RobotModel& robot, const PerAxis<Radians>& start,
                                        const PerAxis<Radians>& target, double speed, SyncRule rule,
                                        ProfileKind kind = ProfileKind::kTrapezoid) noexcept;

// The plan at `t_s` from its start: exactly `start` before, exactly `target` from the end on.
[[nodiscard]] PerAxis<Radians> position(const JointPlan& plan, double t_s) noexcept;

}  // namespace armature
