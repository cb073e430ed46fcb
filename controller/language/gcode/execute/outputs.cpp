#include "controller/language/gcode/execute/outputs.hpp"

namespace armature::gcode {
namespace {

constexpr int kMaxIndex = 63;

Failure wait_input(const Words& words, const CodeInfo& code, LineCalls& calls) noexcept {
  if (words.has('p') && words.has('e')) return error_of(ErrorCode::kWordNotUsed, 'e');
  WaitInput wait{.analog = words.has('e')};
  if (const Failure failure = read_whole(words, wait.analog ? 'e' : 'p', 0, kMaxIndex, wait.index)) return failure;
  int mode = 0;
  if (words.has('l')) {
    constexpr int kMaxMode = static_cast<int>(WaitInput::Mode::kLow);
    if (const Failure failure = read_whole(words, 'l', 0, kMaxMode, mode)) return failure;
  }
  wait.mode = static_cast<WaitInput::Mode>(mode);
  wait.timeout_s = words.get('q');
  if (wait.timeout_s < 0.0) return error_of(ErrorCode::kWordNegative, 'q');
  if (wait.mode != WaitInput::Mode::kImmediate) {
    if (wait.analog) return error_of(ErrorCode::kWaitMode, code);
    if (wait.timeout_s == 0.0) return error_of(ErrorCode::kWaitTimeout, code);
  }
  calls.emit(wait);
  return std::nullopt;
}

}  // namespace

Failure set_outputs(const Block& block, LineCalls& calls) noexcept {
  const CodeInfo* code = block.code(Group::kOutputs);
  if (code == nullptr) return std::nullopt;
  const Words& words = block.words;
  if (waits_for_input(block)) return wait_input(words, *code, calls);
  int index = 0;
  if (code->tenths < 660) {
    if (const Failure failure = read_whole(words, 'p', 0, kMaxIndex, index)) return failure;
    const bool on = code->tenths == 620 || code->tenths == 640;
    calls.emit(SetDigitalOutput{.with_motion = code->tenths <= 630, .index = index, .on = on});
    return std::nullopt;
  }
  if (const Failure failure = read_whole(words, 'e', 0, kMaxIndex, index)) return failure;
  if (!words.has('q')) return error_of(ErrorCode::kWordMissing, 'q');
  calls.emit(SetAnalogOutput{.with_motion = code->tenths == 670, .index = index, .value = words.get('q')});
  return std::nullopt;
}

}  // namespace armature::gcode
