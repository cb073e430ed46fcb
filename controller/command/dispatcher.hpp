// The client of core 1 that accepts commands, and gives each to the activity that takes it.
//
// The moves and the commands for pins wait in a queue. Plans, which have the arm by default, execute them; so does the
// conveyor while the arm follows a part. ArmOwner knows which activity has the arm. Stop and ClearFault overtake
// waiting moves. The moves of Source::kProgram wait in their inbox until there is room.
//
// Every move is either started or reported as refused, including those that a Stop or a fault drops. When a chain is
// refused, the segment that causes it is reported with its reason, the others with kChainRefused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/activity/activities.hpp"
#include "controller/activity/activity.hpp"
#include "controller/activity/arm_owner.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/move_queue.hpp"
#include "controller/activity/pin_commands.hpp"
#include "controller/activity/tool_io.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class Dispatcher final : public Core1Client, private Activity {
 public:
  // References must outlive the dispatcher.
  Dispatcher(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, Inboxes& inboxes, Channel& channel,
             ToolIo& tool, EventListener& events) noexcept;
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;
  ~Dispatcher() = default;

  // Who has the arm: for all clients of core 1.
  [[nodiscard]] const ArmOwner& owner() const noexcept { return owner_; }

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override {
    return pins_.waits_for_time() || activities_.plans.waits_for_time() || activities_.conveyor.waits_for_time();
  }
  void on_event(const Event& event) noexcept override { owner_.on_event(event); }

 private:
  [[nodiscard]] bool accept_next(Inbox& inbox) noexcept;
  template <class C>
  [[nodiscard]] std::optional<MoveRefused> accept(const C& command) noexcept;
  void drop_program() noexcept;
  // One step of the waiting work; false: there is none, no room for a plan, or something to wait for.
  [[nodiscard]] bool execute_next(RegisterBus& bus) noexcept;
  template <class Move>
  [[nodiscard]] bool execute(const Move& move, RegisterBus& bus) noexcept;

  // Activity, for the moves of programs that are still in their inbox.
  void drop(Refusal why) noexcept override { dropping_program_ = why; }

  Inboxes& inboxes_;
  EventListener& events_;
  UserFrames frames_;  // the last one is that in which a path on the conveyor is planned
  ArmOwner owner_;
  MoveQueue queue_;
  PinCommands pins_;
  Activities activities_;
  std::optional<Refusal> dropping_program_{};
};

}  // namespace armature
