// A synchronised move of all joints that begins in any state of motion: for a new target in motion, and for moves that
// follow one that does not stop.
//
// From rest, plan_joint_move() is used instead. Its profiles follow the synchronisation rules of Vo 2021 and are
// monotonic; both moves take the same number of ticks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

struct RetargetGoal {
  PerAxis<Radians> target{};
  double speed = 1.0;  // these three as in plan_retarget()
  double accel = 1.0;
  ProfileKind kind = ProfileKind::kTrapezoid;
};

struct RetargetPlan {
  ProfileKind kind = ProfileKind::kTrapezoid;
  PerAxis<Radians> target{};
  PerAxis<PhaseLaw> laws{};                                 // rad; absolute
  PerAxis<double> peak_speed_rad_s{}, peak_accel_rad_s2{};  // the largest of the laws
  Ticks duration{};
  double residual_rad = 0.0;  // as in JointPlan
  Tag tag{};                  // of the command
};

// `start` in rad, rad/s, rad/s^2; finite. Axes that the robot does not have are at rest at their target. `speed` scales
// the speed limits, (0, 1], and `accel` those of acceleration: an axis that is beyond them first returns into them.
// kSCurve: the caller must have checked that max_jerk_rad_s3 > 0 for every joint. kTrapezoid: the accelerations of the
// start have no effect.
//
// The duration is the least number of whole ticks in which every axis can come to rest at its target. A plan with a
// duration above kLongestMove must not be executed.
[[nodiscard]] RetargetPlan plan_retarget(const RobotModel& robot, const PerAxis<AxisState>& start,
                                         const PerAxis<Radians>& target, double speed, ProfileKind kind,
                                         double accel = 1.0) noexcept;

// After a change of the laws.
void set_peaks(RetargetPlan& plan) noexcept;

// The state of motion in the middle of a plan.
[[nodiscard]] PerAxis<AxisState> state_at(const RetargetPlan& plan, double t_s) noexcept;
[[nodiscard]] PerAxis<AxisState> state_at(const JointPlan& plan, double t_s) noexcept;

// The plan at `t_s` from its start: exactly the start before it, exactly `target` from the end on.
[[nodiscard]] PerAxis<Radians> position(const RetargetPlan& plan, double t_s) noexcept;

// The axis that leaves its soft limits farthest on the way, 0..axis_count - 1; none if all stay inside. A joint in
// motion can need more way to stop than the limits leave.
[[nodiscard]] std::optional<std::size_t> axis_outside(const RetargetPlan& plan, const RobotModel& robot) noexcept;

}  // namespace armature
