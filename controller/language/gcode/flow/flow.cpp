#include "controller/language/gcode/flow/flow.hpp"

#include <algorithm>
#include <span>

namespace armature::gcode {

Failure Flow::begin(const ProgramText& program, SourceLine& line) noexcept {
  next_ = 0;
  passed_ = 0;
  choosing_ = false;
  frame_count_ = 0;
  repeat_count_ = 0;
  return index_.build(program, line);
}

void Flow::pass(const LineSpan& line) noexcept {
  next_ = line.next;
  ++passed_;
}

bool Flow::skip(const OWord& word) noexcept {
  // A branch behind one that was executed: its condition does not matter.
  if ((word.keyword == Keyword::kElseIf || word.keyword == Keyword::kElse) && !choosing_) {
    const OWord* end = &word;
    while (end->keyword != Keyword::kEndIf) end = &index_.word(end->partner);
    go_behind(*end);
    return true;
  }
  choosing_ = false;
  // The definition of a subroutine is passed over.
  if (word.keyword != Keyword::kSub) return false;
  go_behind(index_.word(word.partner));
  return true;
}

Failure Flow::execute(const OWord& word, const OWordValues& values) noexcept {
  const double value = values.list[0];
  const OWord& partner = index_.word(word.partner);
  switch (word.keyword) {
    case Keyword::kCall:
      return call_subroutine(values);
    case Keyword::kCallProgram:
      return call_program(values);
    case Keyword::kEndProgram:
      return return_from_program();
    case Keyword::kReturn:
    case Keyword::kEndSub:
      return_from_subroutine(values);
      break;
    case Keyword::kIf:
    case Keyword::kElseIf:
      if (value == 0.0) skip_branch(partner);
      break;
    case Keyword::kWhile:  // the start of a loop, or the end of one that begins with DO
      if ((value != 0.0) == (partner.keyword == Keyword::kDo)) go_behind(partner);
      break;
    case Keyword::kEndWhile:
      go_to(partner);
      break;
    case Keyword::kRepeat:
      return begin_repeat(word, value);
    case Keyword::kEndRepeat:
      end_repeat(partner);
      break;
    case Keyword::kBreak:
      drop_repeats(word.partner);
      go_behind(index_.word(partner.partner));
      break;
    case Keyword::kContinue:
      drop_repeats(static_cast<std::uint16_t>(word.partner + 1));
      go_to(index_.word(partner.partner));
      break;
    default:
      break;
  }
  return std::nullopt;
}

void Flow::go_to(const OWord& word) noexcept {
  next_ = word.start;
  passed_ = word.line - 1;
}

void Flow::go_behind(const OWord& word) noexcept {
  next_ = word.next;
  passed_ = word.line;
}

void Flow::skip_branch(const OWord& next) noexcept {
  choosing_ = next.keyword != Keyword::kEndIf;
  if (choosing_) {
    go_to(next);
  } else {
    go_behind(next);
  }
}

Failure Flow::begin_repeat(const OWord& word, double times) noexcept {
  constexpr double kMaxTimes = 2e9;
  const auto left = static_cast<std::int32_t>(std::clamp(times + 0.5, 0.0, kMaxTimes));
  if (left == 0) {
    go_behind(index_.word(word.partner));
    return std::nullopt;
  }
  if (repeat_count_ == kMaxRepeats) return Error{.code = ErrorCode::kTooManyRepeats};
  repeats_[repeat_count_++] = {.index = index_.index_of(word), .left = left};
  return std::nullopt;
}

void Flow::end_repeat(const OWord& start) noexcept {
  if (--repeats_[repeat_count_ - 1].left > 0) {
    go_behind(start);
  } else {
    --repeat_count_;
  }
}

// Forgets the repetitions of the subroutine whose loops begin at `first` or behind.
void Flow::drop_repeats(std::uint16_t first) noexcept {
  const std::size_t base = frame_count_ == 0 ? 0 : frames_[frame_count_ - 1].repeats;
  while (repeat_count_ > base && repeats_[repeat_count_ - 1].index >= first) --repeat_count_;
}

Failure Flow::call_subroutine(const OWordValues& values) noexcept {
  const OWord* const sub = index_.start_of(Keyword::kSub, values.name);
  if (sub == nullptr) {
    const bool program = index_.start_of(Keyword::kProgram, values.name) != nullptr;
    return Error{.code = program ? ErrorCode::kProgramNotCalled : ErrorCode::kSubroutineUnknown};
  }
  if (frame_count_ == frames_.size() || !executor_.parameters().enter(std::span(values.list).first(values.count))) {
    return Error{.code = ErrorCode::kCallTooDeep};
  }
  enter_frame(*sub, {});
  return std::nullopt;
}

// The subprogram has the local parameters of its caller.
Failure Flow::call_program(const OWordValues& values) noexcept {
  const OWord* const program = index_.start_of(Keyword::kProgram, values.name);
  if (program == nullptr) {
    const bool subroutine = index_.start_of(Keyword::kSub, values.name) != nullptr;
    return Error{.code = subroutine ? ErrorCode::kSubroutineNotCalled : ErrorCode::kSubroutineUnknown};
  }
  if (values.turns == 0) return std::nullopt;
  if (frame_count_ == frames_.size()) return Error{.code = ErrorCode::kCallTooDeep};
  enter_frame(*program, {.program = program, .left = values.turns});
  return std::nullopt;
}

// No subprogram begins within a subroutine, so the innermost call is that of the subroutine.
void Flow::return_from_subroutine(const OWordValues& values) noexcept {
  leave_frame();
  executor_.parameters().leave();
  executor_.set_returned(values.count > 0 ? std::optional(values.list[0]) : std::nullopt);
}

Failure Flow::return_from_program() noexcept {
  Frame& frame = frames_[frame_count_ - 1];
  if (frame.program == nullptr) return Error{.code = ErrorCode::kReturnOfSubroutine};
  if (--frame.left > 0) {
    repeat_count_ = frame.repeats;
    go_behind(*frame.program);
  } else {
    leave_frame();
  }
  return std::nullopt;
}

// Calls what follows `first`.
void Flow::enter_frame(const OWord& first, Frame frame) noexcept {
  frame.return_to = next_;
  frame.return_line = passed_;
  frame.repeats = repeat_count_;
  frames_[frame_count_++] = frame;
  executor_.begin_call();
  go_behind(first);
}

void Flow::leave_frame() noexcept {
  executor_.end_call();
  const Frame& frame = frames_[--frame_count_];
  next_ = frame.return_to;
  passed_ = frame.return_line;
  repeat_count_ = frame.repeats;
}

}  // namespace armature::gcode
