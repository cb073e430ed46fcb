#include "cosim/model/pulse_train/pulse_axis.hpp"

#include <algorithm>
#include <cstdlib>

namespace armature::cosim::model {

void PulseAxis::edge(Cycles at, const Times& times, bool trigger, bool stop) {
  if (step_ && !own_pulse_) {
    end_pulse_before(at);
  } else if (running_ && !spreads(at)) {
    if (at >= turn_at(times) && !trigger && !stop) turn(at, times);
  } else if (running_) {
    if (!window_open_) start_window(at);
    const bool wide_enough = at - changed_at_ >= kMinWidth;
    if (at >= toggle_at_ && wide_enough && (step_ || !(trigger || stop))) toggle(at);
  }
  if (stop) running_ = own_pulse_ = false;
}

void PulseAxis::begin_tick(Cycles at, const Times& times, std::int32_t count, bool stop) {
  increment_ = 2 * std::int64_t{std::abs(count)};
  window_ = std::max(times.tick.value(), increment_);
  unfinished_ = count;
  began_at_ = at;
  running_ = count != 0 && !stop;
  own_pulse_ = window_open_ = false;
}

std::optional<AxisPulses> PulseAxis::whole_tick(const Times& times) const {
  if (step_) return std::nullopt;
  if (!running_) return AxisPulses{};
  const Cycles start =
      turns() ? turn_at(times) + times.dir_setup + Cycles{1} : std::max(set_up_at_, began_at_ + Cycles{1});
  const Cycles first = start - Cycles{1};
  const std::int64_t window = window_ - (first - began_at_).value();
  if (window < kMinWidth.value() * increment_) return std::nullopt;
  return AxisPulses{.count = unfinished_,
                    .first = first,
                    .window = static_cast<std::int32_t>(window),
                    .fell = changed_at_,
                    .turned = turns() ? turn_at(times) : turned_at(times)};
}

void PulseAxis::finish_tick(const AxisPulses& pulses) {
  if (pulses.count == 0) return;
  if (turns()) {
    positive_ = !positive_;
    set_up_at_ = pulses.first + Cycles{1};
  }
  emitted_ += static_cast<std::uint32_t>(pulses.count);
  unfinished_ = 0;
  window_ = pulses.window;
  gained_ = 0;
  changed_at_ = pulses.first + Cycles{((increment_ - 1) * window_ + increment_ - 1) / increment_};
  toggle_at_ = pulses.first + Cycles{window_};
  step_ = own_pulse_ = window_open_ = true;
}

Cycles PulseAxis::wakes_at(const Times& times) const {
  if (step_ && !own_pulse_) return changed_at_ + kMinWidth;
  if (!running_) return kNever;
  if (window_open_) return std::max(toggle_at_, changed_at_ + kMinWidth);
  if (turns()) return turn_at(times);
  return std::max(set_up_at_, began_at_ + Cycles{1});
}

// The earliest edge at which the direction may change.
Cycles PulseAxis::turn_at(const Times& times) const {
  return std::max({set_up_at_, changed_at_ + std::max(times.dir_hold, Cycles{1}), began_at_ + Cycles{1}});
}

void PulseAxis::end_pulse_before(Cycles at) {
  if (at - changed_at_ < kMinWidth) return;
  step_ = false;
  changed_at_ = at;
}

void PulseAxis::turn(Cycles at, const Times& times) {
  positive_ = !positive_;
  set_up_at_ = at + times.dir_setup + Cycles{1};
}

// The first edge at which the axis is free.
void PulseAxis::start_window(Cycles at) {
  const std::int64_t blocked = (at - began_at_).value() - 1;
  window_ = std::max(window_ - blocked, increment_);
  const std::int64_t edges = (window_ + increment_ - 1) / increment_;
  toggle_at_ = at + Cycles{edges - 1};
  gained_ = edges * increment_ - window_;
  window_open_ = true;
}

void PulseAxis::toggle(Cycles at) {
  step_ = !step_;
  changed_at_ = at;
  if (step_) {
    own_pulse_ = true;
    emitted_ += positive_ ? 1u : ~0u;
    unfinished_ -= positive_ ? 1 : -1;
  } else {
    running_ = unfinished_ != 0;
    if (!running_) return;  // no change of this tick is left
  }
  const std::int64_t edges = (window_ - gained_ + increment_ - 1) / increment_;
  toggle_at_ = at + Cycles{edges};
  gained_ += edges * increment_ - window_;
}

}  // namespace armature::cosim::model
