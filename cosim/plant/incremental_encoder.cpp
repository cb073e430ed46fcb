#include "cosim/plant/incremental_encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace armature::cosim {
namespace {

constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient * b > a ? quotient - 1 : quotient;
}

// The count that the encoder shows `elapsed` cycles after the start of the motion.
Counts count_in(const IncrementalEncoder::Motion& motion, std::int64_t elapsed) {
  if (elapsed >= motion.length.value()) return nearest_count(motion.target);
  const std::int64_t way = (motion.target - motion.start).value() * elapsed;
  // A constant needs no division.
  const std::int64_t moved =
      motion.length == kPlantStep ? floor_div(way, kPlantStep.value()) : floor_div(way, motion.length.value());
  return nearest_count(motion.start + Subcounts{moved});
}

}  // namespace

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

// ---- motions whose edges are not executed one by one ----

void IncrementalEncoder::move_without_edges(Cycles from, Cycles length, Subcounts target) {
  begin_motion(from, length, target);
  if (nearest_count(start()) == target_count()) return;
  motions_.counted_before = motions_.counted;
  motions_.counted = motions_.present;
}

Counts IncrementalEncoder::count_on_the_way(Cycles at) const {
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
