// A piece of a plan, and the memory for what it names.
#pragma once

#include <cstddef>

#include "controller/base/units.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"
#include "controller/trajectory/joint/joint_move.hpp"

namespace armature {

// Names a joint move, a chain of joint moves or a path of the tool, which must stay as long as the piece and its
// copies. It is executed from `from` to `until` of its own time.
struct Piece {
  const JointPlan* joints = nullptr;  // exactly one of these three
  const JointChain* chain = nullptr;
  const CartesianPlan* path = nullptr;
  Ticks start{};  // from the start of the plan
  Ticks from{}, until{};
  std::size_t first_move = 0;  // its number in the plan
  bool in_motion = false;      // at its start

  Piece() = default;  // names nothing
  explicit Piece(const JointPlan& whole) noexcept : joints{&whole}, until{whole.duration} {}
  explicit Piece(const JointChain& whole) noexcept : chain{&whole}, until{whole.duration} {}
  explicit Piece(const CartesianPlan& whole) noexcept : path{&whole}, until{whole.duration} {}

  // What it names, as an argument of `visitor`.
  template <class Visitor>
  decltype(auto) visit(Visitor visitor) const noexcept {
    if (path != nullptr) return visitor(*path);
    if (chain != nullptr) return visitor(*chain);
    return visitor(*joints);
  }

  [[nodiscard]] Ticks end() const noexcept { return start + (until - from); }
  // Its own time at a time of the plan.
  [[nodiscard]] double own_ticks(double ticks) const noexcept {
    return ticks - static_cast<double>(start.value()) + static_cast<double>(from.value());
  }
};

// Room for one of each kind. Assignments copy only what there is.
struct PieceStore {
  JointPlan joints{};
  JointChain chain{};
  CartesianPlan path{};

  [[nodiscard]] Piece keep(const JointPlan& whole) noexcept { return Piece{joints = whole}; }
  [[nodiscard]] Piece keep(const JointChain& whole) noexcept { return Piece{chain = whole}; }
  [[nodiscard]] Piece keep(const CartesianPlan& whole) noexcept { return Piece{path = whole}; }
};

}  // namespace armature
