// What is told about a move when it begins, or is dropped before.
#pragma once

#include <cstddef>

#include "controller/core/units.hpp"
#include "controller/motion/telemetry.hpp"
#include "controller/trajectory/plan/motion_plan.hpp"

namespace armature {

// Move `index` of the plan, 0..moves_in(plan) - 1, which begins in tick `start`.
[[nodiscard]] MoveReport report_of(const MotionPlan& plan, std::size_t index, Ticks start) noexcept;

// The same move when a Stop or a fault drops it.
[[nodiscard]] MoveRefusal dropped(const MotionPlan& plan, std::size_t index) noexcept;

}  // namespace armature
