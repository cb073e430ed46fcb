// The events of the moves of a plan.
#pragma once

#include <cstddef>

#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/message/move_refused.hpp"
#include "controller/message/move_started.hpp"
#include "controller/trajectory/plan/plan.hpp"

namespace armature {

// Below, `index` is a move of the plan, 0..moves_in(plan) - 1.

[[nodiscard]] Tag tag_of(const Plan& plan, std::size_t index) noexcept;

// The event of a move whose first step is in tick `start`.
[[nodiscard]] MoveStarted started(const Plan& plan, std::size_t index, Ticks start) noexcept;

// The event of a move that is dropped before it starts.
[[nodiscard]] MoveRefused dropped(const Plan& plan, std::size_t index, Refusal reason) noexcept;

}  // namespace armature
