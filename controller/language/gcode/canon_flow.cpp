// O-words: subroutines, conditions and loops.
#include <algorithm>

#include "controller/language/gcode/canon_interpreter.hpp"

namespace armature::gcode {
namespace {

// The values that a keyword needs and may have.
struct Arity {
  std::size_t least;
  std::size_t most;
};
constexpr Arity arity_of(Keyword keyword) noexcept {
  switch (keyword) {
    case Keyword::kCall:
      return {.least = 0, .most = Parameters::kLocals};
    case Keyword::kReturn:
    case Keyword::kEndSub:
      return {.least = 0, .most = 1};
    case Keyword::kIf:
    case Keyword::kElseIf:
    case Keyword::kWhile:
    case Keyword::kRepeat:
      return {.least = 1, .most = 1};
    default:
      return {.least = 0, .most = 0};
  }
}

}  // namespace

bool CanonInterpreter::read_arguments(const OWord& word, ValueReader& reader) noexcept {
  const Arity arity = arity_of(word.keyword);
  argument_count_ = 0;
  while (reader.peek() == '[' && (argument_count_ < arity.most || word.keyword == Keyword::kCall)) {
    if (argument_count_ == arity.most) {
      reader.fail(ErrorCode::kTooManyArguments);
      return false;
    }
    const std::optional<double> value = reader.expression();
    if (!value) return false;
    arguments_[argument_count_++] = *value;
  }
  if (argument_count_ < arity.least) {
    reader.fail(ErrorCode::kBracketExpected);
  } else if (!reader.at_end()) {
    reader.fail(ErrorCode::kLineAfterOWord);
  }
  return !reader.error();
}

CanonInterpreter::State CanonInterpreter::execute_o_word(const OWord& word, std::size_t head) noexcept {
  ErrorCode problem{};
  const std::optional<OWordText> read = read_o_word(source_.text().substr(head), problem);
  if (!read) return fail({.code = problem});
  // A branch behind one that was executed: its condition does not matter.
  const bool branch = word.keyword == Keyword::kElseIf || word.keyword == Keyword::kElse;
  if (branch && !choosing_) {
    const OWord* end = &word;
    while (end->keyword != Keyword::kEndIf) end = &index_.word(end->partner);
    go_to(*end, true);
    return state_;
  }
  choosing_ = false;
  ValueReader reader(source_, executor_.parameters());
  reader.skip(head + read->length);
  if (word.keyword == Keyword::kCallProgram) return execute_call_code(reader);
  std::optional<std::uint16_t> name = word.name;
  if (read->computed) {
    name = computed_name(reader);
    if (reader.error()) return fail(reader);
    if (!reader.accept("call")) return fail({.code = ErrorCode::kComputedLabel});
  }
  // The definition of a subroutine is passed over.
  if (word.keyword == Keyword::kSub) {
    go_to(index_.word(word.partner), true);
    return state_;
  }
  if (!read_arguments(word, reader)) return fail(reader);
  if (!say_comment()) return state_;
  switch (word.keyword) {
    case Keyword::kProgram:
      break;
    case Keyword::kEndProgram:
      return execute_return_code();
    case Keyword::kCall:
      if (!run_call(name)) return state_;
      break;
    case Keyword::kReturn:
    case Keyword::kEndSub:
      run_return();
      break;
    case Keyword::kIf:
    case Keyword::kElseIf:
      run_branch(word);
      break;
    case Keyword::kRepeat:
      if (arguments_[0] >= 0.5 && repeat_count_ == kMaxRepeats) return fail({.code = ErrorCode::kTooManyRepeats});
      run_loop(word);
      break;
    default:
      run_loop(word);
      break;
  }
  return state_;
}

void CanonInterpreter::run_branch(const OWord& word) noexcept {
  if (arguments_[0] != 0.0) return;
  choosing_ = true;
  const OWord& next = index_.word(word.partner);
  choosing_ = next.keyword != Keyword::kEndIf;
  go_to(next, !choosing_);
}

void CanonInterpreter::run_loop(const OWord& word) noexcept {
  constexpr double kMostRepeats = 2e9;
  const OWord& partner = index_.word(word.partner);
  switch (word.keyword) {
    case Keyword::kWhile:
      if (partner.keyword == Keyword::kDo) {
        if (arguments_[0] != 0.0) go_to(partner, true);
      } else if (arguments_[0] == 0.0) {
        go_to(partner, true);
      }
      return;
    case Keyword::kEndWhile:
      return go_to(partner, false);
    case Keyword::kRepeat: {
      const auto times = static_cast<std::int32_t>(std::clamp(arguments_[0] + 0.5, 0.0, kMostRepeats));
      if (times == 0) return go_to(partner, true);
      repeats_[repeat_count_++] = {.index = index_.index_of(word), .left = times};
      return;
    }
    case Keyword::kEndRepeat: {
      Repeat& repeat = repeats_[repeat_count_ - 1];
      if (--repeat.left > 0) return go_to(partner, true);
      --repeat_count_;
      return;
    }
    case Keyword::kBreak:
      drop_repeats(word.partner);
      return go_to(index_.word(partner.partner), true);
    case Keyword::kContinue:
      drop_repeats(static_cast<std::uint16_t>(word.partner + 1));
      return go_to(index_.word(partner.partner), false);
    default:
      return;
  }
}

// The name that an expression gives, which may be that of no O-word.
std::optional<std::uint16_t> CanonInterpreter::computed_name(ValueReader& reader) noexcept {
  const std::optional<std::int32_t> number = reader.whole();
  return number ? index_.find_number(*number) : std::nullopt;
}

bool CanonInterpreter::run_call(std::optional<std::uint16_t> name) noexcept {
  const OWord* const sub = name ? index_.begin_of(Keyword::kSub, *name) : nullptr;
  if (sub == nullptr) {
    const bool program = name && index_.begin_of(Keyword::kProgram, *name) != nullptr;
    fail({.code = program ? ErrorCode::kProgramNotCalled : ErrorCode::kSubroutineUnknown});
    return false;
  }
  if (frame_count_ == frames_.size() || !executor_.parameters().enter(std::span(arguments_).first(argument_count_))) {
    fail({.code = ErrorCode::kCallTooDeep});
    return false;
  }
  enter_frame(*sub, {});
  return true;
}

// No subprogram begins within a subroutine, so the innermost call is that of the subroutine.
void CanonInterpreter::run_return() noexcept {
  leave_frame();
  executor_.parameters().leave();
  executor_.set_returned(argument_count_ > 0 ? std::optional(arguments_[0]) : std::nullopt);
}

// Calls what begins behind `begin`.
void CanonInterpreter::enter_frame(const OWord& begin, Frame frame) noexcept {
  frame.return_to = at_;
  frame.return_line = passed_;
  frame.repeats = repeat_count_;
  frames_[frame_count_++] = frame;
  executor_.begin_call();
  go_to(begin, true);
}

void CanonInterpreter::leave_frame() noexcept {
  executor_.end_call();
  const Frame& frame = frames_[--frame_count_];
  at_ = frame.return_to;
  passed_ = frame.return_line;
  repeat_count_ = frame.repeats;
}

// M98. The subprogram has the local parameters of its caller.
CanonInterpreter::State CanonInterpreter::execute_call_code(ValueReader& reader) noexcept {
  std::optional<std::int32_t> times;
  std::optional<std::int32_t> number;
  while (!reader.at_end()) {
    const std::size_t begin = reader.position();
    const char letter = reader.peek();
    std::optional<std::int32_t>& value = letter == 'p' ? number : times;
    const bool known = letter == 'p' || letter == 'l';
    reader.skip(1);
    if (!known || value) {
      reader.fail(known ? ErrorCode::kWordTwice : ErrorCode::kCodeNotFirst, begin);
      return fail(reader);
    }
    value = reader.whole();
    if (value && *value < 0) reader.fail(ErrorCode::kWordNegative, begin);
    if (reader.error()) return fail(reader);
  }
  if (!number) return fail({.code = ErrorCode::kWordMissing, .letter = 'P'});
  if (!say_comment()) return state_;
  const std::optional<std::uint16_t> name = index_.find_number(*number);
  const OWord* const program = name ? index_.begin_of(Keyword::kProgram, *name) : nullptr;
  if (program == nullptr) {
    const bool subroutine = name && index_.begin_of(Keyword::kSub, *name) != nullptr;
    return fail({.code = subroutine ? ErrorCode::kSubroutineNotCalled : ErrorCode::kSubroutineUnknown});
  }
  if (times == 0) return state_;
  if (frame_count_ == frames_.size()) return fail({.code = ErrorCode::kCallTooDeep});
  enter_frame(*program, {.program = program, .left = times.value_or(1)});
  return state_;
}

// M99
CanonInterpreter::State CanonInterpreter::execute_return_code() noexcept {
  if (frame_count_ == 0) {
    executor_.end_program(false);
    return state_ = State::kEnded;
  }
  Frame& frame = frames_[frame_count_ - 1];
  if (frame.program == nullptr) return fail({.code = ErrorCode::kReturnOfSubroutine});
  if (--frame.left > 0) {
    repeat_count_ = frame.repeats;
    go_to(*frame.program, true);
  } else {
    leave_frame();
  }
  return state_;
}

// Forgets the repetitions of the subroutine whose loops begin at `first` or behind.
void CanonInterpreter::drop_repeats(std::uint16_t first) noexcept {
  const std::size_t base = frame_count_ == 0 ? 0 : frames_[frame_count_ - 1].repeats;
  while (repeat_count_ > base && repeats_[repeat_count_ - 1].index >= first) --repeat_count_;
}

}  // namespace armature::gcode
