#include "controller/trajectory/plan/output_places.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// Rounding beyond both ends of a plan.
constexpr double kNoWay_mm = 1e-6, kNoTicks = 1e-3;

struct PathPlace {
  std::size_t segment = 0;
  double share = 0.0;
};

// The place at this distance along the segments, which may be below 0.
std::optional<PathPlace> place_after(const CartesianPlan& plan, PathPlace from, double mm) {
  std::size_t i = from.segment;
  double share = from.share;
  while (true) {
    const double length = plan.segments[i].path.length_mm;
    const double left = mm >= 0.0 ? (1.0 - share) * length : share * length;
    if (std::fabs(mm) <= left) return PathPlace{i, length > 0.0 ? share + mm / length : share};
    const bool last = mm >= 0.0 ? i + 1 == plan.count : i == 0;
    if (last)
      return std::fabs(mm) <= left + kNoWay_mm ? std::optional{PathPlace{i, mm >= 0.0 ? 1.0 : 0.0}} : std::nullopt;
    mm -= std::copysign(left, mm);
    i = mm >= 0.0 ? i + 1 : i - 1;
    share = mm >= 0.0 ? 0.0 : 1.0;
  }
}

double ticks_at(const CartesianPlan& plan, const PathPlace& place) {
  const CartesianSegment& segment = plan.segments[place.segment];
  return plan.table.time_at(segment.from + place.share * segment.length) / kTickSeconds;
}

std::optional<double> ticks_of(const CartesianPlan& plan, std::size_t segment, const PathOutput& output) {
  const PathPlace from{segment, output.from == PathOutput::From::kStart ? 0.0 : 1.0};
  double ticks = 0.0;
  if (output.unit == PathOutput::Unit::kMm) {
    const std::optional<PathPlace> place = place_after(plan, from, output.offset);
    if (!place) return std::nullopt;
    ticks = ticks_at(plan, *place);
  } else {
    ticks = ticks_at(plan, from) + output.offset / kTickSeconds;
  }
  const auto end = static_cast<double>(plan.duration.value());
  if (!(ticks >= -kNoTicks && ticks <= end + kNoTicks)) return std::nullopt;
  return std::clamp(ticks, 0.0, end);
}

}  // namespace

std::optional<std::size_t> place_outputs(CartesianPlan& plan, std::span<const SegmentRequest> chain) noexcept {
  plan.output_count = 0;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const PathOutputs& outputs = chain[i].outputs;
    for (std::size_t k = 0; k < outputs.count; ++k) {
      const PathOutput& output = outputs.list[k];
      const std::optional<double> ticks = ticks_of(plan, i, output);
      if (!ticks) return i;
      // Behind those of the same time.
      std::size_t at = plan.output_count++;
      for (; at > 0 && plan.outputs[at - 1].ticks > *ticks; --at) plan.outputs[at] = plan.outputs[at - 1];
      plan.outputs[at] = {.ticks = *ticks, .tag = chain[i].tag, .pin = output.pin, .level = output.level};
    }
  }
  return std::nullopt;
}

}  // namespace armature
