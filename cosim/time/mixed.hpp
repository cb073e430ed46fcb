// A step of a hash of 64 bits.
#pragma once

#include <cstdint>

namespace armature::cosim {

// For one hash, different values give different results; for one value, different hashes do.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  const std::uint64_t product = (hash ^ value) * 0x9E37'79B9'7F4A'7C15;
  return product ^ (product >> 32);
}

}  // namespace armature::cosim
