#include "controller/language/gcode/run/input_wait.hpp"

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"

namespace armature::gcode {
namespace {

constexpr double kTimedOut = -1.0;

bool reached(WaitInput::Mode mode, bool before, bool level) noexcept {
  switch (mode) {
    case WaitInput::Mode::kImmediate:
      return true;
    case WaitInput::Mode::kRise:
      return !before && level;
    case WaitInput::Mode::kFall:
      return before && !level;
    case WaitInput::Mode::kHigh:
      return level;
    case WaitInput::Mode::kLow:
      return !level;
  }
  return true;
}

}  // namespace

void InputWait::begin(const WaitInput& wait, ProgramPlace place, Ticks now) noexcept {
  active_ = first_ = true;
  wait_ = wait;
  place_ = place;
  start_ = now;
}

std::optional<double> InputWait::step(ProgramPort& port) noexcept {
  const bool level = port.level(static_cast<std::uint8_t>(wait_.index + 1), false);
  const bool first = first_;
  const bool in_time = reached(wait_.mode, first ? level : last_level_, level);
  first_ = false;
  last_level_ = level;
  const Ticks timeout{round_half_away(wait_.timeout_s / kTickSeconds)};
  if (!in_time && port.now() - start_ < timeout) {
    if (first) port.note({.kind = ProgramNote::Kind::kWaits, .place = place_});
    return std::nullopt;
  }
  active_ = false;
  const std::string_view why = in_time ? std::string_view{} : kWaitTimeOver;
  port.note({.kind = ProgramNote::Kind::kWaited, .place = place_, .text = why});
  if (!in_time) return kTimedOut;
  return level ? 1.0 : 0.0;
}

}  // namespace armature::gcode
