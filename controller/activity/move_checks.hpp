// Checks of a command before it is planned. Each returns the reason for a refusal, or nothing when the command is
// valid.
#pragma once

#include <optional>

#include "controller/cell/frames.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// An S-curve needs the jerk limit of every axis.
[[nodiscard]] std::optional<MoveRefused> find_profile_refusal(const RobotModel& robot, ProfileKind profile) noexcept;

// Angles [rad] or velocities [rad/s] of the joints must be finite, and 0 for axes that the robot does not have.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const PerAxis<double>& joints) noexcept;

// Targets must be finite and inside the soft limits; those of axes that the robot does not have must be 0. The scales
// of speed and acceleration must be in (0, 1], the blend in its range. Outputs must be given in time, and none with
// `now`. An S-curve needs the jerk limit of every axis. Joint moves are monotonic, so a target inside the limits keeps
// the whole move inside.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const JointMove& move) noexcept;

// The robot's geometry and the frame must be known; position and rotation must form a rigid pose (is_rigid in
// transform.hpp). A side of the wrist may be requested only of six joints, turns only of joints that the robot has.
// Reachability is checked when the move is planned. kConveyorFrame is refused.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                                      const PoseMove& move) noexcept;

// As for PoseMove. In addition all limits of the path must be finite and above 0 (jerk limits only for an S-curve), and
// the blend radius finite and not below 0, and 0 for an exact stop. An axis must be finite, with at most
// kMaxRevolutions around it. A spline needs 1..ThroughPoints::kMax points between its start and its end. A tolerance
// of the orientation must be in its range. Only a steady orientation and a slerp have a rotation of the target, and on
// a spline the tool does not turn with the tangent.
// kConveyorFrame needs six joints. A spline and outputs on the path are refused there.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                                      const CartesianMove& move) noexcept;

// The duration must be above 0, at most 24 h.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const Dwell& dwell) noexcept;

// The pin must be 1..16, the time-out 0 .. 24 h.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const SetOutput& output) noexcept;
[[nodiscard]] std::optional<MoveRefused> find_refusal(const WaitInput& wait) noexcept;

// All velocities must be finite, and 0 for axes that the robot does not have; the duration above 0, at most 24 h; the
// share of the acceleration in (0, 1]. An S-curve of the joints needs the jerk limit of every axis. A velocity of the
// tool needs a known frame, an arm with six joints and limits above 0 (jerk limits only for an S-curve).
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const UserFrames& base_T_user,
                                                      const Jog& jog) noexcept;

// The axes must be those of the robot, and each must have a HomingModel.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const RobotModel& robot, const Home& home) noexcept;

// The share must be 0.01 .. 1.
[[nodiscard]] std::optional<MoveRefused> find_refusal(const SetOverride& wanted) noexcept;

// The refusal that reports a problem found when a path is planned.
[[nodiscard]] MoveRefused refusal_of(const RobotModel& robot, const PathProblem& problem) noexcept;

// The refusal that reports a pose without a solution.
[[nodiscard]] MoveRefused refusal_of(const RobotModel& robot, const IkTracking& unsolved) noexcept;

}  // namespace armature
