// RegisterBus of the Zynq-7020: registers of the logic are memory, and interrupts are those of the MPCore.
//
// The core takes no interrupt: it sleeps by WFI, which an interrupt ends although it is masked, and reads what is
// pending. So no code runs beside the controller, on the chip as in the simulation.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"

namespace armature::board {

class BoardBus final : public RegisterBus {
 public:
  // Once on core 0, before core 1 starts: the distributor, the timer and the snoop control unit.
  static void start_mpcore() noexcept;

  // Once on each core, on that core. `core`: 0 or 1. The lines of the logic that it may wait for are sent to it.
  BoardBus(int core, Interrupts lines) noexcept;

  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override;
  Cycles now() noexcept override;
  void charge(Work work, std::int64_t times) noexcept override;

 private:
  void enable(Interrupts mask) noexcept;

  Interrupts enabled_ = Interrupts::kNone;
};

}  // namespace armature::board
