// The host's side of the memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "controller/base/tag.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"

namespace armature::host_memory {

class HostSide {
 public:
  // The memory must outlive this. It has all that the controller starts with, see BootMemory.
  explicit HostSide(HostMemory& memory) noexcept : memory_{memory} {}

  // Why the controller has not started; null: it has, or will soon.
  [[nodiscard]] const BootReport* boot_problem() const noexcept {
    return load(memory_.boot.problem) == 0 ? nullptr : &memory_.boot;
  }

  // Writes a command to the ring of its source; the host then wakes core 1. False when the ring is full.
  [[nodiscard]] bool submit(Source source, const Command& command) noexcept;

  // Publishes a sample of the encoder or the camera of the conveyor. The controller reads the latest one in each tick.
  void publish_belt(std::int64_t counts) noexcept;

  // Whether submit() has room for a command of the source.
  [[nodiscard]] bool has_room(Source source) const noexcept;

  [[nodiscard]] bool has_events() const noexcept {
    return !memory_.core0_events.is_empty() || !memory_.core1_events.is_empty();
  }
  // Whether any of next_event(), lost_events(), new_telemetry() and boot_problem() may have something to say.
  [[nodiscard]] bool has_news() const noexcept {
    return has_events() || lost_events() != 0 || boot_problem() != nullptr ||
           load(memory_.telemetry.published) != last_published_;
  }
  // The oldest unread event; events of core 0 come first.
  [[nodiscard]] std::optional<Event> next_event() noexcept;
  // Number of events for which a ring had no room. They are lost, so the host's information is incomplete.
  [[nodiscard]] std::uint32_t lost_events() const noexcept {
    return memory_.core0_events.lost + memory_.core1_events.lost;
  }

  // The telemetry of the last tick, returned once for each published tick. Nothing when there is no new one, or while
  // it is being written.
  [[nodiscard]] std::optional<Telemetry> new_telemetry() noexcept;
  // The same into `telemetry`, for a caller that keeps it. Returns false, and leaves it as it is, if there is no new
  // one, if one was being written meanwhile, or if a byte has a value that telemetry does not have.
  bool read_new(Telemetry& telemetry) noexcept;

 private:
  [[nodiscard]] static std::uint32_t load(std::uint32_t& word) noexcept {
    return std::atomic_ref<std::uint32_t>{word}.load(std::memory_order_acquire);
  }

  HostMemory& memory_;
  std::uint32_t last_published_ = 0;  // PublishedTelemetry::published
};

}  // namespace armature::host_memory
