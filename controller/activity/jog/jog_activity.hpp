// Jogs on core 1. A jog is no plan: its commands go to core 0 at once, the latest of each execute(), and moves wait
// until core 0 reports where the arm stands after the jog.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/cell/frames.hpp"
#include "controller/message/command.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/velocity_input.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class JogActivity final : public Activity {
 public:
  // References must outlive the object.
  JogActivity(const RobotModel& robot, const UserFrames& frames, ArmOwner& owner, MotionMailbox& mailbox) noexcept
      : robot_{robot}, frames_{frames}, owner_{owner}, mailbox_{mailbox} {}

  [[nodiscard]] std::optional<MoveRefused> accept(const Jog& jog) noexcept;
  // Call at the end of each execute().
  void send() noexcept;

  // Activity
  void stop(StopKind how) noexcept override;
  void on_rest() noexcept override;
  [[nodiscard]] bool answered_by(const MotionNotice& notice) const noexcept override {
    return notice.jogs == sent_ && !next_;
  }

 private:
  const RobotModel& robot_;
  const UserFrames& frames_;
  ArmOwner& owner_;
  MotionMailbox& mailbox_;
  std::optional<VelocityCommand> next_{};         // to be sent
  std::uint32_t sent_ = 0;                        // commands; wraps like MotionNotice::jogs
  std::optional<VelocityCommand::Kind> ended_{};  // what has ended a jog that still brakes
};

}  // namespace armature
