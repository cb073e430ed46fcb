#include "controller/trajectory/plan/chain_timing.hpp"

#include "controller/core/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

void ChainTiming::begin(std::span<const SegmentRequest> chain) noexcept {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    profile_[i] = chain[i].profile;
    blend_mm_[i] = i + 1 < chain.size() ? chain[i].blend_mm : 0.0;
  }
}

void ChainTiming::disable_blends() noexcept {
  blend_mm_.fill(0.0);
}

bool ChainTiming::may_round(const CartesianPlan& plan, std::size_t corner) const noexcept {
  return blend_mm_[corner] > 0.0 && corner + 1 < plan.count && has_length(plan.segments[corner]) &&
         has_length(plan.segments[corner + 1]);
}

void ChainTiming::choose_corners(CartesianPlan& plan) noexcept {
  rounded_ = false;
  least_exact_ = {};
  corner_.fill({});
  for (std::size_t i = 0; i < plan.count; ++i) {
    plan.segments[i].stretch = 1.0;
    plan.segments[i].stretched_for = 0;
  }
  for (std::size_t i = 0; i < plan.count; ++i) {
    plan_law(plan, i);
    if (plan.segments[i].duration > kLongestSegment) return;  // schedule() reports it
    least_exact_ += plan.segments[i].duration;
  }
  for (std::size_t i = 0; i + 1 < plan.count; ++i) {
    if (!may_round(plan, i)) continue;
    const Ticks exact = time_of_pair(plan, i);
    const double most_of_first = i > 0 && may_round(plan, i - 1) ? 1.0 / 3.0 : 0.5;
    const double most_of_second = may_round(plan, i + 1) ? 1.0 / 3.0 : 0.5;
    const CartesianSegment &first = plan.segments[i], &second = plan.segments[i + 1];
    corner_[i] =
        rounded_corner({first, first.limits, most_of_first}, {second, second.limits, most_of_second}, blend_mm_[i]);
    plan_law(plan, i);
    plan_law(plan, i + 1);
    if (time_of_pair(plan, i) < exact) {
      rounded_ = true;
    } else {
      corner_[i] = {};
      plan_law(plan, i);
      plan_law(plan, i + 1);
    }
  }
}

// The fastest law between the corners of a segment, already in whole ticks: a stretch by a thousandth of a tick would
// not make it slower.
void ChainTiming::plan_law(CartesianPlan& plan, std::size_t index) noexcept {
  CartesianSegment& segment = plan.segments[index];
  const Corner before = index > 0 ? corner_[index - 1] : Corner{};
  const TimeLaw law = fastest_law(profile_[index], segment, segment.limits, before, corner_[index]);
  segment.duration = whole_ticks(law.duration_s());
  fastest_[index] = scale_in_time(law, seconds(segment.duration));
  segment.law = fastest_[index];
}

// The time of two neighbours, without the overlaps between them and with the segment before.
Ticks ChainTiming::time_of_pair(const CartesianPlan& plan, std::size_t first) const noexcept {
  const CartesianSegment &a = plan.segments[first], &b = plan.segments[first + 1];
  if (a.duration > kLongestSegment || b.duration > kLongestSegment) return kLongestSegment + kLongestSegment;
  Ticks result = a.duration + b.duration - overlap(a, b, corner_[first].blend_mm);
  if (first > 0) result -= overlap(plan.segments[first - 1], a, corner_[first - 1].blend_mm);
  return result;
}

std::optional<std::size_t> ChainTiming::schedule(CartesianPlan& plan) const noexcept {
  Ticks end{};
  for (std::size_t i = 0; i < plan.count; ++i) {
    CartesianSegment& segment = plan.segments[i];
    segment.duration = whole_ticks(fastest_[i].duration_s() * segment.stretch);
    if (segment.duration > kLongestSegment) return i;
    segment.law = scale_in_time(fastest_[i], seconds(segment.duration));
    const Ticks early = i > 0 ? overlap(plan.segments[i - 1], segment, corner_[i - 1].blend_mm) : Ticks{0};
    segment.start = end - early;
    end = end_of(segment);
  }
  plan.duration = end;
  return std::nullopt;
}

}  // namespace armature
