// Motions of the encoder whose edges are not executed one by one.
#include "cosim/plant/incremental_encoder.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient * b > a ? quotient - 1 : quotient;
}

// The count that the encoder shows `elapsed` cycles after the start of the motion.
Counts count_in(const IncrementalEncoder::Motion& motion, std::int64_t elapsed) {
  if (elapsed >= motion.length.value()) return nearest_count(motion.target);
  const std::int64_t moved = floor_div((motion.target - motion.start).value() * elapsed, motion.length.value());
  return nearest_count(motion.start + Subcounts{moved});
}

}  // namespace

void IncrementalEncoder::move_without_edges(Cycles from, Cycles length, Subcounts target) {
  begin_motion(from, length, target);
  if (nearest_count(start()) == target_count()) return;
  motions_.counted_before = motions_.counted;
  motions_.counted = motions_.present;
}

Counts IncrementalEncoder::count_after(Cycles at) const {
  const Motion &present = motions_.present, &before = motions_.before;
  if (at >= present.from) return count_in(present, (at - present.from).value());
  return at >= before.from ? count_in(before, (at - before.from).value()) : nearest_count(before.start);
}

std::optional<Cycles> IncrementalEncoder::edge_before(Cycles at) const {
  for (const Motion* motion : {&motions_.counted, &motions_.counted_before}) {
    if (at < motion->from) continue;
    const Counts count = count_in(*motion, (at - motion->from).value());
    if (count == nearest_count(motion->start)) continue;
    const Subcounts behind = motion->target > motion->start ? -kHalfCount : kHalfCount;
    return motion->crosses(to_subcounts(count) + behind);
  }
  return std::nullopt;
}

void IncrementalEncoder::resume(Cycles at) {
  count_ = count_after(at);
  next_edge_ = find_next_edge();
}

}  // namespace armature::cosim
