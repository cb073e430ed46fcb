// Seconds of simulated time and clock cycles of the logic.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/core/timebase.hpp"
#include "controller/core/units.hpp"

namespace armature::cosim {

inline constexpr std::int64_t kTickCycles = armature::kTickCycles.value();

// Nearest clock cycle; exact for any time a scenario may name.
inline Cycles to_cycles(double seconds) {
  return Cycles{static_cast<std::int64_t>(std::floor(seconds * static_cast<double>(kClkFreqHz) + 0.5))};
}

inline double to_seconds(Cycles cycles) {
  return static_cast<double>(cycles.value()) / static_cast<double>(kClkFreqHz);
}

}  // namespace armature::cosim
