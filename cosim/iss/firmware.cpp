#include "cosim/iss/firmware.hpp"

extern "C" {
extern const std::uint8_t kArmatureFirmwareBegin[];  // firmware.S
extern const std::uint8_t kArmatureFirmwareEnd[];
}

namespace armature::cosim::iss {

std::span<const std::uint8_t> firmware() {
  return {kArmatureFirmwareBegin, kArmatureFirmwareEnd};
}

}  // namespace armature::cosim::iss
