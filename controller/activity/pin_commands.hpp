// The commands for the tool's pins, which wait in the queue of moves (message/command.hpp). Each is executed when the
// arm is at the end of the move before, and the moves behind it are planned after that.
//
// Core 1 sleeps while it waits for an input: the GPIO interrupt wakes it, and so does each tick when the wait has a
// time-out.
#pragma once

#include "controller/activity/activity.hpp"
#include "controller/activity/move_queue.hpp"
#include "controller/activity/tool_io.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"

namespace armature {

class PinCommands final : public Activity {
 public:
  // References must outlive the object.
  PinCommands(ToolIo& tool, MoveQueue& queue, EventListener& events) noexcept
      : tool_{tool}, queue_{queue}, events_{events} {}

  // Executes the front of the queue. `stands`: the arm is at the end of the move before. False: it waits.
  [[nodiscard]] bool execute(const SetOutput& output, bool stands, RegisterBus& bus) noexcept;
  [[nodiscard]] bool execute(const WaitInput& wait, bool stands, RegisterBus& bus) noexcept;
  [[nodiscard]] bool waits_for_time() const noexcept { return tool_.has_timeout(); }

  // Activity
  void drop(Refusal) noexcept override { tool_.cancel(); }

 private:
  ToolIo& tool_;
  MoveQueue& queue_;
  EventListener& events_;
};

}  // namespace armature
