// The part of the software that owns an interrupt line of a core.
#pragma once

#include "controller/hal/register_bus.hpp"

namespace armature {

class InterruptHandler {
 public:
  // True when the line may wake the core now.
  [[nodiscard]] virtual bool enabled() const noexcept = 0;
  // Called when the line has woken the core. Charges the interrupt entry; the client does the remaining work in its
  // next execute().
  virtual void on_interrupt(RegisterBus& bus) noexcept = 0;

 protected:
  ~InterruptHandler() = default;  // never owned through this interface
};

}  // namespace armature
