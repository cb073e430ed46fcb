// Why a move was refused, in words and with the numbers that belong to the reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "controller/event/move_refused.hpp"

namespace armature::cosim {

// Beginning with the reason as [expect] names it:
//   `outside_limits, axis 2`
//   `unreachable by up to 12.3 mm from 87 % of the path on`
//   `singular: joint 4 would need 45 times the time at 51 % of the path: wrist singularity`
[[nodiscard]] std::string refusal_text(const MoveRefused& refusal);

// `wrist`, `shoulder`, `elbow` of a mask of Singularity.
[[nodiscard]] std::vector<std::string_view> singularity_names(std::uint8_t mask);

// Nothing is wrong with the command itself: what happened around it kept it from being carried out.
[[nodiscard]] constexpr bool is_drop(Refusal reason) {
  return reason == Refusal::kNotReady || reason == Refusal::kInputTimeout;
}

}  // namespace armature::cosim
