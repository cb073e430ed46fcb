// A finished plan of any kind, which core 1 sends to core 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/core/units.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_chain.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

// Contains one of all kinds, with room for all. So an assignment of a plan of another kind only copies that plan. A
// variant would first initialise the 300 KB of an empty path.
class MotionPlan {
 public:
  MotionPlan() = default;                                       // empty, takes no time
  MotionPlan(const JointPlan& plan) noexcept : joint_{plan} {}  // NOLINT: implicit on purpose
  MotionPlan(const JointChain& plan) noexcept : kind_{Kind::kJointChain}, chain_{plan} {}  // NOLINT
  MotionPlan(const CartesianPlan& plan) noexcept : kind_{Kind::kPath}, path_{plan} {}      // NOLINT
  MotionPlan(const MotionPlan& other) noexcept { *this = other; }
  MotionPlan& operator=(const MotionPlan& other) noexcept {
    kind_ = other.kind_;
    if (kind_ == Kind::kJoint) joint_ = other.joint_;
    if (kind_ == Kind::kJointChain) chain_ = other.chain_;
    if (kind_ == Kind::kPath) path_ = other.path_;
    return *this;
  }
  // Without an empty plan of every other kind in between, which needs room on the stack.
  MotionPlan& operator=(const JointPlan& plan) noexcept {
    kind_ = Kind::kJoint;
    joint_ = plan;
    return *this;
  }
  MotionPlan& operator=(const JointChain& plan) noexcept {
    kind_ = Kind::kJointChain;
    chain_ = plan;
    return *this;
  }
  // A chain of one move.
  MotionPlan& operator=(const RetargetPlan& plan) noexcept {
    kind_ = Kind::kJointChain;
    chain_ = plan;
    return *this;
  }
  MotionPlan& operator=(const CartesianPlan& plan) noexcept {
    kind_ = Kind::kPath;
    path_ = plan;
    return *this;
  }

  // The plan if it is of that kind, otherwise null.
  [[nodiscard]] const JointPlan* joint() const noexcept { return kind_ == Kind::kJoint ? &joint_ : nullptr; }
  [[nodiscard]] const JointChain* joint_chain() const noexcept {
    return kind_ == Kind::kJointChain ? &chain_ : nullptr;
  }
  [[nodiscard]] const CartesianPlan* path() const noexcept { return kind_ == Kind::kPath ? &path_ : nullptr; }

 private:
  enum class Kind : std::uint8_t { kJoint, kJointChain, kPath };

  Kind kind_ = Kind::kJoint;
  JointPlan joint_{};
  CartesianPlan path_{};
  JointChain chain_{};
};

// visit(plan) with the plan of the kind that it has.
template <class Visit>
decltype(auto) visit_plan(const MotionPlan& plan, Visit visit) {
  if (const CartesianPlan* path = plan.path()) return visit(*path);
  if (const JointChain* chain = plan.joint_chain()) return visit(*chain);
  return visit(*plan.joint());
}

[[nodiscard]] inline Ticks duration(const MotionPlan& plan) noexcept {
  return visit_plan(plan, [](const auto& any) { return any.duration; });
}

// Where the plan ends.
[[nodiscard]] inline const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept {
  return visit_plan(plan, [](const auto& any) -> const PerAxis<Radians>& { return any.target; });
}

// When its outputs are switched.
[[nodiscard]] inline std::span<const TimedOutput> outputs_of(const MotionPlan& plan) noexcept {
  return visit_plan(plan, [](const auto& any) { return any.outputs.view(); });
}

[[nodiscard]] inline bool is_dwell(const MotionPlan& plan) noexcept {
  return plan.joint() != nullptr && plan.joint()->is_dwell;
}

// Number of moves in the plan: the segments of a Cartesian plan, the moves of a joint chain, otherwise one.
[[nodiscard]] inline std::size_t moves_in(const MotionPlan& plan) noexcept {
  if (const CartesianPlan* path = plan.path()) return path->count;
  const JointChain* chain = plan.joint_chain();
  return chain != nullptr ? chain->count : 1;
}

// Begin and end of a move, from the start of the plan.
struct MoveSpan {
  Ticks start{};
  Ticks end{};
};
[[nodiscard]] inline MoveSpan span_of(const MotionPlan& plan, std::size_t move) noexcept {
  if (const JointPlan* joint = plan.joint()) return {.end = joint->duration};
  if (const JointChain* chain = plan.joint_chain()) return {.start = chain->starts[move], .end = chain->end_of(move)};
  const CartesianSegment& segment = plan.path()->segments[move];
  return {.start = segment.start, .end = end_of(segment)};
}

}  // namespace armature
