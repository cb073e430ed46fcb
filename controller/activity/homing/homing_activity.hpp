// Homing on core 1: sends the request to core 0. From then on the joint angles of the axes are not known, see ArmOwner.
#pragma once

#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class HomingActivity final : public Activity {
 public:
  // References must outlive the object.
  HomingActivity(const RobotModel& robot, ArmOwner& owner) noexcept : robot_{robot}, owner_{owner} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Home& home) noexcept;

 private:
  const RobotModel& robot_;
  ArmOwner& owner_;
};

}  // namespace armature
