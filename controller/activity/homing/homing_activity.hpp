// Homing on core 1: sends the request to core 0. From then on the joint angles of the axes are not known, see ArmOwner.
#pragma once

#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class HomingActivity final : public Activity {
 public:
  // References must outlive the object.
  HomingActivity(const RobotModel& robot, ArmOwner& owner, MotionMailbox& mailbox) noexcept
      : robot_{robot}, owner_{owner}, mailbox_{mailbox} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Home& home) noexcept;

  // Activity
  void stop(StopKind how) noexcept override;

 private:
  void send(const HomingRequest& request) noexcept;

  const RobotModel& robot_;
  ArmOwner& owner_;
  MotionMailbox& mailbox_;
};

}  // namespace armature
