// The six pulse-and-direction generators: staged counts, their common commit, servo enables and stop latches.
//
// Axis masks have bit 0 for axis 1.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class PulseTrain {
 public:
  static constexpr std::uint8_t kAllAxes = (1u << kAxes) - 1u;

  // Timing of the outputs. The defaults suit common servo drives: 500 ns before and after a change of direction.
  struct Config {
    Cycles tick;              // trigger period, over which the pulses of a count are spread; 1..4095
    Cycles dir_setup{25};     // direction stable before the first pulse after a change; 0..1023
    Cycles dir_hold{25};      // direction stable after the falling edge of the last pulse before the change; 0..1023
    Ticks watchdog_limit{4};  // consecutive triggers without a commit that stop all axes; 0..255
  };

  // Live state of the generators.
  struct Status {
    bool estop = false;          // emergency stop is latched
    bool watchdog = false;       // watchdog is latched
    bool estop_pin = false;      // the emergency-stop input is active now
    bool pending = false;        // a committed set waits for the trigger that activates it
    std::uint16_t sequence = 0;  // of the set that was activated last
  };

  // Sticky event flags.
  struct Faults {
    bool estop = false;
    bool watchdog = false;
    bool underrun = false;  // a trigger found no committed set: that tick emitted no pulses
    bool residual = false;  // pulses did not fit in their tick
    bool clipped = false;   // a count was outside +-200 and was limited
    bool recommit = false;  // a committed set was replaced before its trigger
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

  explicit PulseTrain(RegisterBus& bus, RegAddr base = {regs::soc::kPulseTrainBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is present and has the register map that this driver supports.
  [[nodiscard]] bool identified() noexcept;

  // Writes the timing registers. Call only while all servo enables are 0: otherwise the block refuses the writes with a
  // bus error.
  void configure(const Config& config) noexcept;

  // Sets the servo enables (axis mask). `run`: a trigger without a commit counts as an underrun.
  void control(std::uint8_t servo_on, bool run) noexcept;

  // Stages six counts (-200..200 pulses for one tick) and commits them together under `sequence`: the next trigger
  // starts them on one edge.
  void commit(const PerAxis<Pulses>& counts, std::uint16_t sequence) noexcept;

  [[nodiscard]] Status status() noexcept;
  [[nodiscard]] Faults faults() noexcept;
  // Clears exactly the flags that are set in `faults`.
  void clear(const Faults& faults) noexcept;

  // Triggers without a commit since reset; saturates.
  [[nodiscard]] std::uint32_t underruns() noexcept;
  // Net pulses emitted from reset to the last trigger: the low 32 bits, which wrap.
  [[nodiscard]] PerAxis<std::int32_t> emitted() noexcept;
  // Committed minus emitted pulses of all finished ticks since reset: the low 32 bits, which wrap.
  [[nodiscard]] PerAxis<std::int32_t> residual() noexcept;
  [[nodiscard]] Switches switches() noexcept;
  [[nodiscard]] Drives drives() noexcept;

  // Stops all axes at once and sets the latch, like the emergency-stop input.
  void emergency_stop() noexcept;
  // Clears both latches. The emergency-stop latch stays set while its input is active.
  void clear_stops() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
