// Fixture of pulse_width with its AXI port, and the pins, tick timer and drives of the pulse_train fixture.
#pragma once

#include <array>
#include <cstdint>

#include "controller/regs/pulse_width_regs.hpp"
#include "tests/rtl/pulse_train_fixture.hpp"

namespace armature::test {

inline constexpr int kTickCycles = 2500;  // 50 us at 50 MHz

template <class Dut>
class PulseWidthFixture : public PulseTrainFixture<Dut> {
 protected:
  void write_width(std::size_t axis, std::int32_t width) {
    this->write(regs::pulse_width::kWidthOffset + 4 * static_cast<std::uint32_t>(axis),
                static_cast<std::uint32_t>(width));
  }

  void write_widths(const std::array<std::int32_t, kAxes>& widths) {
    for (std::size_t i = 0; i < kAxes; ++i) write_width(i, widths[i]);
  }

  [[nodiscard]] std::int32_t emitted(int axis) { return this->read_axis(regs::pulse_width::kEmittedOffset, axis); }
};

}  // namespace armature::test
