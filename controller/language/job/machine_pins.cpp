// How the machine uses time and the pins of the tool.
#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/language/job/machine.hpp"

namespace armature::job {
namespace {

constexpr double kPulseSeconds = 0.3;  // of PULSE without T=
constexpr double kSecondsPerUnit = 0.01;

Ticks ticks_of(double time_s) noexcept {
  return Ticks{round_half_away(time_s / kTickSeconds)};
}

}  // namespace

Machine::Outcome Machine::dwell() noexcept {
  if (!port_->has_room()) return Outcome::kWait;
  std::size_t at = 0;
  double time_s = 0.0;
  if (!tag_number(at, kSecondsPerUnit, time_s)) return outcome_;
  if (!(time_s >= 0.0)) return (void)fail(Alarm::kRange), outcome_;
  const Ticks ticks = ticks_of(time_s);
  if (ticks > Ticks{0}) port_->send(Dwell{.duration = ticks}, place());
  return Outcome::kNext;
}

// WAIT T=: as TIMER. Otherwise until the condition holds; after the time the program goes on, too.
Machine::Outcome Machine::wait() noexcept {
  if (operand(0).kind == OperandKind::kTag) return dwell();
  std::size_t at = 0;
  bool holds = false;
  if (!condition(at, holds)) return outcome_;
  const auto note = [this](ProgramNote::Kind kind, std::string_view text = {}) {
    port_->note({.kind = kind, .place = place(), .text = text});
  };
  if (holds) return note(ProgramNote::Kind::kWaited), Outcome::kNext;
  if (!wait_until_done()) return outcome_;
  if (!wait_began_) {
    wait_began_ = port_->now();
    note(ProgramNote::Kind::kWaits);
  }
  if (at < operands_.size()) {
    double limit_s = 0.0;
    if (!tag_number(at, kSecondsPerUnit, limit_s)) return outcome_;
    if (port_->now() - *wait_began_ >= ticks_of(limit_s)) {
      return note(ProgramNote::Kind::kWaited, kWaitTimeOver), Outcome::kNext;
    }
  }
  waits_for_time_ = true;
  return Outcome::kWait;
}

Machine::Outcome Machine::switch_output(std::size_t pin, bool level) noexcept {
  if (pin > kPins) {
    outputs_[pin] = level;
    return Outcome::kNext;
  }
  if (!port_->has_room()) return Outcome::kWait;
  port_->send(SetOutput{.pin = static_cast<std::uint8_t>(pin), .level = level}, place());
  return Outcome::kNext;
}

// DOUT: one output, or each output of a group in its order, one in a step.
Machine::Outcome Machine::switch_outputs() noexcept {
  std::size_t at = 1;
  const auto type = static_cast<IoType>(operand(0).what);
  const std::size_t pins = type == IoType::kOutput ? 1 : type == IoType::kOutputHalfGroup ? 4 : 8;
  double index = 0.0, value = 0.0;
  if (!number(at, index) || !number(at, value)) return outcome_;
  const double last = std::floor(static_cast<double>(kMostOutputs) / static_cast<double>(pins));
  if (!(index >= 1.0 && index <= last)) return (void)fail(Alarm::kPin), outcome_;
  if (!(value >= 0.0 && value < static_cast<double>(1U << pins)) || std::floor(value) != value) {
    return (void)fail(Alarm::kRange), outcome_;
  }
  const std::size_t first = (static_cast<std::size_t>(index) - 1) * pins + 1;
  while (group_bit_ < pins) {
    const bool level = (static_cast<unsigned>(value) >> group_bit_ & 1U) != 0;
    const Outcome outcome = switch_output(first + group_bit_, level);
    if (outcome != Outcome::kNext) return outcome;
    ++group_bit_;
  }
  return Outcome::kNext;
}

Machine::Outcome Machine::read_inputs() noexcept {
  std::size_t at = 0;
  VariableId id;
  double value = 0.0;
  if (!variable(at, id) || !pin_value(at, value)) return outcome_;
  return check(variables_.store(id, value)) ? Outcome::kNext : outcome_;
}

// Begins when the arm is there; the program goes on at once.
Machine::Outcome Machine::begin_pulse() noexcept {
  bool holds = false;
  if (!guard(0, holds)) return outcome_;
  if (!holds) return Outcome::kNext;
  std::size_t at = 1;
  double index = 0.0, time_s = kPulseSeconds;
  if (!number(at, index)) return outcome_;
  if (operand(0).what != static_cast<std::uint8_t>(IoType::kOutput)) return (void)fail(Alarm::kUnsupported), outcome_;
  if (!(index >= 1.0 && index <= static_cast<double>(kMostOutputs))) return (void)fail(Alarm::kPin), outcome_;
  if (at < operands_.size() && operand(at).kind == OperandKind::kTag && !tag_number(at, kSecondsPerUnit, time_s)) {
    return outcome_;
  }
  if (index > static_cast<double>(kPins)) return Outcome::kNext;  // nothing sees it
  if (!wait_until_done()) return outcome_;
  port_->pulse(static_cast<std::uint8_t>(index), ticks_of(time_s));
  return Outcome::kNext;
}

}  // namespace armature::job
