// The host's side of the mailbox memory.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/command/command.hpp"
#include "controller/core/tag.hpp"
#include "controller/event/event.hpp"
#include "controller/mailbox/memory.hpp"
#include "controller/motion/telemetry.hpp"

namespace armature::mailbox {

class HostEnd {
 public:
  // Prepares the memory, which must be all 0. Construct it before the controller starts; the memory must outlive this.
  explicit HostEnd(Memory& memory) noexcept;

  // Writes a command to the ring of its source; the host then wakes core 1. False when the ring is full.
  [[nodiscard]] bool submit(Source source, const Command& command) noexcept;

  // Publishes the count of the encoder of the conveyor. The controller reads the latest one in each tick.
  void publish_belt(std::int64_t counts) noexcept;

  // The oldest unread event; events of core 0 come first.
  [[nodiscard]] std::optional<Event> next_event() noexcept;
  // Number of events for which a ring had no room. They are lost, so the host's information is incomplete.
  [[nodiscard]] std::uint32_t lost_events() const noexcept;

  // The telemetry of the last tick, returned once for each published tick. Nothing when there is no new one, or while
  // it is being written.
  [[nodiscard]] std::optional<Telemetry> new_telemetry() noexcept;

 private:
  Memory& memory_;
  std::uint32_t last_published_ = 0;  // PublishedTelemetry::published
};

}  // namespace armature::mailbox
