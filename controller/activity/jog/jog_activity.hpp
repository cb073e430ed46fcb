// Jogs on core 1. A jog is no plan: its commands go to core 0 at once, the latest of each execute(), and moves wait
// until core 0 reports where the arm stands after the jog.
#pragma once

#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/jog/velocity_input.hpp"
#include "controller/cell/frames.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class JogActivity final : public Activity {
 public:
  // References must outlive the object.
  JogActivity(const RobotModel& robot, const UserFrames& frames, ArmOwner& owner, Channel& channel) noexcept
      : robot_{robot}, frames_{frames}, owner_{owner}, channel_{channel} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Jog& jog) noexcept;
  // Call at the end of each execute().
  void send() noexcept;

  // Activity. A command that was not sent is dropped without a report.
  void on_stop(StopKind) noexcept override { next_.reset(); }
  void drop(Refusal) noexcept override { next_.reset(); }

 private:
  const RobotModel& robot_;
  const UserFrames& frames_;
  ArmOwner& owner_;
  Channel& channel_;
  std::optional<VelocityCommand> next_{};  // to be sent
};

}  // namespace armature
