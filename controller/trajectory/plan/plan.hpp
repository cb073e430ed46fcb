// What core 0 executes as one motion from rest to rest, or what continues that.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/plan/piece.hpp"

namespace armature {

// A joint move, or a path and chains of joint moves in turn. Each piece begins in the state of motion in which the one
// before ends.
struct Plan {
  static constexpr std::size_t kMaxPieces = 3;
  // Moves of a plan of several pieces.
  static constexpr std::size_t kMaxMoves = CartesianPlan::kMaxFirstSegments;

  std::array<Piece, kMaxPieces> pieces{};
  std::size_t count = 0;

  Plan() = default;  // empty, takes no time
  explicit Plan(const Piece& only) noexcept { add(only); }

  // Adds a piece, which is executed from `from` on; `in_motion`: it begins so.
  void add(Piece piece, Ticks from = {}, bool in_motion = false) noexcept;
  [[nodiscard]] Piece& last() noexcept { return pieces[count - 1]; }
  [[nodiscard]] const Piece& last() const noexcept { return pieces[count - 1]; }
  [[nodiscard]] std::span<const Piece> view() const noexcept { return {pieces.data(), count}; }

  // The path, if the plan is one.
  [[nodiscard]] const CartesianPlan* only_path() const noexcept { return count == 1 ? pieces[0].path : nullptr; }
  // The last piece that has begun at this time, ticks.
  [[nodiscard]] const Piece& piece_at(double ticks) const noexcept;
  // The piece with this move.
  [[nodiscard]] const Piece& piece_with(std::size_t move) const noexcept;
  // Number of PieceStores that the pieces need: neighbours are of different kinds and share one.
  [[nodiscard]] std::size_t stores() const noexcept { return (count + 1) / 2; }
};

[[nodiscard]] Ticks duration(const Plan& plan) noexcept;

// Where the plan ends.
[[nodiscard]] const PerAxis<Radians>& target_of(const Plan& plan) noexcept;

// When its outputs are switched; those of several pieces have none.
[[nodiscard]] std::span<const TimedOutput> outputs_of(const Plan& plan) noexcept;

[[nodiscard]] inline bool is_dwell(const Plan& plan) noexcept {
  return plan.pieces[0].joints != nullptr && plan.pieces[0].joints->is_dwell;
}

// Number of moves in the plan: the segments of paths and the moves of joint chains, otherwise one.
[[nodiscard]] std::size_t moves_in(const Plan& plan) noexcept;

// Begin and end of a move, from the start of the plan.
struct MoveSpan {
  Ticks start{};
  Ticks end{};
};
[[nodiscard]] MoveSpan span_of(const Plan& plan, std::size_t move) noexcept;

}  // namespace armature
