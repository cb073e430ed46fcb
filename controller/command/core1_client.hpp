// A part of core 1's software. The loop of core 1 executes each client in turn and notifies it of every event.
#pragma once

#include "controller/hal/register_bus.hpp"
#include "controller/message/event.hpp"

namespace armature {

class Core1Client : public EventListener {
 public:
  // Executes one step of the available work. A step must be short, because the other clients wait for it. Returns true
  // when more work can be done at once, false when there is none or the client waits for something. The bus may suspend
  // the core.
  [[nodiscard]] virtual bool execute(RegisterBus& bus) noexcept = 0;

  // True when core 0 must wake core 1 in each tick, because the client waits for time to pass.
  [[nodiscard]] virtual bool waits_for_time() const noexcept { return false; }

  // Called for every event of both cores, including those that this client causes. The client may react in its next
  // execute() only.
  void on_event(const Event&) noexcept override {}

 protected:
  ~Core1Client() = default;
};

}  // namespace armature
