// A finished plan of either kind, which core 1 sends to core 0.
#pragma once

#include <cstddef>

#include "controller/core/units.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

// Contains one of both kinds, with room for both. So an assignment of a plan of another kind only copies that plan. A
// variant would first initialise the 60 KB of an empty path.
class MotionPlan {
 public:
  MotionPlan() = default;                                                          // an empty joint plan, takes no time
  MotionPlan(const JointPlan& plan) noexcept : joint_{plan} {}                     // NOLINT: implicit on purpose
  MotionPlan(const CartesianPlan& plan) noexcept : is_path_{true}, path_{plan} {}  // NOLINT: implicit on purpose
  MotionPlan(const MotionPlan& other) noexcept { *this = other; }
  MotionPlan& operator=(const MotionPlan& other) noexcept {
    is_path_ = other.is_path_;
    if (is_path_) {
      path_ = other.path_;
    } else {
      joint_ = other.joint_;
    }
    return *this;
  }

  // The plan if it is of that kind, otherwise null.
  [[nodiscard]] const JointPlan* joint() const noexcept { return is_path_ ? nullptr : &joint_; }
  [[nodiscard]] const CartesianPlan* path() const noexcept { return is_path_ ? &path_ : nullptr; }

 private:
  bool is_path_ = false;
  JointPlan joint_{};
  CartesianPlan path_{};
};

[[nodiscard]] inline Ticks duration(const MotionPlan& plan) noexcept {
  const CartesianPlan* path = plan.path();
  return path != nullptr ? path->duration : plan.joint()->duration;
}

// Where the plan ends.
[[nodiscard]] inline const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept {
  const CartesianPlan* path = plan.path();
  return path != nullptr ? path->target : plan.joint()->target;
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
