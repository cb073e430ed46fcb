// Is notified of the events and ticks of the controller, on the core that caused them.
#pragma once

#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"

namespace armature {

class ControllerObserver : public EventListener {
 public:
  virtual void on_tick(const Telemetry&) noexcept = 0;  // at the end of each tick's computation, core 0

 protected:
  ~ControllerObserver() = default;
};

}  // namespace armature
