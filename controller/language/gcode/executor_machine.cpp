// Spindle, tools, coolant, overrides, inputs and outputs.
#include <cmath>

#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {
namespace {

constexpr int kMostOutputs = 63;
constexpr double kAnyTurns = 1e30;  // no limit of a spindle

}  // namespace

Executor::Failure Executor::set_spindle_and_tool(const Block& block) noexcept {
  if (const CodeInfo* code = block.code(Group::kSpindleMode)) {
    const bool surface = code->tenths == 960;
    if (surface && !block.words.has('s')) return error_of(ErrorCode::kWordMissing, 's');
    modes_.surface_most_rpm = surface ? std::fabs(block.words.get_or('d', kAnyTurns)) : 0.0;
    emit(SetSpindleMode{modes_.surface_most_rpm});
  }
  if (block.words.has('s')) {
    if (block.words.get('s') < 0.0) return error_of(ErrorCode::kWordNegative, 's');
    modes_.speed_rpm = block.words.get('s');
    emit(SetSpindleSpeed{modes_.speed_rpm});
  }
  if (block.words.has('t')) {
    int tool = 0;
    if (const Failure failure = whole(block.words, 't', 0, kMaxTools - 1, tool)) return failure;
    if (tool != 0 && !tools_[static_cast<std::size_t>(tool)]) return error_of(ErrorCode::kToolUnknown, 't', tool);
    modes_.selected_tool = tool;
    emit(SelectTool{tool});
  }
  if (const Failure failure = set_outputs(block)) return failure;
  if (const CodeInfo* code = block.code(Group::kToolChange)) {
    if (modes_.selected_tool < 0) return error_of(ErrorCode::kToolNotSelected, *code);
    emit(StartChange{});
    emit(StopSpindle{});
    modes_.spindle = 0;
    modes_.tool = modes_.selected_tool;
    emit(ChangeTool{modes_.tool});
  }
  if (const CodeInfo* code = block.code(Group::kSpindle)) {
    turn_spindle(code->tenths == 30 ? 1 : code->tenths == 40 ? -1 : 0);
  }
  return std::nullopt;
}

void Executor::turn_spindle(int direction) noexcept {
  modes_.spindle = direction;
  if (direction == 0) {
    emit(StopSpindle{});
  } else {
    emit(StartSpindle{direction > 0});
  }
}

Executor::Failure Executor::set_outputs(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kOutputs);
  if (code == nullptr) return std::nullopt;
  const Words& words = block.words;
  int index = 0;
  if (code->tenths == 660) return wait_input(words, *code);
  if (code->tenths < 660) {
    if (const Failure failure = whole(words, 'p', 0, kMostOutputs, index)) return failure;
    const bool on = code->tenths == 620 || code->tenths == 640;
    emit(SetDigitalOutput{.with_motion = code->tenths <= 630, .index = index, .on = on});
    return std::nullopt;
  }
  if (const Failure failure = whole(words, 'e', 0, kMostOutputs, index)) return failure;
  if (!words.has('q')) return error_of(ErrorCode::kWordMissing, 'q');
  emit(SetAnalogOutput{.with_motion = code->tenths == 670, .index = index, .value = words.get('q')});
  return std::nullopt;
}

Executor::Failure Executor::wait_input(const Words& words, const CodeInfo& code) noexcept {
  if (words.has('p') && words.has('e')) return error_of(ErrorCode::kWordNotUsed, 'e');
  WaitInput wait{.analog = words.has('e')};
  if (const Failure failure = whole(words, wait.analog ? 'e' : 'p', 0, kMostOutputs, wait.index)) return failure;
  int mode = 0;
  if (words.has('l')) {
    if (const Failure failure = whole(words, 'l', 0, static_cast<int>(WaitInput::Mode::kLow), mode)) return failure;
  }
  wait.mode = static_cast<WaitInput::Mode>(mode);
  wait.timeout_s = words.get('q');
  if (wait.timeout_s < 0.0) return error_of(ErrorCode::kWordNegative, 'q');
  if (wait.mode != WaitInput::Mode::kImmediate) {
    if (wait.analog) return error_of(ErrorCode::kWaitMode, code);
    if (wait.timeout_s == 0.0) return error_of(ErrorCode::kWaitTimeout, code);
  }
  emit(wait);
  after_ = After::kWaitInput;
  return std::nullopt;
}

void Executor::set_coolant(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kCoolant);
  if (code == nullptr) return;
  if (code->tenths == 90) {
    modes_.mist = modes_.flood = false;
    emit(Mist{});
    emit(Flood{});
  } else if (code->tenths == 70) {
    modes_.mist = true;
    emit(Mist{true});
  } else {
    modes_.flood = true;
    emit(Flood{true});
  }
}

Executor::Failure Executor::set_overrides(const Block& block) noexcept {
  const CodeInfo* code = block.code(Group::kOverride);
  if (code == nullptr) return std::nullopt;
  using Kind = EnableOverride::Kind;
  if (code->tenths < 500) {
    switch_override(Kind::kFeed, code->tenths == 480);
    switch_override(Kind::kSpeed, code->tenths == 480);
    return std::nullopt;
  }
  if (block.words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
  switch_override(static_cast<Kind>((code->tenths - 500) / 10), block.words.get_or('p', 1.0) != 0.0);
  return std::nullopt;
}

void Executor::switch_override(EnableOverride::Kind kind, bool on) noexcept {
  modes_.overrides[static_cast<std::size_t>(kind)] = on;
  emit(EnableOverride{.kind = kind, .on = on});
}

void Executor::stop(const CodeInfo* code) noexcept {
  if (code->tenths == 600) emit(PalletShuttle{});
  emit(ProgramStop{code->tenths == 10});
}

}  // namespace armature::gcode
