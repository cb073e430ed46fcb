// The six pulse-and-direction generators: staged counts, their common commit, servo enables and stop latches.
//
// Axis masks have bit 0 for axis 1.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class PulseTrain {
 public:
  static constexpr std::uint8_t kAllAxes = (1u << kAxes) - 1u;

  // Timing of the outputs. The defaults are what common servo drives need: 500 ns around a change of direction.
  struct Config {
    Cycles tick;              // trigger period, over which the counts are spread; 1..4095
    Cycles dir_setup{25};     // direction stable before the first pulse after a change; 0..1023
    Cycles dir_hold{25};      // and after the falling edge of the last pulse before it; 0..1023
    Ticks watchdog_limit{4};  // triggers in a row without a commit that stop everything; 0..255
  };

  // Live state of the generators.
  struct Status {
    bool estop = false;          // emergency stop is latched
    bool watchdog = false;       // watchdog is latched
    bool estop_pin = false;      // the emergency-stop input is active now
    bool pending = false;        // a committed set waits for its trigger
    std::uint16_t sequence = 0;  // of the set that was activated last
  };

  // Sticky event flags.
  struct Faults {
    bool estop = false;
    bool watchdog = false;
    bool underrun = false;  // a trigger came without a committed set: that tick emitted nothing
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
  };

  explicit PulseTrain(RegisterBus& bus, RegAddr base = {regs::soc::kPulseTrainBase}) noexcept
      : bus_{bus}, base_{base} {}

  // True when the block is there with the register map that this driver knows.
  [[nodiscard]] bool identified() noexcept;

  // Writes the timing registers. Only while nothing is being emitted.
  void configure(const Config& config) noexcept;

  // Servo-enable requests (axis mask), and whether a trigger without a commit counts as an underrun.
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
  // Net pulses emitted from reset to the last trigger. The low 32 bits: wraps.
  [[nodiscard]] PerAxis<std::int32_t> emitted() noexcept;
  // Committed minus emitted pulses of all finished ticks since reset. The low 32 bits: wraps.
  [[nodiscard]] PerAxis<std::int32_t> residual() noexcept;
  [[nodiscard]] Switches switches() noexcept;
  [[nodiscard]] Drives drives() noexcept;

  // Stops all axes now and latches, like the emergency-stop input.
  void emergency_stop() noexcept;
  // Releases both latches; that of the emergency stop stays while its input is active.
  void clear_stops() noexcept;

 private:
  RegisterBus& bus_;
  RegAddr base_;
};

}  // namespace armature
