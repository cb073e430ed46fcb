// The six pulse generators of Vo 2021, which are written a signed half period instead of a count. The block also has
// servo enables and a stop latch.
//
// Axis masks have bit 0 for axis 1.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class PulseWidth {
 public:
  static constexpr std::uint8_t kAllAxes = (1u << kAxes) - 1u;

  // Live state of the generators.
  struct Status {
    bool estop = false;      // emergency stop is latched
    bool estop_pin = false;  // the emergency-stop input is active now
    std::uint8_t armed = 0;  // axes whose width was written since reset and since the last stop; only these emit pulses
  };

  // Axis masks of inputs.
  struct Switches {
    std::uint8_t home = 0;
    std::uint8_t limit_pos = 0;
    std::uint8_t limit_neg = 0;
  };
  struct Drives {
    std::uint8_t alarm = 0;
    std::uint8_t in_position = 0;
    std::uint8_t servo_on = 0;  // the enables, as the drives see them
  };

  explicit PulseWidth(RegisterBus& bus, RegAddr base = {regs::soc::kPulseWidthBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is present and has the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // Sets the servo enables, axis mask.
  void set_servo(std::uint8_t servo_on) noexcept;

  // Sets the signed half periods. They apply from the next trigger until others are written; 0: no pulses. The six
  // registers are written one after the other, so a trigger in between starts some axes with their old width.
  // motion/half_period.hpp says how many pulses a width emits.
  void set_widths(const PerAxis<Cycles>& widths) noexcept;

  [[nodiscard]] Status status() noexcept;
  // The flag says that an emergency stop was latched since it was last cleared.
  void clear_estop_flag() noexcept;

  // Clock cycles since reset; the decoder's trigger time has the same time base. Wraps.
  [[nodiscard]] std::uint32_t time() noexcept;
  // Net pulses emitted from reset to the last trigger: the low 32 bits, which wrap.
  [[nodiscard]] PerAxis<std::int32_t> emitted() noexcept;
  [[nodiscard]] Switches switches() noexcept;
  [[nodiscard]] Drives drives() noexcept;

  // Stops all axes at once and sets the latch, like the emergency-stop input.
  void emergency_stop() noexcept;
  // Clears the latch; it stays set while the input is active. Each axis stands until its width is written again.
  void clear_stop() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
