#include "controller/language/job/execute/pins.hpp"

#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/language/job/state/expression.hpp"

namespace armature::job {
namespace {

constexpr double kPulseSeconds = 0.3;  // of PULSE without T=
constexpr double kSecondsPerUnit = 0.01;

Ticks ticks_of(double time_s) noexcept {
  return Ticks{round_half_away(time_s / kTickSeconds)};
}

}  // namespace

bool Pins::dwell(Step& step, OperandReader& operands) noexcept {
  double time_s = 0.0;
  if (!step.wait_for_room() || !operands.tag(kSecondsPerUnit, time_s)) return false;
  if (!(time_s >= 0.0)) return step.fail(Alarm::kRange);
  const Ticks ticks = ticks_of(time_s);
  if (ticks > Ticks{0}) step.send(Dwell{.duration = ticks});
  return true;
}

// WAIT T=: as TIMER. Otherwise until the condition holds; after the time the program continues, too.
bool Pins::wait(Step& step, OperandReader& operands) noexcept {
  if (operands.is(OperandKind::kTag)) return dwell(step, operands);
  bool holds = false;
  if (!read_condition(operands, holds)) return false;
  if (holds) {
    step.note(ProgramNote::Kind::kWaited);
    return true;
  }
  if (!step.wait_until_done()) return false;
  if (!wait_start_) {
    wait_start_ = step.port().now();
    step.note(ProgramNote::Kind::kWaits);
  }
  if (operands.at_end()) return step.wait_in_each_tick();
  double limit_s = 0.0;
  if (!operands.tag(kSecondsPerUnit, limit_s)) return false;
  if (step.port().now() - *wait_start_ < ticks_of(limit_s)) return step.wait_in_each_tick();
  step.note(ProgramNote::Kind::kWaited, kWaitTimeOver);
  return true;
}

bool Pins::switch_output(Step& step, std::size_t pin, bool level) noexcept {
  if (pin > PinLevels::kPins) {
    levels_.set(pin, level);
    return true;
  }
  if (!step.wait_for_room()) return false;
  step.send(SetOutput{.pin = static_cast<std::uint8_t>(pin), .level = level});
  return true;
}

bool Pins::switch_outputs(Step& step, OperandReader& operands) noexcept {
  const std::size_t count = pins_of(operands.io_here());
  double index = 0.0, value = 0.0;
  if (!operands.io_number(index) || !operands.number(value)) return false;
  const double last = std::floor(static_cast<double>(PinLevels::kMaxOutputs) / static_cast<double>(count));
  if (!(index >= 1.0 && index <= last)) return step.fail(Alarm::kPin);
  if (!(value >= 0.0 && value < static_cast<double>(1U << count)) || std::floor(value) != value) {
    return step.fail(Alarm::kRange);
  }
  const std::size_t first = (static_cast<std::size_t>(index) - 1) * count + 1;
  for (; group_bit_ < count; ++group_bit_) {
    const bool level = (static_cast<unsigned>(value) >> group_bit_ & 1U) != 0;
    if (!switch_output(step, first + group_bit_, level)) return false;
  }
  return true;
}

bool Pins::read_pins(Step&, OperandReader& operands) noexcept {
  VariableId id;
  double value = 0.0;
  return operands.variable(id) && operands.pins(value) && operands.store(id, value);
}

bool Pins::pulse(Step& step, OperandReader& operands) noexcept {
  const IoType type = operands.io_here();
  double index = 0.0, time_s = kPulseSeconds;
  if (!operands.io_number(index)) return false;
  if (type != IoType::kOutput) return step.fail(Alarm::kUnsupported);
  if (!(index >= 1.0 && index <= static_cast<double>(PinLevels::kMaxOutputs))) return step.fail(Alarm::kPin);
  if (operands.is(OperandKind::kTag) && !operands.tag(kSecondsPerUnit, time_s)) return false;
  if (index > static_cast<double>(PinLevels::kPins)) return true;  // nothing sees it
  if (!step.wait_until_done()) return false;
  step.port().pulse(static_cast<std::uint8_t>(index), ticks_of(time_s));
  return true;
}

}  // namespace armature::job
