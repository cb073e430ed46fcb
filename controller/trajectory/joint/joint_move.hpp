// A synchronised move of all joints from one joint position to another: all start and stop together.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/path/timed_outputs.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

struct JointPlan {
  PerAxis<Radians> start{};
  PerAxis<Radians> target{};
  PerAxis<TimeLaw> profiles{};  // rad, rad/s, rad/s^2; relative to `start`, each takes exactly `duration`
  Ticks duration{};
  bool is_dwell = false;      // it stands still at `start` for `duration`
  double residual_rad = 0.0;  // of the pose for which the joints were computed, see IkSolutions; 0 without one
  TimedOutputs outputs{};
  Tag tag{};  // of the command
};

// 24 h: a longer move is an error in its speed. The arithmetic of a plan allows far more.
inline constexpr Ticks kLongestMove{std::int64_t{24} * 3600 * kClkFreqHz / kTickCycles.value()};

// `speed` scales the speed limits, (0, 1], and `accel` those of acceleration; jerks stay. Each joint moves
// monotonically, so a plan whose start and target are inside the soft limits stays inside. A plan with a duration above
// kLongestMove must not be executed.
//
// kTrapezoid: slowed down to the common duration by `rule`, see synchronise.hpp.
// kSCurve: every joint's fastest S-curve is slowed down as a whole to the duration of the slowest joint, rounded up by
// whole_ticks(). `rule` has no effect, because the rules are for trapezoids. The caller must have checked that
// max_jerk_rad_s3 > 0 for every joint that moves.
//
// A joint that does not move has an empty profile for any limits: those of axes beyond axis_count are 0.
[[nodiscard]] JointPlan plan_joint_move(const RobotModel& robot, const PerAxis<Radians>& start,
                                        const PerAxis<Radians>& target, double speed, SyncRule rule,
                                        ProfileKind kind = ProfileKind::kTrapezoid, double accel = 1.0) noexcept;

// The plan at `t_s` from its start: exactly `start` before it, exactly `target` from the end on.
[[nodiscard]] PerAxis<Radians> position(const JointPlan& plan, double t_s) noexcept;

}  // namespace armature
