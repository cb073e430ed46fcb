// What a solver of the inverse kinematics outside the software has done, as the software that checks it has seen.
#pragma once

#include <cstdint>

namespace armature {

struct InverseCheck {
  bool usable = true;               // false: the logic does not have the solver that this software supports
  std::uint32_t solved = 0;         // poses whose joint angles are those of the solver, since the start
  double difference_pulses = 0.0;   // largest difference of a joint angle from software
  bool differs = false;             // a difference was above the stated error, or the solver gave no answer
  std::uint8_t differing_axis = 0;  // 1..6: the first such axis; 0: no answer
  std::int64_t charged = 0;  // inverse kinematics of the software that it has charged to the core (Work::kInverse)
};

}  // namespace armature
