#include "controller/robot/axis_units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"

namespace armature {

AxisUnits::AxisUnits(const AxisModel& model) noexcept
    : rad_per_pulse_{2.0 * std::numbers::pi / (model.gear_ratio * model.pulses_per_rev)},
      rad_per_count_{2.0 * std::numbers::pi / (model.gear_ratio * model.counts_per_rev)},
      pulses_per_count_{static_cast<double>(model.pulses_per_rev) / model.counts_per_rev} {
  const double resolution = std::fabs(rad_per_pulse_);
  const double fastest_rad_s = static_cast<double>(kMaxPulsesPerTick) * resolution / kTickSeconds;
  max_speed_rad_s_ = std::min(model.max_speed_rad_s, fastest_rad_s);
  max_pulses_per_tick_ =
      std::min(model.max_speed_rad_s * kTickSeconds / resolution, static_cast<double>(kMaxPulsesPerTick));
  max_pulses_per_tick2_ = model.max_accel_rad_s2 * kTickSeconds * kTickSeconds / resolution;
}

Counts AxisUnits::to_counts(Radians joint) const noexcept {
  return Counts{round_half_away(joint.value() / rad_per_count_)};
}

Counts AxisUnits::to_counts(Pulses pulses) const noexcept {
  return Counts{round_half_away(static_cast<double>(pulses.value()) / pulses_per_count_)};
}

}  // namespace armature
