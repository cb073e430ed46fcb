// The joints along a finished Cartesian plan, at any of its times and in any order.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class PathCursor {
 public:
  // References must outlive the cursor. It begins at the start of the plan, or at its end.
  enum class Place : std::uint8_t { kStart, kEnd };
  PathCursor(const RobotModel& robot, const Arm& arm, const CartesianPlan& plan, Place place) noexcept;

  // The joints at a time of the plan, ticks. Follows the path from the time of the last call, at most kStrideTicks with
  // each call of position().
  [[nodiscard]] const JointAngles& joints_at(double ticks) noexcept;

  // Follows the path towards a time. Returns false when it has computed so many inverse kinematics, or up to
  // FollowedTool::kMaxInverses more, and is still farther than a stride from it.
  [[nodiscard]] bool approach(double ticks, std::int64_t inverses) noexcept;

  // The state of motion at a tick that is at least kAround from both ends: the position is that of the set-point, speed
  // and acceleration are those of the polynomial through five set-points. At an end of the plan the arm rests.
  static constexpr std::int64_t kAround = 2;
  [[nodiscard]] PerAxis<AxisState> state_at(std::int64_t tick) noexcept;

  [[nodiscard]] const CartesianPlan& plan() const noexcept { return plan_; }
  // Inverse kinematics computed so far.
  [[nodiscard]] std::int64_t inverses() const noexcept { return inverses_; }

 private:
  static constexpr double kStrideTicks = 64.0;  // 3 ms

  void move_towards(double ticks) noexcept;

  const RobotModel& robot_;
  const Arm& arm_;
  const CartesianPlan& plan_;
  double ticks_;
  JointAngles joints_;
  std::int64_t inverses_ = 0;
};

}  // namespace armature
