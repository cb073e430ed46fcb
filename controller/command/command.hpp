// The vocabulary of everything that can be asked of the controller; a command carries no text and no units to parse.
#pragma once

#include <variant>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"

namespace armature {

// Moves all joints so that they start and stop together.
struct JointMove {
  PerAxis<Radians> target{};  // absolute joint angles
  double speed = 1.0;         // scale of the speed limits, (0, 1]
};

// Decelerates along the path with the axes' acceleration limits, drops queued moves, ends in Idle.
struct Stop {};

// Leaves Fault when its cause is gone: clears the latches of the logic, enables the drives, takes the present encoder
// position as the new reference.
struct ClearFault {};

using Command = std::variant<JointMove, Stop, ClearFault>;

}  // namespace armature
