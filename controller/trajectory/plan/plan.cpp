#include "controller/trajectory/plan/plan.hpp"

#include <algorithm>
#include <cassert>

namespace armature {
namespace {

std::size_t moves_in(const JointPlan&) {
  return 1;
}
std::size_t moves_in(const JointChain& chain) {
  return chain.count;
}
std::size_t moves_in(const CartesianPlan& path) {
  return path.count;
}

MoveSpan span_of(const JointPlan& joints, std::size_t) {
  return {.end = joints.duration};
}
MoveSpan span_of(const JointChain& chain, std::size_t move) {
  return {.start = chain.starts[move], .end = chain.end_of(move)};
}
MoveSpan span_of(const CartesianPlan& path, std::size_t segment) {
  return {.start = path.segments[segment].start, .end = end_of(path.segments[segment])};
}

}  // namespace

void Plan::add(Piece piece, Ticks from, bool in_motion) noexcept {
  assert(count == 0 || (count < kMaxPieces && (piece.path == nullptr) != (last().path == nullptr)));
  piece.start = duration(*this);
  piece.first_move = moves_in(*this);
  piece.from = from;
  piece.in_motion = in_motion;
  pieces[count++] = piece;
}

const Piece& Plan::piece_at(double ticks) const noexcept {
  std::size_t index = count - 1;
  while (index > 0 && static_cast<double>(pieces[index].start.value()) > ticks) --index;
  return pieces[index];
}

const Piece& Plan::piece_with(std::size_t move) const noexcept {
  std::size_t index = count - 1;
  while (pieces[index].first_move > move) --index;
  return pieces[index];
}

Ticks duration(const Plan& plan) noexcept {
  return plan.count > 0 ? plan.last().end() : Ticks{};
}

const PerAxis<Radians>& target_of(const Plan& plan) noexcept {
  return plan.last().visit([](const auto& whole) -> const PerAxis<Radians>& { return whole.target; });
}

std::span<const TimedOutput> outputs_of(const Plan& plan) noexcept {
  if (plan.count != 1) return {};
  return plan.last().visit([](const auto& whole) { return whole.outputs.view(); });
}

std::size_t moves_in(const Plan& plan) noexcept {
  if (plan.count == 0) return 0;
  return plan.last().first_move + plan.last().visit([](const auto& whole) { return moves_in(whole); });
}

MoveSpan span_of(const Plan& plan, std::size_t move) noexcept {
  const Piece& piece = plan.piece_with(move);
  const MoveSpan own = piece.visit([&](const auto& whole) { return span_of(whole, move - piece.first_move); });
  if (plan.count == 1) return own;  // segments of a window start before the plan does
  const auto in_plan = [&piece](Ticks ticks) {
    return piece.start + (std::clamp(ticks, piece.from, piece.until) - piece.from);
  };
  return {.start = in_plan(own.start), .end = in_plan(own.end)};
}

}  // namespace armature
