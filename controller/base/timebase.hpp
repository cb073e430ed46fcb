// The control period, derived from the clock of the programmable logic, and constants that depend on it. The drivers
// assert that the clock equals rtl/soc/soc_map.toml.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"

namespace armature {

inline constexpr std::int64_t kClkFreqHz = 50'000'000;
inline constexpr std::int64_t kNsPerCycle = 1'000'000'000 / kClkFreqHz;
inline constexpr Cycles kTickCycles{2'500};
static_assert(kTickCycles.value() * kNsPerCycle == 50'000, "a tick is 50 us");

inline constexpr double kTickSeconds = static_cast<double>(kTickCycles.value()) / static_cast<double>(kClkFreqHz);

[[nodiscard]] constexpr double seconds(Ticks ticks) noexcept {
  return static_cast<double>(ticks.value()) * kTickSeconds;
}

// The largest count that a pulse generator can emit in one tick: 4 Mpps. A larger committed count is clipped.
inline constexpr std::int64_t kMaxPulsesPerTick = 200;

}  // namespace armature
