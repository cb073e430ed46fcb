// The pins of the arm that the blocks with pulse generators sample. One bit per axis, axis 1 is bit 0.
#pragma once

#include <cstdint>

namespace armature::cosim::model {

// Levels before an edge.
struct PulseInputs {
  bool trigger = false;
  bool estop_n = true;
  std::uint8_t home = 0, limit_pos = 0, limit_neg = 0, drive_alarm = 0, in_position = 0;

  friend bool operator==(const PulseInputs&, const PulseInputs&) = default;
};

// What they synchronise.
struct ArmPins {
  std::uint8_t home = 0, limit_pos = 0, limit_neg = 0, drive_alarm = 0, in_position = 0;
  bool estop = false;  // the emergency-stop pin is low

  friend bool operator==(const ArmPins&, const ArmPins&) = default;
};

[[nodiscard]] inline ArmPins arm_pins(const PulseInputs& in) {
  return {in.home, in.limit_pos, in.limit_neg, in.drive_alarm, in.in_position, !in.estop_n};
}

}  // namespace armature::cosim::model
