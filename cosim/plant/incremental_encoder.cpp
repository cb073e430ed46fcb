#include "cosim/plant/incremental_encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace armature::cosim {

IncrementalEncoder::IncrementalEncoder(std::int32_t counts_per_rev, Counts start)
    : counts_per_rev_{counts_per_rev}, start_{start.value() * kSubcountsPerCount}, target_{start_}, count_{start} {
  if (counts_per_rev <= 0 || counts_per_rev % 4 != 0) {
    throw std::invalid_argument{"encoder: counts per revolution are not a positive multiple of 4"};
  }
  turn_ = start.value() % counts_per_rev;
  if (turn_ < 0) turn_ += counts_per_rev;
}

void IncrementalEncoder::move(Cycles from, Cycles length, Subcounts target) {
  begin_motion(from, length, target);
  next_edge_ = find_next_edge();
}

void IncrementalEncoder::begin_motion(Cycles from, Cycles length, Subcounts target) {
  before_ = {from_, length_, start_, target_};
  from_ = from;
  length_ = length;
  start_ = target_;
  target_ = target;
}

// With d cycles since `from_`, the position is start + (target - start) d / length, an exact rational number.
// Rising: the count changes at the first d with position >= boundary; falling: with position < boundary.
Cycles IncrementalEncoder::find_next_edge() const {
  constexpr std::int64_t kHalf = kSubcountsPerCount / 2;
  const std::int64_t here = count_.value() * kSubcountsPerCount;
  const std::int64_t distance = (target_ - start_).value();
  if (target_.value() >= here + kHalf) {
    const std::int64_t to_boundary = (here + kHalf - start_.value()) * length_.value();
    return from_ + Cycles{(to_boundary + distance - 1) / distance};
  }
  if (target_.value() < here - kHalf) {
    const std::int64_t to_boundary = (start_.value() - (here - kHalf)) * length_.value();
    return from_ + Cycles{to_boundary / -distance + 1};
  }
  return kNever;
}

void IncrementalEncoder::execute_edge() {
  const Cycles now = next_edge_;
  history_[edges_++ % kHistory] = {.cycle = now, .before = count_};
  if (target_ > start_) {
    count_ += Counts{1};
    if (++turn_ == counts_per_rev_) turn_ = 0;
  } else {
    count_ -= Counts{1};
    if (--turn_ < 0) turn_ = counts_per_rev_ - 1;
  }
  next_edge_ = find_next_edge();
  if (next_edge_ == now) {
    throw std::logic_error{fmt::format("encoder: more than one count in cycle {}", now.value())};
  }
}

double IncrementalEncoder::position(Cycles now) const {
  const std::int64_t elapsed = std::min((now - from_).value(), length_.value());
  const double moved = static_cast<double>((target_ - start_).value()) * static_cast<double>(elapsed) /
                       static_cast<double>(length_.value());
  return (static_cast<double>(start_.value()) + moved) / static_cast<double>(kSubcountsPerCount);
}

CountRange IncrementalEncoder::counts_since(Cycles from) const {
  CountRange range{.min = count_, .max = count_};
  const std::size_t known = std::min(edges_, kHistory);
  for (std::size_t i = 1; i <= known; ++i) {
    const Edge& edge = history_[(edges_ - i) % kHistory];
    if (edge.cycle <= from) break;
    range.min = std::min(range.min, edge.before);
    range.max = std::max(range.max, edge.before);
  }
  return range;
}

}  // namespace armature::cosim
