// How fast the rate of a joint move that begins in motion, or of a chain of them, may change where jerk is limited
// (path_clock.hpp): w, the largest second difference of the rate, in 1/tick^2.
#pragma once

#include <limits>

#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

// Jerk is not limited.
inline constexpr double kAnyBend = std::numeric_limits<double>::infinity();

// The largest w for a quantity whose speed in the plan is at most `speed`, its acceleration at most min(accel,
// sqrt(jerk speed)) and its jerk at most `jerk`, all of them per s^n. With r the rate and u = dr/dt a motion q(t) has
// the jerk
//
//   jerk = q_ppp r^3 + 3 q_pp r u + q_p du/dt,   q_p, q_pp, q_ppp: the plan's speed, acceleration, jerk
//
// Rates are within 0..1 and change between constant values, so u^2 <= 2 w (1 - r). With w = 0.4 min(J / V, (J / A)^2)
// the sum is at most 2 J, at r = 0.88. A quantity at rest allows any w. w is never below kMinBend, with which a hold
// takes an hour: a smaller change of a rate of 1 could not be represented by a double.
inline constexpr double kMinBend = 1e-15;
[[nodiscard]] double rate_bend(double speed, double jerk, double accel) noexcept;

// Every axis keeps twice the robot's jerk.
[[nodiscard]] double rate_bend(const RetargetPlan& plan, const RobotModel& robot) noexcept;
// The least of all moves of its chains and paths. For paths from their limits and those of the axes, so that a hold
// takes longer than on a path alone.
[[nodiscard]] double rate_bend(const Plan& plan, const RobotModel& robot) noexcept;

}  // namespace armature
