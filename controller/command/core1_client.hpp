// A part of core 1's software: the loop of core 1 gives each client its turn and passes it every event.
#pragma once

#include "controller/event/event.hpp"
#include "controller/hal/register_bus.hpp"

namespace armature {

class Core1Client : public EventListener {
 public:
  // One step of the work that is there: short enough for the others to wait for. True when more can be done at once;
  // false when there is nothing to do or something to wait for. The bus may suspend the core.
  [[nodiscard]] virtual bool execute(RegisterBus& bus) noexcept = 0;

  // Core 0 must wake core 1 in each tick, because the client waits for time to pass.
  [[nodiscard]] virtual bool waits_for_time() const noexcept { return false; }

  // Every event of both cores, also those that this client causes. It must not act on an event before its turn.
  void on_event(const Event&) noexcept override {}

 protected:
  ~Core1Client() = default;
};

}  // namespace armature
