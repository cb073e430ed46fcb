// The tool's pins as core 1 uses them: outputs that are switched, and the one input that is waited for.
//
// An input is sampled when the wait begins and whenever the GPIO interrupts, so a level must last until core 1 has
// read it, a few microseconds. Nothing touches the bus before the first command for a pin.
#pragma once

#include <cstdint>

#include "controller/command/command.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/interrupt_handler.hpp"
#include "controller/hal/register_bus.hpp"

namespace armature {

class ToolIo final : public InterruptHandler {
 public:
  enum class Seen : std::uint8_t {
    kNotYet,
    kLevel,    // the pin has the level; the wait is over
    kTimeOut,  // it had not in time; the wait is over
  };

  // InterruptHandler of the GPIO.
  [[nodiscard]] bool enabled() const noexcept override { return waiting_; }
  void on_interrupt(RegisterBus& bus) noexcept override;

  void set(const SetOutput& output, RegisterBus& bus) noexcept;

  // There is a wait under way.
  [[nodiscard]] bool waiting() const noexcept { return waiting_; }
  // Somebody must wake core 1 in each tick, so that the time-out is noticed.
  [[nodiscard]] bool timed() const noexcept { return waiting_ && wait_.timeout != Ticks{}; }
  // Begins a wait; its time-out counts from here.
  void begin(const WaitInput& wait, RegisterBus& bus) noexcept;
  // While waiting(). A level that is seen with the last event before the time-out is seen in time.
  [[nodiscard]] Seen sample(RegisterBus& bus) noexcept;
  void give_up() noexcept { waiting_ = false; }

 private:
  bool waiting_ = false;
  bool changed_ = false;  // the input must be read
  WaitInput wait_{};
  Cycles began_{};
};

}  // namespace armature
