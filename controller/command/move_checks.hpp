// What can be told of a command before it is planned: why it cannot be done, nothing when nothing speaks against it.
#pragma once

#include <optional>

#include "controller/command/command.hpp"
#include "controller/command/frames.hpp"
#include "controller/event/move_refused.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// Targets must be finite and inside the soft limits, those of axes that the robot has not must be 0, the speed in (0,
// 1]; an S-curve needs the jerk limit of every axis. Joint moves are monotonic, so a target inside the limits keeps the
// whole move inside.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const JointMove& move) noexcept;

// The robot's geometry must be known, and the frame; position and rotation a pose at all
// (is_rigid in transform.hpp). Whether it can be reached shows when the move is planned.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                                      const PoseMove& move) noexcept;

// The same, and all limits of the path finite and above 0 (jerk limits only for an S-curve), the blend radius finite
// and not below 0.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                                      const CartesianMove& move) noexcept;

// The pin must be 1..16, the time-out 0 .. 24 h.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const SetOutput& output) noexcept;
[[nodiscard]] std::optional<MoveRefused> find_refusal(const WaitInput& wait) noexcept;

// The share must be 0.01 .. 1.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const SetOverride& wanted) noexcept;

// The reason to report for what the planning of a path has found.
[[nodiscard]] MoveRefused refusal_of(const PathProblem& problem) noexcept;

// The same for a pose that has no solution.
[[nodiscard]] MoveRefused refusal_of(const IkSolutions& unsolved) noexcept;

}  // namespace armature
