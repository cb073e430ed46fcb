#include "cosim/plant/incremental_encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace armature::cosim {

IncrementalEncoder::IncrementalEncoder(std::int32_t counts_per_rev, Counts start)
    : counts_per_rev_{counts_per_rev},
      motions_{.present = {.start = to_subcounts(start), .target = to_subcounts(start)}},
      count_{start} {
  if (counts_per_rev <= 0 || counts_per_rev % 4 != 0) {
    throw std::invalid_argument{"encoder: counts per revolution are not a positive multiple of 4"};
  }
}

void IncrementalEncoder::move(Cycles from, Cycles length, Subcounts target) {
  begin_motion(from, length, target);
  next_edge_ = find_next_edge();
}

void IncrementalEncoder::begin_motion(Cycles from, Cycles length, Subcounts target) {
  motions_.before = motions_.present;
  motions_.present = {.from = from, .length = length, .start = motions_.before.target, .target = target};
}

// The position is an exact rational number.
Cycles IncrementalEncoder::Motion::crosses(Subcounts boundary) const {
  const std::int64_t distance = (target - start).value();
  const std::int64_t to_boundary = (boundary - start).value() * length.value();
  return from + Cycles{distance > 0 ? (to_boundary + distance - 1) / distance : to_boundary / distance + 1};
}

Cycles IncrementalEncoder::find_next_edge() const {
  const Subcounts above = to_subcounts(count_) + kHalfCount, below = to_subcounts(count_) - kHalfCount;
  if (target() >= above) return motions_.present.crosses(above);
  return target() < below ? motions_.present.crosses(below) : kNever;
}

void IncrementalEncoder::execute_edge() {
  const Cycles now = next_edge_;
  history_[edges_++ % kHistory] = {.cycle = now, .before = count_};
  count_ += Counts{target() > start() ? 1 : -1};
  next_edge_ = find_next_edge();
  if (next_edge_ == now) {
    throw std::logic_error{fmt::format("encoder: more than one count in cycle {}", now.value())};
  }
}

double IncrementalEncoder::position(Cycles now) const {
  const Motion& motion = motions_.present;
  const std::int64_t elapsed = std::min((now - motion.from).value(), motion.length.value());
  const double moved = static_cast<double>((motion.target - motion.start).value()) * static_cast<double>(elapsed) /
                       static_cast<double>(motion.length.value());
  return (static_cast<double>(motion.start.value()) + moved) / static_cast<double>(kSubcountsPerCount);
}

CountRange IncrementalEncoder::counts_since(Cycles from) const {
  CountRange range{.min = count_, .max = count_};
  edges_since(from, [&](Cycles, Counts before) {
    range.min = std::min(range.min, before);
    range.max = std::max(range.max, before);
  });
  return range;
}

}  // namespace armature::cosim
