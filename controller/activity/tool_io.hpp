// The tool's pins as core 1 uses them: it sets outputs, and waits for one input at a time.
//
// An input is sampled when the wait begins and at each GPIO interrupt. So a level must last until core 1 has read it, a
// few microseconds. The bus is not accessed before the first command for a pin.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/hal/interrupt_handler.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"

namespace armature {

class ToolIo final : public InterruptHandler {
 public:
  enum class WaitState : std::uint8_t {
    kPending,
    kReached,   // the pin has the requested level; the wait has ended
    kTimedOut,  // the pin did not have it in time; the wait has ended
  };

  // InterruptHandler of the GPIO.
  [[nodiscard]] bool enabled() const noexcept override { return waiting_; }
  void on_interrupt(RegisterBus& bus) noexcept override;

  void set(const SetOutput& output, RegisterBus& bus) noexcept;

  // The level of an input, or that of an output as it was written.
  [[nodiscard]] bool level(std::uint8_t pin, bool output, RegisterBus& bus) noexcept;

  // A wait is in progress.
  [[nodiscard]] bool waiting() const noexcept { return waiting_; }
  // Core 1 must be woken in each tick to detect the time-out.
  [[nodiscard]] bool has_timeout() const noexcept { return waiting_ && wait_.timeout != Ticks{}; }
  // Begins a wait; the time-out counts from this call.
  void begin(const WaitInput& wait, RegisterBus& bus) noexcept;
  // Call while waiting(). A level that is sampled at the last event before the time-out counts as in time.
  [[nodiscard]] WaitState sample(RegisterBus& bus) noexcept;
  void cancel() noexcept { waiting_ = false; }

 private:
  bool waiting_ = false;
  bool changed_ = false;  // the input must be sampled
  WaitInput wait_{};
  Cycles began_{};
};

}  // namespace armature
