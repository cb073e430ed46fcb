// Time in the plant: the clock of the logic, and the integration step of the motors.
#pragma once

#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "cosim/robot/motor_step.hpp"
#include "cosim/time/never.hpp"

namespace armature::cosim {

// Equal to `clk_freq_hz` of rtl/soc/soc_map.toml (a test compares them; the plant itself uses pins only).
inline constexpr std::int64_t kPlantClockHz = kClkFreqHz;

// Motors are integrated on the grid of multiples of this: 5 us, ten steps per 50 us tick.
inline constexpr Cycles kPlantStep{250};
// The first cycle of the grid that is not before `at`, which is not negative.
[[nodiscard]] constexpr Cycles grid_from(Cycles at) {
  const std::int64_t step = kPlantStep.value();
  return Cycles{(at.value() + step - 1) / step * step};
}
inline constexpr double kPlantStepSeconds =
    static_cast<double>(kPlantStep.value()) / static_cast<double>(kPlantClockHz);
static_assert(kPlantStepSeconds == kMotorStepSeconds);

}  // namespace armature::cosim
