#include "controller/host_memory/host_side.hpp"

#include <atomic>
#include <utility>

#include "controller/host_memory/wire.hpp"

namespace armature::host_memory {

bool HostSide::submit(Source source, const Command& command) noexcept {
  return memory_.commands[static_cast<std::size_t>(source)].try_push(encode(command));
}

bool HostSide::has_room(Source source) const noexcept {
  return !memory_.commands[static_cast<std::size_t>(source)].is_full();
}

void HostSide::publish_belt(std::int64_t counts) noexcept {
  std::atomic_ref<std::int64_t>{memory_.belt_counts}.store(counts, std::memory_order_relaxed);
  const std::atomic_ref<std::uint32_t> number{memory_.belt_sample};
  number.store(number.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

std::optional<Event> HostSide::next_event() noexcept {
  if (const std::optional<EventSlot> slot = memory_.core0_events.try_pop()) return decode(*slot);
  if (const std::optional<EventSlot> slot = memory_.core1_events.try_pop()) return decode(*slot);
  return std::nullopt;
}

std::optional<Telemetry> HostSide::new_telemetry() noexcept {
  std::optional<Telemetry> telemetry{std::in_place};
  if (!read_new(*telemetry)) telemetry.reset();
  return telemetry;
}

bool HostSide::read_new(Telemetry& telemetry) noexcept {
  const std::atomic_ref<std::uint32_t> published{memory_.telemetry.published};
  const std::uint32_t before = published.load(std::memory_order_acquire);
  if (before == last_published_ || before % 2 != 0) return false;
  std::size_t at = 0;
  Telemetry read;
  const bool valid = take(memory_.telemetry.body.data(), at, read);
  std::atomic_thread_fence(std::memory_order_acquire);
  if (!valid || published.load(std::memory_order_relaxed) != before) return false;
  telemetry = read;
  last_published_ = before;
  return true;
}

}  // namespace armature::host_memory
