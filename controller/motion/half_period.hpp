// The relation of half periods and pulses per tick, for the generators of Vo 2021 (Figure 6), which are written a pulse
// width instead of a count.
//
// The trigger restarts the generator with step low. Step toggles every `width` cycles, and the next trigger ends a
// pulse that is still high. A tick of T cycles has floor((T - 1) / width) toggles, and so ceil(toggles / 2) pulses
// (rtl/pulse_width). Only 64 of the counts 1..200 can be emitted so, and fewer with pulses that a drive accepts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"

namespace armature {

// The shortest half period at which no tick emits more than kMaxPulsesPerTick pulses.
inline constexpr std::int64_t kMinHalfPeriod =
    (kTickCycles.value() + 2 * kMaxPulsesPerTick - 1) / (2 * kMaxPulsesPerTick);
static_assert(kMinHalfPeriod == 7, "3.57 MHz within a tick; 6 cycles would be 4.17 MHz");

// Number of pulses that a tick emits with this half period [cycles], with its sign; 0 emits none.
[[nodiscard]] constexpr Pulses pulses_of_width(Cycles width) noexcept {
  const std::int64_t magnitude = width.value() < 0 ? -width.value() : width.value();
  if (magnitude == 0) return Pulses{0};
  const std::int64_t count = ((kTickCycles.value() - 1) / magnitude + 1) / 2;
  return Pulses{width.value() < 0 ? -count : count};
}

// The state of the step line at the end of a tick with this half period, which is at least 1 cycle and shorter than a
// tick.
struct TickEnd {
  Cycles last_high;  // length of the last pulse; shorter than the half period when the trigger ends it
  Cycles low_since;  // time from its falling edge to the trigger; 0: the trigger makes the edge
};
[[nodiscard]] constexpr TickEnd tick_end(Cycles width) noexcept {
  const std::int64_t toggles = (kTickCycles.value() - 1) / width.value();
  const Cycles rest{kTickCycles.value() - toggles * width.value()};
  return toggles % 2 == 0 ? TickEnd{width, rest} : TickEnd{rest, Cycles{0}};
}

// Requirements of a drive on its pulses, in cycles. The defaults are those of the paper: none.
struct HalfPeriodLimits {
  Cycles min_width{kMinHalfPeriod};  // never below kMinHalfPeriod
  Cycles min_high{1};                // also for the last pulse of a tick, which the trigger may shorten
  Cycles dir_hold{0};                // shortest time from a falling edge to a change of direction
};

// The best half period for every count 0..kMaxPulsesPerTick.
//
// It emits the nearest count that an allowed half period can emit; of two equally near ones the smaller. Above the
// largest reachable count (179 without limits) it emits that one, and the missing pulses are emitted in later ticks. Of
// several half periods with the same count, one that allows a change of direction at the trigger is preferred, then the
// one nearest to the even spacing kTickCycles / (2 count).
class HalfPeriodTable {
 public:
  constexpr explicit HalfPeriodTable(const HalfPeriodLimits& limits) noexcept {
    std::array<std::int32_t, kSize> exact{};  // the best half period of each count; 0: none
    const std::int64_t shortest = std::max(limits.min_width.value(), kMinHalfPeriod);
    for (std::int64_t width = shortest; width < kTickCycles.value(); ++width) {
      const TickEnd end = tick_end(Cycles{width});
      if (end.last_high < limits.min_high) continue;
      const auto count = static_cast<std::size_t>(pulses_of_width(Cycles{width}).value());
      if (exact[count] == 0 || better(width, exact[count], count, limits.dir_hold)) {
        exact[count] = static_cast<std::int32_t>(width);
      }
    }
    std::size_t below = 0;  // the largest reachable count up to n
    for (std::size_t n = 0; n < kSize; ++n) {
      if (exact[n] != 0) below = n;
      std::size_t above = n;
      while (above < kSize && exact[above] == 0) ++above;
      const bool take_above = above < kSize && above - n < n - below;
      widths_[n] = exact[take_above ? above : below];
    }
  }

  // The signed half period for a count; beyond +-kMaxPulsesPerTick that of the limit.
  [[nodiscard]] constexpr Cycles width(Pulses wanted) const noexcept {
    const std::int64_t count = std::clamp(wanted.value(), -kMaxPulsesPerTick, kMaxPulsesPerTick);
    const std::int64_t magnitude = widths_[static_cast<std::size_t>(count < 0 ? -count : count)];
    return Cycles{count < 0 ? -magnitude : magnitude};
  }

 private:
  static constexpr std::size_t kSize = static_cast<std::size_t>(kMaxPulsesPerTick) + 1;

  static constexpr std::int64_t unevenness(std::int64_t width, std::size_t count) {
    const std::int64_t off = 2 * static_cast<std::int64_t>(count) * width - kTickCycles.value();
    return off < 0 ? -off : off;
  }
  static constexpr bool better(std::int64_t width, std::int64_t than, std::size_t count, Cycles hold) {
    const bool free = tick_end(Cycles{width}).low_since >= hold;
    const bool other_free = tick_end(Cycles{than}).low_since >= hold;
    if (free != other_free) return free;
    return unevenness(width, count) < unevenness(than, count);
  }

  std::array<std::int32_t, kSize> widths_{};  // [cycles]
};

}  // namespace armature
