// The only conversion between joint angles, drive pulses and encoder counts of an axis.
//
// All three have the same zero. A negative gear ratio reverses the sign between the joint and the motor. Pulses and
// counts are both on the motor side and share their sign.
#pragma once

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class AxisUnits {
 public:
  explicit AxisUnits(const AxisModel& model) noexcept;

  // Vo 2021 eq. (23) as P = round_half_away(q / resolution) of the absolute angle. The printed form truncates the
  // difference of every tick and so loses pulses.
  [[nodiscard]] Pulses to_pulses(Radians joint) const noexcept {
    return Pulses{round_half_away(to_exact_pulses(joint))};
  }
  // The same before rounding.
  [[nodiscard]] double to_exact_pulses(Radians joint) const noexcept { return joint.value() / rad_per_pulse_; }

  [[nodiscard]] Radians to_radians(Counts counts) const noexcept {
    return Radians{static_cast<double>(counts.value()) * rad_per_count_};
  }
  [[nodiscard]] double to_exact_pulses(Counts counts) const noexcept {
    return static_cast<double>(counts.value()) * pulses_per_count_;
  }

  // Rounded to the nearest count.
  [[nodiscard]] Counts to_counts(Pulses pulses) const noexcept;
  [[nodiscard]] Counts to_counts(Radians joint) const noexcept;

  // Joint angle of one pulse, with the sign of the gear ratio: the resolution of Vo 2021 eq. (23).
  [[nodiscard]] double rad_per_pulse() const noexcept { return rad_per_pulse_; }
  [[nodiscard]] double pulses_per_count() const noexcept { return pulses_per_count_; }

  // The axis' speed limit, joint side: the model's, or that of the pulse generators if lower.
  [[nodiscard]] double max_speed_rad_s() const noexcept { return max_speed_rad_s_; }
  // The speed limit as pulses per tick, 0..kMaxPulsesPerTick, and the axis' acceleration limit [pulses/tick^2].
  [[nodiscard]] double max_pulses_per_tick() const noexcept { return max_pulses_per_tick_; }
  [[nodiscard]] double max_pulses_per_tick2() const noexcept { return max_pulses_per_tick2_; }

 private:
  double rad_per_pulse_;
  double rad_per_count_;
  double pulses_per_count_;
  double max_speed_rad_s_;
  double max_pulses_per_tick_;
  double max_pulses_per_tick2_;
};

}  // namespace armature
