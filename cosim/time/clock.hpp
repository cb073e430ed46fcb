// Seconds of simulated time and clock cycles of the logic.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"

namespace armature::cosim {

inline constexpr std::int64_t kTickCycles = armature::kTickCycles.value();

// Nearest clock cycle; exact for every time that a scenario may contain.
inline Cycles to_cycles(double seconds) {
  return Cycles{static_cast<std::int64_t>(std::floor(seconds * static_cast<double>(kClkFreqHz) + 0.5))};
}

inline double to_seconds(Cycles cycles) {
  return static_cast<double>(cycles.value()) / static_cast<double>(kClkFreqHz);
}

// Exact text with eight digits after the point, for files. A cycle is a whole multiple of the last digit.
inline std::string seconds_text(Cycles cycles) {
  constexpr std::int64_t kUnitsPerSecond = 100'000'000;
  constexpr std::int64_t kUnitsPerCycle = kUnitsPerSecond / kClkFreqHz;
  static_assert(kUnitsPerCycle * kClkFreqHz == kUnitsPerSecond);
  const std::int64_t units = cycles.value() * kUnitsPerCycle;
  return fmt::format("{}.{:08}", units / kUnitsPerSecond, units % kUnitsPerSecond);
}

}  // namespace armature::cosim
