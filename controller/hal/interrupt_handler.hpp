// The part of the software that owns an interrupt line of a core.
#pragma once

#include "controller/hal/register_bus.hpp"

namespace armature {

class InterruptHandler {
 public:
  // The line may wake the core now.
  [[nodiscard]] virtual bool enabled() const noexcept = 0;
  // The line has woken the core. Charges the interrupt entry; what is left to do happens in the client's next turn.
  virtual void on_interrupt(RegisterBus& bus) noexcept = 0;

 protected:
  ~InterruptHandler() = default;  // never owned through this interface
};

}  // namespace armature
