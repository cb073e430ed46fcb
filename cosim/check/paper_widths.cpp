#include "cosim/check/paper_widths.hpp"

#include <algorithm>
#include <cstdlib>

#include "cosim/check/shortage.hpp"

namespace armature::cosim {
namespace {

// ceil(floor((T - 1) / |width|) / 2): step toggles every |width| cycles, but not on the trigger that ends the tick.
std::int32_t pulses(std::int32_t width, Cycles tick) {
  if (width == 0) return 0;
  const std::int64_t toggles = (tick.value() - 1) / std::abs(std::int64_t{width});
  const auto rises = static_cast<std::int32_t>((toggles + 1) / 2);
  return width < 0 ? -rises : rises;
}

}  // namespace

void PaperWidths::on_write(std::size_t axis, std::int32_t width, bool trigger_in_doubt) {
  written_[axis] = width;
  if (trigger_in_doubt) active_[axis].push_back(width);
}

void PaperWidths::on_trigger() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) active_[axis].assign(1, written_[axis]);
}

bool PaperWidths::allows(std::size_t axis, std::int32_t count, Cycles tick) const {
  return std::ranges::any_of(active_[axis], [&](std::int32_t width) { return pulses(width, tick) == count; });
}

std::optional<std::int32_t> PaperWidths::whole_of(std::size_t axis, std::int32_t count, Cycles tick) const {
  for (auto width = active_[axis].rbegin(); width != active_[axis].rend(); ++width) {
    if (const std::int32_t whole = pulses(*width, tick); is_short_of(count, whole)) return whole;
  }
  return std::nullopt;
}

std::int32_t PaperWidths::expected(std::size_t axis, Cycles tick) const {
  return pulses(active_[axis].back(), tick);
}

}  // namespace armature::cosim
