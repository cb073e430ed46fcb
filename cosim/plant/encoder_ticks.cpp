// Motions of the encoder whose edges are not executed one by one.
#include "cosim/plant/incremental_encoder.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kHalf = kSubcountsPerCount / 2;

constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient * b > a ? quotient - 1 : quotient;
}

// The count that the encoder shows `elapsed` cycles after the begin of the motion.
Counts count_in(const IncrementalEncoder::Motion& motion, std::int64_t elapsed) {
  if (elapsed >= motion.length.value()) return nearest_count(motion.target);
  const std::int64_t moved = floor_div((motion.target - motion.start).value() * elapsed, motion.length.value());
  return nearest_count(motion.start + Subcounts{moved});
}

}  // namespace

void IncrementalEncoder::move_without_edges(Cycles from, Cycles length, Subcounts target) {
  begin_motion(from, length, target);
  if (nearest_count(start_) == nearest_count(target_)) return;
  counted_before_ = counted_;
  counted_ = {from_, length_, start_, target_};
}

Counts IncrementalEncoder::count_after(Cycles at) const {
  if (at >= from_) return count_in({from_, length_, start_, target_}, (at - from_).value());
  return at >= before_.from ? count_in(before_, (at - before_.from).value()) : nearest_count(before_.start);
}

std::optional<Cycles> IncrementalEncoder::edge_before(Cycles at) const {
  for (const Motion& motion : {counted_, counted_before_}) {
    if (at < motion.from) continue;
    const Counts count = count_in(motion, (at - motion.from).value());
    if (count == nearest_count(motion.start)) continue;
    const std::int64_t distance = (motion.target - motion.start).value(), length = motion.length.value();
    if (distance > 0) {  // the first cycle at which the position is not below the boundary under the count
      const std::int64_t to_boundary = (count.value() * kSubcountsPerCount - kHalf - motion.start.value()) * length;
      return motion.from + Cycles{(to_boundary + distance - 1) / distance};
    }
    const std::int64_t to_boundary = (motion.start.value() - (count.value() * kSubcountsPerCount + kHalf)) * length;
    return motion.from + Cycles{to_boundary / -distance + 1};
  }
  return std::nullopt;
}

void IncrementalEncoder::resume(Cycles at) {
  count_ = count_after(at);
  turn_ = count_.value() % counts_per_rev_;
  if (turn_ < 0) turn_ += counts_per_rev_;
  next_edge_ = find_next_edge();
}

void IncrementalEncoder::set_motions(const Motions& motions) {
  from_ = motions.present.from;
  length_ = motions.present.length;
  start_ = motions.present.start;
  target_ = motions.present.target;
  before_ = motions.before;
  counted_ = motions.counted;
  counted_before_ = motions.counted_before;
}

}  // namespace armature::cosim
