// A finished plan of any kind, which core 1 sends to core 0.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/core/units.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_move.hpp"
#include "controller/trajectory/plan/joint_retarget.hpp"

namespace armature {

// Contains one of all kinds, with room for all. So an assignment of a plan of another kind only copies that plan. A
// variant would first initialise the 60 KB of an empty path.
class MotionPlan {
 public:
  MotionPlan() = default;                                                                     // empty, takes no time
  MotionPlan(const JointPlan& plan) noexcept : joint_{plan} {}                                // NOLINT: implicit
  MotionPlan(const RetargetPlan& plan) noexcept : kind_{Kind::kRetarget}, retarget_{plan} {}  // NOLINT: on purpose
  MotionPlan(const CartesianPlan& plan) noexcept : kind_{Kind::kPath}, path_{plan} {}         // NOLINT
  MotionPlan(const MotionPlan& other) noexcept { *this = other; }
  MotionPlan& operator=(const MotionPlan& other) noexcept {
    kind_ = other.kind_;
    if (kind_ == Kind::kJoint) joint_ = other.joint_;
    if (kind_ == Kind::kRetarget) retarget_ = other.retarget_;
    if (kind_ == Kind::kPath) path_ = other.path_;
    return *this;
  }
  // Without an empty plan of every other kind in between.
  MotionPlan& operator=(const RetargetPlan& plan) noexcept {
    kind_ = Kind::kRetarget;
    retarget_ = plan;
    return *this;
  }

  // The plan if it is of that kind, otherwise null.
  [[nodiscard]] const JointPlan* joint() const noexcept { return kind_ == Kind::kJoint ? &joint_ : nullptr; }
  [[nodiscard]] const RetargetPlan* retarget() const noexcept {
    return kind_ == Kind::kRetarget ? &retarget_ : nullptr;
  }
  [[nodiscard]] const CartesianPlan* path() const noexcept { return kind_ == Kind::kPath ? &path_ : nullptr; }

 private:
  enum class Kind : std::uint8_t { kJoint, kRetarget, kPath };

  Kind kind_ = Kind::kJoint;
  JointPlan joint_{};
  CartesianPlan path_{};
  RetargetPlan retarget_{};
};

// visit(plan) with the plan of the kind that it has.
template <class Visit>
decltype(auto) visit_plan(const MotionPlan& plan, Visit visit) {
  if (const CartesianPlan* path = plan.path()) return visit(*path);
  if (const RetargetPlan* retarget = plan.retarget()) return visit(*retarget);
  return visit(*plan.joint());
}

[[nodiscard]] inline Ticks duration(const MotionPlan& plan) noexcept {
  return visit_plan(plan, [](const auto& any) { return any.duration; });
}

// Where the plan ends.
[[nodiscard]] inline const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept {
  return visit_plan(plan, [](const auto& any) -> const PerAxis<Radians>& { return any.target; });
}

// Number of moves in the plan: the segments of a Cartesian plan, otherwise one.
[[nodiscard]] inline std::size_t moves_in(const MotionPlan& plan) noexcept {
  const CartesianPlan* path = plan.path();
  return path != nullptr ? path->count : 1;
}

// Begin and end of a move, from the start of the plan.
struct MoveSpan {
  Ticks start{};
  Ticks end{};
};
[[nodiscard]] inline MoveSpan span_of(const MotionPlan& plan, std::size_t move) noexcept {
  const CartesianPlan* path = plan.path();
  if (path == nullptr) return {.end = duration(plan)};
  const CartesianSegment& segment = path->segments[move];
  return {.start = segment.start, .end = end_of(segment)};
}

}  // namespace armature
