// Outputs of the tool that a program has switched on for a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/activity/tool_io.hpp"
#include "controller/base/units.hpp"

namespace armature {

class OutputPulses {
 public:
  static constexpr std::size_t kPins = 16;

  // Switches an output on until `end`; a pulse of this pin that has begun ends then, too.
  void begin(std::uint8_t pin, Ticks end, ToolIo& tool, RegisterBus& bus) noexcept {
    tool.set({.pin = pin, .level = true}, bus);
    under_way_ |= bit(pin);
    ends_[pin - 1U] = end;
  }
  // Switches off the outputs whose time is over.
  void end_due(Ticks now, ToolIo& tool, RegisterBus& bus) noexcept {
    for (std::uint8_t pin = 1; pin <= kPins; ++pin) {
      if ((under_way_ & bit(pin)) == 0 || now < ends_[pin - 1U]) continue;
      tool.set({.pin = pin, .level = false}, bus);
      under_way_ &= ~bit(pin);
    }
  }
  [[nodiscard]] bool any() const noexcept { return under_way_ != 0; }

 private:
  [[nodiscard]] static constexpr std::uint32_t bit(std::uint8_t pin) noexcept { return 1U << (pin - 1U); }

  std::uint32_t under_way_ = 0;  // bit 0 for pin 1
  std::array<Ticks, kPins> ends_{};
};

}  // namespace armature
