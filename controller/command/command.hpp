// The vocabulary of everything that can be asked of the controller; a command carries no text and no units to parse.
#pragma once

#include <variant>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"

namespace armature {

// Moves all joints so that they start and stop together.
struct JointMove {
  PerAxis<Radians> target{};  // absolute joint angles
  double speed = 1.0;         // scale of the speed limits, (0, 1]; too slow when the move would take more than 24 h
};

// Decelerates along the path with the axes' acceleration limits, drops queued moves (each is reported as refused), ends
// in Idle. In Fault the arm stands anyway.
struct Stop {};

// Leaves Fault when its cause is gone: clears the latches of the logic, enables the drives, takes the present encoder
// position as the new reference. Reported as refused, and without effect, while the cause is there, the arm still moves
// or the hardware is not the controller's own. Outside Fault there is nothing to clear: it does nothing, silently; so
// does a second one before the first is answered.
struct ClearFault {};

using Command = std::variant<JointMove, Stop, ClearFault>;

}  // namespace armature
