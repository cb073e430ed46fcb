// A dispatcher without core 0: the test reads what it sends, and answers.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "controller/command/dispatcher.hpp"
#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/fake_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

class DispatcherBench {
 public:
  // Core 0 reports that the arm stands, with so many jog commands accepted.
  void at_rest(std::uint32_t jogs) {
    EXPECT_TRUE(mailbox->notices.try_push({.kind = MotionNotice::Kind::kAtRest, .jogs = jogs, .referenced = 0x3F}));
    (void)dispatcher_->execute(bus_);
  }
  void submit(const Command& command) {
    EXPECT_TRUE(inboxes_[0].try_push(command));
    (void)dispatcher_->execute(bus_);
  }

  const std::unique_ptr<MotionMailbox> mailbox = std::make_unique<MotionMailbox>();  // too large for a stack

 private:
  struct Silent final : EventListener {
    void on_event(const Event&) noexcept override {}
  };

  const RobotModel robot_ = paper_robot();
  const Arm arm_{robot_};
  const PlanningConfig config_{};
  Silent events_;
  Inboxes inboxes_;
  ToolIo tool_io_;
  FakeLogic bus_;
  const std::unique_ptr<Dispatcher> dispatcher_ =
      std::make_unique<Dispatcher>(robot_, arm_, config_, inboxes_, *mailbox, tool_io_, events_);
};

}  // namespace armature::test
