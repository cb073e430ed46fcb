// Four encoder counts per line: the resolution that drive, motor and encoder of an axis share.
#pragma once

#include <cstdint>

#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// Encoder counts of one revolution of the motor.
[[nodiscard]] constexpr std::int32_t counts_per_rev(const AxisSpec& axis) {
  return 4 * axis.encoder_lines;
}

}  // namespace armature::cosim
