#include "controller/mailbox/host_end.hpp"

#include <atomic>
#include <utility>

#include "controller/mailbox/codec.hpp"
#include "controller/mailbox/telemetry_fields.hpp"
#include "controller/mailbox/wire.hpp"

namespace armature::mailbox {

HostEnd::HostEnd(Memory& memory) noexcept : memory_{memory} {
  memory_.magic = kMagic;
  memory_.layout_version = kLayoutVersion;
  memory_.bytes = static_cast<u32>(sizeof(Memory));
}

bool HostEnd::submit(Source source, const Command& command) noexcept {
  return memory_.commands[static_cast<std::size_t>(source)].try_push(encode(command));
}

void HostEnd::publish_belt(std::int64_t counts) noexcept {
  std::atomic_ref<i64>{memory_.belt_counts}.store(counts, std::memory_order_release);
}

std::optional<Event> HostEnd::next_event() noexcept {
  if (const std::optional<EventBlock> block = memory_.core0_events.try_pop()) return decode(*block);
  if (const std::optional<EventBlock> block = memory_.core1_events.try_pop()) return decode(*block);
  return std::nullopt;
}

u32 HostEnd::lost_events() const noexcept {
  return memory_.core0_events.lost + memory_.core1_events.lost;
}

std::optional<Telemetry> HostEnd::new_telemetry() noexcept {
  const std::atomic_ref<u32> published{memory_.telemetry.published};
  const u32 before = published.load(std::memory_order_acquire);
  if (before == last_published_ || before % 2 != 0) return std::nullopt;
  std::optional<Telemetry> telemetry{std::in_place};
  FieldsOf<Telemetry>::transfer(Decode{}, std::as_const(memory_.telemetry), *telemetry);
  std::atomic_thread_fence(std::memory_order_acquire);
  if (published.load(std::memory_order_relaxed) != before) return std::nullopt;
  last_published_ = before;
  return telemetry;
}

}  // namespace armature::mailbox
