// Core 0 reports to the host and to core 1.
#pragma once

#include <cassert>

#include "controller/hal/register_bus.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/controller_observer.hpp"
#include "controller/motion/mailbox.hpp"

namespace armature {

class Core0Reporter final : public ControllerObserver {
 public:
  // References must outlive the reporter; `bus` is that of core 0.
  Core0Reporter(ControllerObserver& host, MotionMailbox& mailbox, RegisterBus& bus) noexcept
      : host_{host}, mailbox_{mailbox}, bus_{bus} {}

  void on_tick(const Telemetry& telemetry) noexcept override { host_.on_tick(telemetry); }
  void on_event(const Event& event) noexcept override {
    host_.on_event(event);
    [[maybe_unused]] const bool pushed = mailbox_.events.try_push(event);
    assert(pushed);  // never full, see MotionMailbox
    bus_.send_event();
  }

 private:
  ControllerObserver& host_;
  MotionMailbox& mailbox_;
  RegisterBus& bus_;
};

}  // namespace armature
