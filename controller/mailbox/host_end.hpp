// The host's end of the mailbox memory.
#pragma once

#include <optional>

#include "controller/command/command.hpp"
#include "controller/core/tag.hpp"
#include "controller/event/event.hpp"
#include "controller/mailbox/memory.hpp"
#include "controller/motion/telemetry.hpp"

namespace armature::mailbox {

class HostEnd {
 public:
  // Prepares the memory, which is all 0. Before the controller starts; the memory must outlive this.
  explicit HostEnd(Memory& memory) noexcept;

  // Puts a command into the ring of its source; the host then wakes core 1. False when the ring is full.
  [[nodiscard]] bool submit(Source source, const Command& command) noexcept;

  // The oldest event that was not read yet, first those of core 0.
  [[nodiscard]] std::optional<Event> next_event() noexcept;
  // Events for which a ring had no room. They cannot be reported any more: what the host knows is wrong.
  [[nodiscard]] u32 lost_events() const noexcept;

  // The telemetry of the last tick, once for each tick that is published. Nothing when there is none, or while it is
  // being written.
  [[nodiscard]] std::optional<Telemetry> new_telemetry() noexcept;

 private:
  Memory& memory_;
  u32 seen_ = 0;  // TelemetryBlock::published
};

}  // namespace armature::mailbox
