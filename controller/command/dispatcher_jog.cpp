// Jogs: core 1 checks their commands and sends them on, core 0 executes them.
#include <optional>

#include "controller/command/dispatcher.hpp"
#include "controller/command/frames.hpp"
#include "controller/command/move_checks.hpp"

namespace armature {

void Dispatcher::accept(const Jog& jog) noexcept {
  std::optional<MoveRefused> refusal = find_refusal(robot_, frames_, jog);
  if (!refusal && !referenced_) refusal = MoveRefused{.reason = Refusal::kNotReferenced};
  if (!refusal && !jogging_ && !rest()) refusal = MoveRefused{.reason = Refusal::kNotReady};
  if (refusal) {
    refusal->tag = jog.tag;
    return events_.on_event(*refusal);
  }
  next_jog_ = velocity_command(jog, frames_);
  jogging_ = true;
  jog_ended_.reset();
  mode_ = Mode::kAwaitingRest;
}

// Also a jog that a weaker command has ended already, and that still brakes.
void Dispatcher::end_jog(VelocityCommand::Kind how) noexcept {
  if (!jogging_ && !(jog_ended_ && how > *jog_ended_)) return;
  next_jog_ = VelocityCommand{.kind = how};
  jogging_ = false;
  jog_ended_ = how;
}

void Dispatcher::send_jog() noexcept {
  if (!next_jog_ || !mailbox_.jogs.try_push(*next_jog_)) return;
  ++jogs_sent_;
  next_jog_.reset();
}

}  // namespace armature
