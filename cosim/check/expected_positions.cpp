#include "cosim/check/expected_positions.hpp"

#include <algorithm>

#include "controller/regs/encoder_regs.hpp"

namespace armature::cosim {
namespace {

// Cycles from a change of an encoder pin to the position, without the debounce time: two flip-flops of the synchroniser
// and the one of the position. A change after clock edge c is in the position after edge c + 3 + debounce time. The
// snapshot adds no latency: the edge after the one that raised the trigger pin samples the position from before that
// edge.
constexpr std::int64_t kEncoderPath = 3;
constexpr std::int64_t kSwitchPath = 1;   // the flip-flop after encoder_switch
constexpr std::int64_t kInputJitter = 1;  // the synchroniser samples a change at the next edge or at the one after it

CountRange operator+(const CountRange& a, const CountRange& b) {
  return {.min = a.min + b.min, .max = a.max + b.max};
}

CountRange hull(const CountRange& a, const CountRange& b) {
  return {.min = std::min(a.min, b.min), .max = std::max(a.max, b.max)};
}

// A 32-bit register counts modulo 2^32.
bool contains(const CountRange& range, std::uint32_t value) {
  return value - static_cast<std::uint32_t>(range.min.value()) <=
         static_cast<std::uint32_t>((range.max - range.min).value());
}

}  // namespace

ExpectedPositions::ExpectedPositions(const Plant& plant, EncoderPath path)
    : plant_{plant},
      path_{kEncoderPath + (path.switched ? kSwitchPath : 0) + (path.input_jitter ? kInputJitter : 0)},
      debounce_{regs::encoder::kDebounceTimeReset},
      previous_debounce_{regs::encoder::kDebounceTimeReset} {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Counts start = plant.motor_counts(axis);
    lost_[axis] = {.min = -start, .max = -start};
  }
}

Cycles ExpectedPositions::latency() const {
  return Cycles{path_ + std::max<std::int64_t>(1, std::max(debounce_, previous_debounce_))};
}

Cycles ExpectedPositions::settled_until(Cycles now) const {
  return std::max(now - latency(), running_since_);
}

void ExpectedPositions::on_trigger(Cycles now, bool trigger_in_doubt) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    previous_[axis] = trigger_in_doubt ? hull(previous_[axis], latest_[axis]) : latest_[axis];
    latest_[axis] = plant_.motor_counts_since(axis, settled_until(now)) + lost_[axis];
  }
  settled_ = now - running_since_ >= latency();
  previous_debounce_ = debounce_;
}

void ExpectedPositions::on_clock_stopped(Cycles now) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    shown_[axis] = plant_.motor_counts_since(axis, settled_until(now));
  }
}

void ExpectedPositions::on_clock_started(Cycles now) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Counts count = plant_.motor_counts(axis);
    const auto& [min, max] = shown_[axis];
    if (min == count && max == count) continue;
    const CountRange unseen{.min = min - count - kMaxFollowed, .max = max - count + kMaxFollowed};
    lost_[axis] = lost_[axis] + unseen;
  }
  running_since_ = now;
  settled_ = false;
}

bool ExpectedPositions::accepts(std::size_t axis, std::uint32_t value, bool trigger_in_doubt) {
  if (trigger_in_doubt && contains(previous_[axis], value)) return true;
  if (!contains(latest_[axis], value)) return false;
  CountRange& lost = lost_[axis];
  if (settled_ && lost.min != lost.max && !trigger_in_doubt) {
    const auto& [min, max] = latest_[axis];
    const Counts read = min + Counts{static_cast<std::int64_t>(value - static_cast<std::uint32_t>(min.value()))};
    // The counts of the encoder at the trigger, without what was lost.
    const CountRange shown{.min = min - lost.min, .max = max - lost.max};
    lost = {.min = std::max(lost.min, read - shown.max), .max = std::min(lost.max, read - shown.min)};
    latest_[axis] = shown + lost;
  }
  return true;
}

}  // namespace armature::cosim
