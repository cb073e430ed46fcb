// The motion of a whole tick without its single edges ("closed form"): the pulses that leave the logic in a tick, and
// the lines of the encoders.
//
// Times are clock edges of the logic. A tick begins at the edge that sees the trigger.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"

namespace armature::cosim {

// The pulses of one axis in a tick of the default variant (rtl/pulse_train/README.md): from the edge `first` on, step
// changes at the edges first + ceil(k W / 2n), k = 1 .. 2n. It rises with odd k, and falls for the last time at
// first + W, where the next tick begins.
struct AxisPulses {
  std::int32_t count = 0;   // n, signed by the direction
  Cycles first{};           // later than the start of the tick if the axis was blocked by a reversal
  std::int32_t window = 0;  // W
  Cycles fell{};            // the latest falling edge before it
  Cycles turned{};          // the latest change of the direction before its first pulse

  [[nodiscard]] std::int32_t pulses() const { return count < 0 ? -count : count; }

  // The first rising edge, of at least one.
  [[nodiscard]] Cycles first_rise() const { return first + Cycles{(window - 1) / (2 * pulses()) + 1}; }
  // Number of rising edges up to the edge `at`.
  [[nodiscard]] std::int32_t rises_until(Cycles at) const {
    const std::int64_t elapsed = (at - first).value();
    if (count == 0 || elapsed <= 0) return 0;
    if (elapsed >= window) return pulses();
    // The changes with ceil(k W / 2n) <= elapsed.
    const auto changes = static_cast<std::int32_t>(elapsed) * 2 * pulses() / window;
    return (changes + 1) / 2;
  }
};

struct TickPulses {
  Cycles begins{};  // the edge that sees the trigger
  Cycles ends{};    // the edge that would see the next trigger
  PerAxis<AxisPulses> axes{};
};

// Levels of the encoder lines, one bit per axis.
struct EncoderLines {
  std::uint8_t a = 0, b = 0, z = 0;

  friend bool operator==(const EncoderLines&, const EncoderLines&) = default;
};

// The lines of the last edges: what a decoder needs in order to continue from there.
struct LineHistory {
  struct Change {
    Cycles at{};  // the lines have these levels after this edge
    EncoderLines lines{};
  };

  Cycles from{};
  EncoderLines lines{};           // at `from`
  PerAxis<Counts> counts{};       // of the encoders at `from`
  PerAxis<Cycles> counted{};      // edge of the latest count at or before `from`; 0: not known
  std::vector<Change> changes{};  // after `from`, in order
};

}  // namespace armature::cosim
