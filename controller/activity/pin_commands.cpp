#include "controller/activity/pin_commands.hpp"

namespace armature {

bool PinCommands::execute(const SetOutput& output, bool stands, RegisterBus& bus) noexcept {
  if (!stands) return false;
  tool_.set(output, bus);
  events_.on_event(IoDone{.tag = output.tag, .pin = output.pin, .level = output.level});
  queue_.drop_front();
  return true;
}

bool PinCommands::execute(const WaitInput& wait, bool stands, RegisterBus& bus) noexcept {
  if (!tool_.waiting()) {
    if (!stands) return false;
    tool_.begin(wait, bus);
  }
  switch (tool_.sample(bus)) {
    case ToolIo::WaitState::kPending:
      return false;
    case ToolIo::WaitState::kReached:
      events_.on_event(IoDone{.tag = wait.tag, .pin = wait.pin, .level = wait.level});
      queue_.drop_front();
      break;
    case ToolIo::WaitState::kTimedOut:
      queue_.refuse_all(Refusal::kInputTimeout);
      break;
  }
  return true;
}

}  // namespace armature
