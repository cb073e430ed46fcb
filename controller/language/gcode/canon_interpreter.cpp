#include "controller/language/gcode/canon_interpreter.hpp"

#include "controller/language/gcode/comment.hpp"

namespace armature::gcode {

CanonInterpreter::State CanonInterpreter::begin(const ProgramText& program, const Options& options) noexcept {
  program_ = program;
  options_ = options;
  at_ = 0;
  line_ = passed_ = 0;
  percent_ = choosing_ = ended_without_code_ = false;
  frame_count_ = 0;
  repeat_count_ = 0;
  state_ = State::kRunning;
  executor_.begin_program(options.start);
  if (const std::optional<Error> error = index_.build(program, source_)) return fail(*error);
  return state_;
}

CanonInterpreter::State CanonInterpreter::step() noexcept {
  if (state_ != State::kRunning) return state_;
  if (executor_.in_cycle()) {
    executor_.continue_cycle();
    if (!executor_.in_cycle()) after_block();
    return state_;
  }
  if (program_.file_ends(at_)) return end_of_file();
  line_ = passed_ + 1;
  const LineSpan span = line_at(program_.text, at_);
  const OWord* const o_word = index_.at_line(at_);
  executor_.begin_line(line_);
  at_ = span.next;
  passed_ = line_;
  if (const auto error = source_.read(program_.text.substr(span.begin, span.end - span.begin))) return fail(*error);
  const std::string_view text = source_.text();
  if (text == "%") {
    if (!program_.in_main(span.begin)) return state_;
    if (percent_) return state_ = State::kEnded;
    percent_ = true;
    return state_;
  }
  if (options_.block_delete && text.starts_with('/')) return state_;
  const std::size_t head = line_head(text);
  if (o_word != nullptr) return execute_o_word(*o_word, head);
  return execute_words(head);
}

CanonInterpreter::State CanonInterpreter::end_of_file() noexcept {
  if (frame_count_ > 0) return fail({.code = ErrorCode::kSubprogramNotEnded});
  ended_without_code_ = true;
  executor_.end_program(false);
  return state_ = State::kEnded;
}

CanonInterpreter::State CanonInterpreter::execute_words(std::size_t head) noexcept {
  ValueReader reader(source_, executor_.parameters());
  reader.skip(head);
  Block block;
  Assignments assignments;
  if (!read_block(reader, block, assignments)) return fail(reader);
  if (!assign(assignments) || !say_comment()) return state_;
  if (const std::optional<Error> error = executor_.execute(block)) return fail(*error);
  if (!executor_.in_cycle()) after_block();
  return state_;
}

bool CanonInterpreter::assign(const Assignments& assignments) noexcept {
  Parameters& parameters = executor_.parameters();
  for (std::size_t i = 0; i < assignments.count; ++i) {
    const Assignments::One& one = assignments.list[i];
    const std::optional<ErrorCode> problem =
        one.name.empty() ? parameters.set(one.number, one.value) : parameters.set(one.name, one.value);
    if (!problem) continue;
    fail({.code = *problem, .column = source_.column(one.position)});
    return false;
  }
  return true;
}

bool CanonInterpreter::say_comment() noexcept {
  if (!source_.comment()) return true;
  ExpandedComment comment;
  comment.expand(*source_.comment(), executor_.parameters());
  executor_.say(comment.kind(), comment.text());
  if (comment.aborts()) fail({.code = ErrorCode::kAborted});
  return !comment.aborts();
}

void CanonInterpreter::after_block() noexcept {
  switch (executor_.after()) {
    case Executor::After::kNext:
      return;
    case Executor::After::kStop:
      state_ = State::kStopped;
      return;
    case Executor::After::kWaitInput:
      state_ = State::kWaitsForInput;
      return;
    case Executor::After::kEnd:
      state_ = State::kEnded;
      return;
  }
}

void CanonInterpreter::resume() noexcept {
  if (state_ == State::kStopped) state_ = State::kRunning;
}

void CanonInterpreter::give_input(double value) noexcept {
  if (state_ != State::kWaitsForInput) return;
  executor_.give_input(value);
  state_ = State::kRunning;
}

CanonInterpreter::State CanonInterpreter::fail(Error error) noexcept {
  if (error.line == 0) error.line = line_;
  error_ = error;
  return state_ = State::kFailed;
}

void CanonInterpreter::go_to(const OWord& word, bool behind) noexcept {
  at_ = behind ? word.next : word.begin;
  passed_ = behind ? word.line : word.line - 1;
}

}  // namespace armature::gcode
