#include "controller/host_memory/controller_side.hpp"

#include <cassert>
#include <optional>

#include "controller/host_memory/wire.hpp"

namespace armature::host_memory {

void Core0Writer::on_tick(const Telemetry& telemetry) noexcept {
  const std::atomic_ref<std::uint32_t> published{memory_.telemetry.published};
  const std::uint32_t before = published.load(std::memory_order_relaxed);
  published.store(before + 1, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);
  put(memory_.telemetry.body.data(), 0, telemetry);
  published.store(before + 2, std::memory_order_release);
}

void Core0Writer::on_event(const Event& event) noexcept {
  memory_.core0_events.push_or_count_lost(encode(event));
}

void Core1Writer::on_event(const Event& event) noexcept {
  memory_.core1_events.push_or_count_lost(encode(event));
}

void receive_commands(HostMemory& memory, Inboxes& inboxes) noexcept {
  for (std::size_t source = 0; source < kHostSources; ++source) {
    while (!inboxes[source].full()) {
      const std::optional<CommandSlot> slot = memory.commands[source].try_pop();
      if (!slot) break;
      const std::optional<Command> command = decode(*slot);
      if (!command) continue;
      [[maybe_unused]] const bool pushed = inboxes[source].try_push(*command);
      assert(pushed);
    }
  }
}

}  // namespace armature::host_memory
