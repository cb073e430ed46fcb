// Whether a stop can explain the pulses of a tick.
#pragma once

#include <cstdint>

namespace armature::cosim {

// Whether `emitted` has the direction of `committed` and at most as many pulses.
[[nodiscard]] constexpr bool is_short_of(std::int32_t emitted, std::int32_t committed) {
  return committed >= 0 ? emitted >= 0 && emitted <= committed : emitted <= 0 && emitted >= committed;
}

}  // namespace armature::cosim
