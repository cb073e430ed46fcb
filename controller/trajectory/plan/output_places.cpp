#include "controller/trajectory/plan/output_places.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"

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

// Of a joint move between these ticks.
double ticks_of(const PathOutput& output, Ticks start, Ticks end) {
  const Ticks from = output.from == PathOutput::From::kStart ? start : end;
  return static_cast<double>(from.value()) + output.offset / kTickSeconds;
}

// Ticks up to rounding beyond both ends; nothing for others.
std::optional<double> within(Ticks duration, double ticks) {
  const auto end = static_cast<double>(duration.value());
  if (!(ticks >= -kNoTicks && ticks <= end + kNoTicks)) return std::nullopt;
  return std::clamp(ticks, 0.0, end);
}

// Returns whether all outputs of a move are within the plan. `ticks_of_output(output)`: their time.
template <class TicksOf>
bool insert_all(TimedOutputs& timed, const PathOutputs& outputs, Ticks duration, Tag tag, TicksOf ticks_of_output) {
  for (std::size_t k = 0; k < outputs.count; ++k) {
    const PathOutput& output = outputs.list[k];
    const std::optional<double> ticks = within(duration, ticks_of_output(output));
    if (!ticks) return false;
    timed.insert({.ticks = *ticks, .tag = tag, .pin = output.pin, .level = output.level});
  }
  return true;
}

}  // namespace

std::optional<double> output_ticks(const CartesianPlan& plan, std::size_t segment, const PathOutput& output) noexcept {
  const PathPlace from{segment, output.from == PathOutput::From::kStart ? 0.0 : 1.0};
  if (output.unit == PathOutput::Unit::kSeconds) {
    return within(plan.duration, ticks_at(plan, from) + output.offset / kTickSeconds);
  }
  const std::optional<PathPlace> place = place_after(plan, from, output.offset);
  return place ? within(plan.duration, ticks_at(plan, *place)) : std::nullopt;
}

bool place_outputs(JointPlan& plan, const PathOutputs& outputs) noexcept {
  plan.outputs.clear();
  return insert_all(plan.outputs, outputs, plan.duration, plan.tag,
                    [&](const PathOutput& output) { return ticks_of(output, Ticks{}, plan.duration); });
}

std::optional<std::size_t> place_outputs(JointChain& chain, std::span<const PathOutputs> outputs) noexcept {
  chain.outputs.clear();
  for (std::size_t i = 0; i < chain.count; ++i) {
    const auto ticks = [&](const PathOutput& output) { return ticks_of(output, chain.starts[i], chain.end_of(i)); };
    if (!insert_all(chain.outputs, outputs[i], chain.duration, chain.moves[i].tag, ticks)) return i;
  }
  return std::nullopt;
}

}  // namespace armature
