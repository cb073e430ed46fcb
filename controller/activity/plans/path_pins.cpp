#include "controller/activity/plans/path_pins.hpp"

#include <algorithm>
#include <span>

namespace armature {

void PathPins::written(Ticks tick, EventListener& events) noexcept {
  for (std::size_t i = 0; i < next_tick_.count; ++i) {
    const TimedOutput& output = next_tick_.outputs[i];
    events.on_event(OutputSwitched{.tag = output.tag, .pin = output.pin, .level = output.level, .tick = tick});
  }
  std::copy_n(tick_after_next_.outputs.begin(), tick_after_next_.count, next_tick_.outputs.begin());
  next_tick_.count = tick_after_next_.count;
  tick_after_next_.count = 0;
}

void PathPins::advance(const Plan& plan, double ticks, bool ended) noexcept {
  const std::span<const TimedOutput> outputs = outputs_of(plan);
  const double way = ticks - executed_;
  for (; next_ < outputs.size(); ++next_) {
    const TimedOutput& output = outputs[next_];
    if (!ended && output.ticks > ticks) break;
    List& list = output.ticks - executed_ <= 0.5 * way ? next_tick_ : tick_after_next_;
    list.outputs[list.count++] = output;
  }
  executed_ = ticks;
}

PinLevels PathPins::next() const noexcept {
  PinLevels result;
  for (std::size_t i = 0; i < next_tick_.count; ++i) {
    const auto bit = static_cast<std::uint16_t>(1u << (next_tick_.outputs[i].pin - 1u));
    result.mask = static_cast<std::uint16_t>(result.mask | bit);
    result.levels =
        static_cast<std::uint16_t>(next_tick_.outputs[i].level ? result.levels | bit : result.levels & ~bit);
  }
  return result;
}

}  // namespace armature
