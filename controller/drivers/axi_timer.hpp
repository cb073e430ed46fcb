// AXI Timer v2.0, timer 0 as the source of the tick trigger.
#pragma once

#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class AxiTimer {
 public:
  explicit AxiTimer(RegisterBus& bus, RegAddr base = {regs::soc::kAxiTimerBase}) noexcept : bus_{bus}, base_{base} {}

  // Starts periodic triggers: down-count with automatic reload, GenerateOut pulse and interrupt. The first trigger
  // comes one period after the call. `period` is 2 cycles .. 2^32+1 cycles; the counter needs TLR+2 cycles per period.
  void start(Cycles period) noexcept;

  // Clears the interrupt flag; the timer continues. A roll-over at the same time is not lost: the flag stays set.
  void acknowledge() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
