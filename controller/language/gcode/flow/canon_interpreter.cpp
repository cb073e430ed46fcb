#include "controller/language/gcode/flow/canon_interpreter.hpp"

#include "controller/language/gcode/flow/comment.hpp"
#include "controller/language/gcode/flow/o_word_text.hpp"

namespace armature::gcode {

CanonInterpreter::State CanonInterpreter::begin(const ProgramText& program, const Options& options) noexcept {
  program_ = program;
  options_ = options;
  line_ = 0;
  percent_ = ended_without_code_ = false;
  state_ = State::kRunning;
  executor_.begin_program(options.start);
  if (const Failure failure = flow_.begin(program, source_)) return fail(*failure);
  return state_;
}

CanonInterpreter::State CanonInterpreter::step() noexcept {
  if (state_ != State::kRunning) return state_;
  if (executor_.in_cycle()) {
    executor_.continue_cycle();
    if (!executor_.in_cycle()) after_block();
    return state_;
  }
  if (program_.file_ends(flow_.next())) return end_of_file();
  line_ = flow_.next_line();
  const LineSpan span = line_at(program_.text, flow_.next());
  const OWord* const o_word = flow_.index().at_line(span.begin);
  executor_.begin_line(line_);
  flow_.pass(span);
  if (const auto error = source_.read(program_.text.substr(span.begin, span.end - span.begin))) return fail(*error);
  const std::string_view text = source_.text();
  if (text == "%") {
    if (!program_.in_main(span.begin)) return state_;
    if (percent_) return state_ = State::kEnded;
    percent_ = true;
    return state_;
  }
  if (options_.block_delete && text.starts_with('/')) return state_;
  if (o_word != nullptr) return execute_o_word(*o_word);
  return execute_words();
}

CanonInterpreter::State CanonInterpreter::end_of_file() noexcept {
  if (flow_.in_call()) return fail({.code = ErrorCode::kSubprogramNotEnded});
  ended_without_code_ = true;
  return end_program();
}

CanonInterpreter::State CanonInterpreter::end_program() noexcept {
  executor_.end_program(false);
  return state_ = State::kEnded;
}

CanonInterpreter::State CanonInterpreter::execute_o_word(const OWord& word) noexcept {
  if (flow_.skip(word)) return state_;
  ValueReader reader = line_reader();
  OWordValues values;
  if (const Failure failure = read_values(word, flow_.index(), reader, values)) return fail(*failure);
  if (!say_comment()) return state_;
  if (word.keyword == Keyword::kEndProgram && !flow_.in_call()) return end_program();
  if (const Failure failure = flow_.execute(word, values)) return fail(*failure);
  return state_;
}

CanonInterpreter::State CanonInterpreter::execute_words() noexcept {
  ValueReader reader = line_reader();
  Block block;
  Assignments assignments;
  if (!read_block(reader, block, assignments)) return fail(*reader.error());
  if (!assign(assignments) || !say_comment()) return state_;
  if (const Failure failure = executor_.execute(block)) return fail(*failure);
  if (!executor_.in_cycle()) after_block();
  return state_;
}

// Behind block delete and line number.
ValueReader CanonInterpreter::line_reader() noexcept {
  ValueReader reader(source_, executor_.parameters());
  reader.skip(line_head(source_.text()));
  return reader;
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

}  // namespace armature::gcode
