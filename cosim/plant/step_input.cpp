#include "cosim/plant/step_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cosim/plant/clock.hpp"

namespace armature::cosim {
namespace {

Cycles whole_cycles(double ns) {
  return Cycles{static_cast<std::int64_t>(std::ceil(ns / static_cast<double>(kNsPerCycle)))};
}

const char* name(InputRule rule) {
  switch (rule) {
    case InputRule::kStepHigh:
      return "step high time";
    case InputRule::kStepLow:
      return "step low time";
    case InputRule::kDirSetup:
      return "direction set-up";
    case InputRule::kDirHold:
      return "direction hold";
  }
  return "?";
}

}  // namespace

StepTiming StepTiming::from(const DriveSpec& spec) {
  return {.min_high = whole_cycles(spec.min_step_high_ns),
          .min_low = whole_cycles(spec.min_step_low_ns),
          .dir_setup = whole_cycles(spec.dir_setup_ns),
          .dir_hold = whole_cycles(spec.dir_hold_ns)};
}

std::string describe(const InputViolation& violation) {
  return fmt::format("axis {}, cycle {}: {} {} cycles ({} ns), the drive needs {} cycles ({} ns)", violation.axis + 1,
                     violation.cycle.value(), name(violation.rule), violation.measured.value(),
                     violation.measured.value() * kNsPerCycle, violation.required.value(),
                     violation.required.value() * kNsPerCycle);
}

bool StepInput::accepts(const AxisPulses& pulses) const {
  if (pulses.count == 0) return true;
  // Of the shortest level, which is also the time to the first rise at the earliest.
  const auto lasts = [&](Cycles time) { return time.value() * 2 * pulses.pulses() <= pulses.window; };
  const bool held = pulses.turned <= pulses.fell || pulses.turned - pulses.fell >= timing_.dir_hold;
  return held && lasts(std::max(timing_.min_high, timing_.min_low)) &&
         lasts(timing_.dir_setup - (pulses.first - pulses.turned));
}

void StepInput::resume(bool step, bool dir, Cycles changed, Cycles turned) {
  step_ = step;
  dir_ = dir;
  (step ? last_rise_ : last_fall_) = changed;
  turned_ = turned;
}

int StepInput::update(Cycles now, bool step, bool dir, bool checked) {
  if (dir != dir_) {
    // While step is high, or falls together with dir, no hold time has passed.
    const Cycles held = step_ ? Cycles{0} : now - last_fall_;
    if (checked) require(now, held, InputRule::kDirHold, timing_.dir_hold);
    dir_ = dir;
    turned_ = now;
  }
  if (step == step_) return 0;
  step_ = step;
  if (!step) {
    if (checked) require(now, now - last_rise_, InputRule::kStepHigh, timing_.min_high);
    last_fall_ = now;
    return 0;
  }
  if (checked) {
    require(now, now - last_fall_, InputRule::kStepLow, timing_.min_low);
    require(now, now - turned_, InputRule::kDirSetup, timing_.dir_setup);
  }
  last_rise_ = now;
  return dir == kDirForward ? +1 : -1;
}

void StepInput::require(Cycles now, Cycles measured, InputRule rule, Cycles required) {
  if (measured >= required || violation_) return;
  violation_ = InputViolation{.axis = axis_, .cycle = now, .rule = rule, .measured = measured, .required = required};
}

}  // namespace armature::cosim
