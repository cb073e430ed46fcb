// The parts of the pendant's client without its line: a test gives events, and reads what goes to the dispatcher.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "controller/language/program/program_client.hpp"
#include "controller/pendant/client/pendant_parts.hpp"
#include "tests/controller/support/mock_register_bus.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::pendant::test {

// A program that waits for ever at its line 7.
class WaitingProgram final : public Program {
 public:
  [[nodiscard]] bool has_line(ProgramPlace place) const noexcept override { return place == 7; }
  void set_single_step(bool) noexcept override {}
  void start() noexcept override {}
  [[nodiscard]] Progress step(ProgramPort&) noexcept override { return Progress::kWaiting; }
  [[nodiscard]] bool waits_for_time() const noexcept override { return false; }
};

class PartsBench final : private EventListener {
 public:
  explicit PartsBench(const PendantConfig& config = {}) : config_{config} {}

  // As the loop of core 1 does.
  void notify(const Event& event) {
    owner_.on_event(event);
    program.on_event(event);
    parts.arm.on_event(event);
    parts.commands.on_event(event);
  }
  // Core 0 has started with its drives off, and the pendant has switched them on.
  void switch_on() {
    notify(Faulted{.cause = FaultCause::kDrivesOff});
    notify(FaultCleared{});
  }
  [[nodiscard]] State state(Cycles now = {}) const { return parts.arm.state(now); }
  // The next command for the dispatcher, if it is a T.
  template <class T>
  [[nodiscard]] std::optional<T> given() {
    const std::optional<Command> command = inbox_of(inboxes_, Source::kPendant).try_pop();
    if (!command || !std::holds_alternative<T>(*command)) return std::nullopt;
    return std::get<T>(*command);
  }

 private:
  void on_event(const Event&) noexcept override {}

  const PendantConfig config_;
  const RobotModel robot_ = armature::test::irb120();
  const Arm arm_{robot_};
  PlanningConfig planning_{};
  const std::unique_ptr<Channel> channel_ = std::make_unique<Channel>();  // too large for a stack, like the parts
  ArmOwner owner_{robot_, *channel_, *this};
  Inboxes inboxes_;
  ToolIo tool_;

 public:
  testing::StrictMock<armature::test::MockRegisterBus> bus;
  ArmPosition position;
  WaitingProgram waiting;
  ProgramClient program{inboxes_, owner_, tool_, *this};
  const std::unique_ptr<ProgramStore> store = std::make_unique<ProgramStore>(
      RobotCell{.robot = robot_, .arm = arm_}, job::MachineSettings{}, gcode::MotionSettings{});
  const std::unique_ptr<PendantParts> owned = std::make_unique<PendantParts>(
      config_, robot_, arm_, planning_, position, owner_, inbox_of(inboxes_, Source::kPendant), *store, program);
  PendantParts& parts = *owned;
};

}  // namespace armature::pendant::test
