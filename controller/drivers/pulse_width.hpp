// The six pulse generators of Vo 2021, which are sent a signed half period instead of a count: widths, servo enables
// and stop latch.
//
// Axis masks have bit 0 for axis 1.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
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
    std::uint8_t armed = 0;  // axes whose width was written since reset and since the last stop: only these start
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
  };

  explicit PulseWidth(RegisterBus& bus, RegAddr base = {regs::soc::kPulseWidthBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is there with the register map that this driver knows.
  [[nodiscard]] bool identified() noexcept;

  // Servo-enable requests, axis mask.
  void set_servo(std::uint8_t servo_on) noexcept;

  // The signed half periods from the next trigger on, until others are written; 0: no pulses. The six are written one
  // by one: a trigger in between starts some axes with the old width. What a width emits: motion/half_period.hpp.
  void set_widths(const PerAxis<Cycles>& widths) noexcept;

  [[nodiscard]] Status status() noexcept;
  // Whether an emergency stop has been latched since the flag was last cleared.
  [[nodiscard]] bool estop_seen() noexcept;
  void clear_estop_seen() noexcept;

  // Clock cycles since reset, the time base of the decoder's trigger time too. Wraps.
  [[nodiscard]] std::uint32_t time() noexcept;
  // Net pulses emitted from reset to the last trigger. The low 32 bits: wraps.
  [[nodiscard]] PerAxis<std::int32_t> emitted() noexcept;
  [[nodiscard]] Switches switches() noexcept;
  [[nodiscard]] Drives drives() noexcept;

  // Stops all axes now and latches, like the emergency-stop input.
  void emergency_stop() noexcept;
  // Releases the latch; it stays while the input is active. Each axis stands until its width is written again.
  void clear_stop() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
