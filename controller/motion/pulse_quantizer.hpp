// Converts absolute pulse positions into the counts of one tick without losing pulses: the correction of Vo 2021 eq.
// (23), whose printed form drops the remainder of every tick.
#pragma once

#include <algorithm>

#include "controller/base/units.hpp"

namespace armature {

class PulseQuantizer {
 public:
  // At most `max_per_tick` pulses in either direction in a tick.
  explicit PulseQuantizer(Pulses max_per_tick) noexcept : max_per_tick_{max_per_tick} {}

  // From now on pulse position `position` corresponds to `committed` pulses.
  void restart(Pulses committed, Pulses position) noexcept {
    committed_ = committed;
    origin_ = committed - position;
  }

  // The count that brings the axis from its commanded position to `target`, as far as one tick allows; later calls emit
  // the rest. The count is added to committed().
  [[nodiscard]] Pulses next(Pulses target) noexcept {
    const Pulses count = std::clamp(target + origin_ - committed_, -max_per_tick_, max_per_tick_);
    committed_ += count;
    return count;
  }

  // `count` of the committed pulses were not emitted; next() sends them again.
  void not_emitted(Pulses count) noexcept { committed_ -= count; }

  // Sum of all counts, less those not emitted.
  [[nodiscard]] Pulses committed() const noexcept { return committed_; }

 private:
  Pulses max_per_tick_;
  Pulses committed_{};
  Pulses origin_{};  // committed minus position, constant between restarts
};

}  // namespace armature
