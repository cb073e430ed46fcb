// A finished plan of either kind: what core 1 hands to core 0.
#pragma once

#include <cstddef>
#include <variant>

#include "controller/core/units.hpp"
#include "controller/trajectory/cartesian_plan.hpp"
#include "controller/trajectory/joint_move.hpp"

namespace armature {

using MotionPlan = std::variant<JointPlan, CartesianPlan>;

[[nodiscard]] inline Ticks duration(const MotionPlan& plan) noexcept {
  return std::visit([](const auto& kind) { return kind.duration; }, plan);
}

// Where the plan ends.
[[nodiscard]] inline const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept {
  const auto* cartesian = std::get_if<CartesianPlan>(&plan);
  return cartesian != nullptr ? cartesian->target : std::get_if<JointPlan>(&plan)->target;
}

// Moves that were planned together: the segments of a Cartesian plan, or one.
[[nodiscard]] inline std::size_t moves_in(const MotionPlan& plan) noexcept {
  const auto* cartesian = std::get_if<CartesianPlan>(&plan);
  return cartesian != nullptr ? cartesian->count : 1;
}

// When a move of the plan begins and ends, from the start of the plan.
struct MoveSpan {
  Ticks start{};
  Ticks end{};
};
[[nodiscard]] inline MoveSpan span_of(const MotionPlan& plan, std::size_t move) noexcept {
  const auto* cartesian = std::get_if<CartesianPlan>(&plan);
  if (cartesian == nullptr) return {.end = duration(plan)};
  const CartesianSegment& segment = cartesian->segments[move];
  return {.start = segment.start, .end = segment.start + segment.duration};
}

}  // namespace armature
