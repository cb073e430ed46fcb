#include "controller/trajectory/plan/planned_outputs.hpp"

#include <algorithm>
#include <cmath>

#include "controller/trajectory/plan/output_places.hpp"

namespace armature {
namespace {

constexpr double kTicksLater = 1e-3;  // than those that keep their times

}  // namespace

void PlannedOutputs::begin(std::span<const SegmentRequest> chain) noexcept {
  count_ = 0;
  same_until_ticks_ = 0.0;
  add(0, chain);
}

void PlannedOutputs::add(std::size_t count, std::span<const SegmentRequest> segments) noexcept {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PathOutputs& outputs = segments[i].outputs;
    for (std::size_t k = 0; k < outputs.count; ++k) {
      list_[count_++] = {
          .output = outputs.list[k], .tag = segments[i].tag, .segment = static_cast<std::uint16_t>(count + i)};
    }
  }
}

std::optional<std::size_t> PlannedOutputs::place(CartesianPlan& plan) noexcept {
  plan.outputs.clear();
  for (Planned& planned : std::span{list_}.first(count_)) {
    if (!planned.keeps_time) {
      const std::optional<double> ticks = output_ticks(plan, planned.segment, planned.output);
      if (!ticks) return planned.segment;
      planned.ticks = plan.continues ? std::max(*ticks, same_until_ticks_ + kTicksLater) : *ticks;
    }
    plan.outputs.insert(
        {.ticks = planned.ticks, .tag = planned.tag, .pin = planned.output.pin, .level = planned.output.level});
  }
  return std::nullopt;
}

bool PlannedOutputs::on_own_segments(const CartesianPlan& plan) const noexcept {
  return std::all_of(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(count_), [&](const Planned& planned) {
    return is_on_own_move(planned.output) &&
           std::fabs(planned.output.offset) <= plan.segments[planned.segment].path.length_mm;
  });
}

std::size_t PlannedOutputs::room(Ticks origin) const noexcept {
  const auto from = static_cast<double>(origin.value());
  const auto left = std::count_if(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(count_),
                                  [from](const Planned& planned) { return planned.ticks > from; });
  return list_.size() - static_cast<std::size_t>(left);
}

std::size_t PlannedOutputs::move_origin(Ticks origin, double same_until_ticks, std::size_t over) noexcept {
  const auto from = static_cast<double>(origin.value());
  same_until_ticks_ = same_until_ticks - from;
  std::size_t kept = 0;
  for (const Planned& planned : std::span{list_}.first(count_)) {
    if (planned.ticks <= from) continue;
    Planned& moved = list_[kept++] = planned;
    moved.segment = static_cast<std::uint16_t>(moved.segment - over);
    moved.keeps_time = planned.ticks <= same_until_ticks;
    moved.ticks -= from;
  }
  const std::size_t switched = count_ - kept;
  count_ = kept;
  return switched;
}

}  // namespace armature
