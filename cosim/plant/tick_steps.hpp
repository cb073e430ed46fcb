// The steps of the motors in a whole tick, for all axes at once. The same arithmetic in the same order as step by step
// and pulse by pulse, so the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/plant/electronic_gear.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/servo_drive.hpp"
#include "cosim/plant/subcounts.hpp"

namespace armature::cosim {

// The error after `count` pulses (0..200), each of which takes `step` away from it: rounded after each one.
[[nodiscard]] double less_pulses(double error, double step, int count);

class TickSteps {
 public:
  static constexpr std::size_t kMaxSteps = 16;  // steps of a tick

  // Takes the pulses of the tick, which has at most kMaxSteps steps, and moves the shafts through the steps that begin
  // in it. `moving`: axes that need the next step. Pulses after the last step belong to the first one of the next tick.
  void run(const TickPulses& tick, std::span<const ServoDrive> drives, std::uint8_t moving, Mechanics& mechanics,
           Shafts& shafts);

  // The steps that were made: while everything rests none is needed.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint8_t moved() const { return moved_; }  // axes that took part, one bit each
  [[nodiscard]] Cycles began(std::size_t step) const { return steps_[step].began; }
  // Of the motor at the end of the step.
  [[nodiscard]] Subcounts position(std::size_t step, std::size_t axis) const {
    return Subcounts{steps_[step].subcounts[axis]};
  }
  // Of all steps: the magnitudes of the errors after them, and the way that the shaft moved in them.
  struct Extremes {
    AxisNumbers smallest_error, largest_error;  // [counts]
    AxisNumbers least_way, most_way;            // [counts], signed
  };
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }

 private:
  struct Step {
    Cycles began{};
    AxisIntegers subcounts;
  };

  void begin(const TickPulses& tick, std::span<const ServoDrive> drives);
  bool take_until(Cycles at, std::span<const ServoDrive> drives, Shafts& shafts);
  [[nodiscard]] ElectronicGear gear_of(const ServoDrive& drive, std::size_t axis) const;
  void make_step(Cycles now, std::uint8_t axes, Mechanics& mechanics, Shafts& shafts);
  void find_positions(std::span<const ServoDrive> drives, const Shafts& shafts);
  [[nodiscard]] bool are_moving(const Shafts& shafts);

  // The pulses of the tick: its edges from here on.
  Cycles begins_{};
  AxisNumbers first_, window_, edges_, rounding_, per_two_windows_;
  AxisNumbers taken_;             // without the sign
  AxisNumbers counts_per_pulse_;  // with the sign
  PerAxis<bool> count_is_negative_{};
  AxisIntegers begin_;       // references at the start of the tick [subcounts], of plain gears
  bool plain_gears_ = true;  // a pulse is a count

  MotorDemands demands_;
  std::array<Step, kMaxSteps> steps_;
  std::size_t size_ = 0;
  std::uint8_t moved_ = 0;
  std::size_t mover_ = 0;  // an axis that was moving
  Extremes extremes_;
};

}  // namespace armature::cosim
