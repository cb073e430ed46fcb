// A dispatcher without core 0: the test reads what it sends, and answers.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "controller/command/dispatcher.hpp"
#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/model_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

class DispatcherBench {
 public:
  // Core 0 reports that the arm stands, in answer to the request with this number.
  void at_rest(std::uint32_t number) {
    EXPECT_TRUE(channel->loop.answers.try_push({.kind = Answer::Kind::kRest, .number = number, .referenced = 0x3F}));
    (void)dispatcher_->execute(bus_);
  }
  void submit(const Command& command) {
    EXPECT_TRUE(inboxes_[0].try_push(command));
    (void)dispatcher_->execute(bus_);
  }

  const std::unique_ptr<Channel> channel = std::make_unique<Channel>();  // too large for a stack

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
  ModelLogic bus_;
  const std::unique_ptr<Dispatcher> dispatcher_ =
      std::make_unique<Dispatcher>(robot_, arm_, config_, inboxes_, *channel, tool_io_, events_);
};

}  // namespace armature::test
