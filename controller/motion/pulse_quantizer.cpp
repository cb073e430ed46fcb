#include "controller/motion/pulse_quantizer.hpp"

#include <algorithm>

namespace armature {

void PulseQuantizer::restart(Pulses committed, Pulses position) noexcept {
  committed_ = committed;
  origin_ = committed - position;
}

Pulses PulseQuantizer::next(Pulses target) noexcept {
  const Pulses count = std::clamp(target + origin_ - committed_, -max_per_tick_, max_per_tick_);
  committed_ += count;
  return count;
}

}  // namespace armature
