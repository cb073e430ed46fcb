// The responses of AXI4-Lite (BRESP, RRESP).
#pragma once

#include <cstdint>

namespace armature::cosim::model {

inline constexpr std::uint8_t kOkay = 0b00, kSlaveError = 0b10, kDecodeError = 0b11;

}  // namespace armature::cosim::model
