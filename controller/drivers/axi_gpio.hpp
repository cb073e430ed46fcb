// AXI GPIO v2.0: 16 outputs (channel 1) and 16 inputs (channel 2) for an end-effector tool.
//
// Bit i of a word is pin i + 1. After reset the pins of channel 1 are inputs, and arm_soc holds the outputs low:
// drive_outputs() must be called before outputs are set or read. Channel 2 of arm_soc has inputs only.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class AxiGpio {
 public:
  static constexpr std::uint8_t kPins = 16;  // of each channel, 1..kPins

  explicit AxiGpio(RegisterBus& bus, RegAddr base = {regs::soc::kAxiGpioBase}) noexcept : bus_{bus}, base_{base} {}

  // Makes all pins of channel 1 outputs. They take the levels that were written last, low after reset.
  void drive_outputs() noexcept;
  // All outputs at once; bits above the 16 pins are ignored. The pins follow one clock after the write.
  void set_outputs(std::uint16_t levels) noexcept;
  // Sets the outputs of `mask`, bit i for pin i + 1; the others keep their written level. It reads before it writes, so
  // two cores must not call it, or set_output(), at the same time. Core 0 does so while a plan is executed, core 1
  // while no plan is.
  void set_levels(std::uint16_t mask, std::uint16_t levels) noexcept;
  // Sets one output, 1..kPins.
  void set_output(std::uint8_t pin, bool level) noexcept;
  // The written levels; the levels of the pins may differ.
  [[nodiscard]] std::uint16_t outputs() noexcept;

  // The pins two clocks ago. Not debounced.
  [[nodiscard]] std::uint16_t inputs() noexcept;
  [[nodiscard]] bool input(std::uint8_t pin) noexcept;

  // Raises the interrupt line when an input changes in either direction. A change since reset, or since the last
  // acknowledgement, raises it at once.
  void enable_input_interrupt() noexcept;
  // Clears the pending input changes; returns whether there were any. Inputs that are read after this call include all
  // cleared changes: a later change raises the line again.
  bool acknowledge_inputs() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
