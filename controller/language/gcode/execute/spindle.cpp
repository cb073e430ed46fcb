#include "controller/language/gcode/execute/spindle.hpp"

#include <cmath>

namespace armature::gcode {
namespace {

constexpr double kAnyTurns = 1e30;  // no limit

}  // namespace

std::optional<double> Spindle::value_of(std::string_view name) const noexcept {
  return find_value(name, {{"_rpm", active_.speed_rpm},
                           {"_spindle_on", flag(active_.direction != 0)},
                           {"_spindle_cw", flag(active_.direction > 0)},
                           {"_spindle_css_mode", flag(active_.surface_max_rpm > 0.0)},
                           {"_spindle_rpm_mode", flag(active_.surface_max_rpm == 0.0)}});
}

void Spindle::end_program() noexcept {
  calls_.emit(StopSpindle{});
  calls_.emit(SetSpindleMode{});
  active_ = {};
}

Failure Spindle::set_speed(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kSpindleMode)) {
    const bool surface = code->tenths == 960;
    if (surface && !block.words.has('s')) return error_of(ErrorCode::kWordMissing, 's');
    active_.surface_max_rpm = surface ? std::fabs(block.words.get_or('d', kAnyTurns)) : 0.0;
    calls_.emit(SetSpindleMode{active_.surface_max_rpm});
  }
  if (block.words.has('s')) {
    if (block.words.get('s') < 0.0) return error_of(ErrorCode::kWordNegative, 's');
    active_.speed_rpm = block.words.get('s');
    calls_.emit(SetSpindleSpeed{active_.speed_rpm});
  }
  return std::nullopt;
}

void Spindle::set_direction(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kSpindle);
  if (code != nullptr) turn(code->tenths == 30 ? 1 : code->tenths == 40 ? -1 : 0);
}

void Spindle::turn(int direction) noexcept {
  active_.direction = direction;
  if (direction == 0) {
    calls_.emit(StopSpindle{});
  } else {
    calls_.emit(StartSpindle{direction > 0});
  }
}

void Spindle::restore(const Values& to) noexcept {
  if (active_.surface_max_rpm != to.surface_max_rpm) calls_.emit(SetSpindleMode{to.surface_max_rpm});
  if (active_.speed_rpm != to.speed_rpm) calls_.emit(SetSpindleSpeed{to.speed_rpm});
  if (active_.direction != to.direction) turn(to.direction);
  active_ = to;
}

}  // namespace armature::gcode
