// Why a move was refused, in words and with the numbers that belong to the reason.
#pragma once

#include <string>

#include "controller/message/move_refused.hpp"

namespace armature::cosim {

// The text begins with the reason as [expect] names it:
//   `outside_limits, axis 2: target 200 deg is beyond 165 deg`
//   `outside_limits, axis 4 at 50 % of the path: 190.3 deg is beyond 190 deg`
//   `unreachable by up to 12.3 mm from 87 % of the path on`
//   `singular: joint 4 would need 45 times the time at 51 % of the path: wrist singularity`
[[nodiscard]] std::string refusal_text(const MoveRefused& refusal);

}  // namespace armature::cosim
