// How much of the limits of jerk a plan needs, and when: a change of its rate may use what is left
// (run/rate_change.hpp).
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

// The largest jerk of any joint, and of the tool where its jerk is limited, as a share of its limit, between two times
// in ticks from the start of the plan. At least 0; 0 where no jerk is limited.
[[nodiscard]] double jerk_share(const JointPlan& plan, const RobotModel& robot, double from, double to) noexcept;
[[nodiscard]] double jerk_share(const RetargetPlan& plan, const RobotModel& robot, double from, double to) noexcept;
// From the segments' jerk_use.
[[nodiscard]] double jerk_share(const CartesianPlan& plan, double from, double to) noexcept;

// Whether changes of the rate must limit the jerk: a joint moves in an S-curve.
[[nodiscard]] bool limits_jerk(const JointPlan& plan) noexcept;

// The run at this path time; at an exact stop the one that begins.
[[nodiscard]] PlanRun run_at(const CartesianPlan& plan, double ticks) noexcept;

// Sets CartesianSegment::jerk_use to none. A segment that is already in the plan before keeps at least what it has
// there.
void clear_jerk_use(CartesianPlan& plan) noexcept;
// Adds the largest jerk between two times in ticks, as a share of its limit.
void add_jerk_use(CartesianPlan& plan, double from, double to, double share) noexcept;

}  // namespace armature
