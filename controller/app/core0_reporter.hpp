// Core 0 reports to the host and to core 1.
#pragma once

#include <cassert>

#include "controller/activity/channel.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/controller_observer.hpp"

namespace armature {

class Core0Reporter final : public ControllerObserver {
 public:
  // References must outlive the reporter; `bus` is that of core 0.
  Core0Reporter(ControllerObserver& host, Channel& channel, RegisterBus& bus) noexcept
      : host_{host}, channel_{channel}, bus_{bus} {}

  void on_tick(const Telemetry& telemetry) noexcept override { host_.on_tick(telemetry); }
  void on_event(const Event& event) noexcept override {
    host_.on_event(event);
    [[maybe_unused]] const bool pushed = channel_.events.try_push(event);
    assert(pushed);  // never full, see Channel
    bus_.send_event();
  }

 private:
  ControllerObserver& host_;
  Channel& channel_;
  RegisterBus& bus_;
};

}  // namespace armature
