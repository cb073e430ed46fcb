// How the machine calls jobs, and what it tells the operator.
#include <string_view>

#include "controller/language/job/machine.hpp"

namespace armature::job {

Machine::Outcome Machine::call() noexcept {
  bool holds = false;
  if (!guard(0, holds)) return outcome_;
  if (!holds) return Outcome::kNext;
  if (depth_ == calls_.size()) return (void)fail(Alarm::kCalls), outcome_;
  CallFrame& frame = calls_[depth_];
  frame.return_to = static_cast<std::uint16_t>(pc_ + 1);
  frame.job = static_cast<std::uint16_t>(job_);
  frame.argument_count = 0;
  for (std::size_t at = 1; is_word(at, Word::kArgument);) {
    ++at;
    if (frame.argument_count == kMostArguments) return (void)fail(Alarm::kArguments), outcome_;
    Argument& argument = frame.arguments[frame.argument_count++];
    argument.is_position = is_position_variable(at);
    if (argument.is_position) {
      const PositionValue* position = position_variable(at);
      if (position == nullptr) return outcome_;
      argument.position = *position;
    } else if (!number(at, argument.number)) {
      return outcome_;
    }
  }
  const auto to = static_cast<std::size_t>(operand(0).number);
  const std::size_t from = job_;
  const std::uint16_t from_record = pc_;
  if (const Alarm alarm = enter_job(to); alarm != Alarm::kNone) {
    job_ = from;  // the alarm is one of this line
    pc_ = from_record;
    return (void)fail(alarm), outcome_;
  }
  ++depth_;
  return Outcome::kJumped;
}

Machine::Outcome Machine::return_value() noexcept {
  bool holds = false;
  if (!guard(0, holds)) return outcome_;
  if (!holds) return Outcome::kNext;
  if (!operands_.empty() && !is_word(0, Word::kIf) && !is_word(0, Word::kIfExpress)) {
    std::size_t at = 0;
    double value = 0.0;
    if (!number(at, value)) return outcome_;
    returned_ = value;
  }
  return return_from_job();
}

Machine::Outcome Machine::return_from_job() noexcept {
  if (depth_ <= 1) return Outcome::kEnd;
  const CallFrame& frame = calls_[--depth_];
  variables_.leave();
  job_ = frame.job;
  return go_to(frame.return_to);
}

Machine::Outcome Machine::get_argument() noexcept {
  const bool to_position = is_position_variable(0);
  std::size_t behind = 0;
  skip(behind);
  std::size_t index_at = behind + 1;
  const bool argument_number = behind < operands_.size() && operand(behind).kind == OperandKind::kIo &&
                               operand(behind).what == static_cast<std::uint8_t>(IoType::kArgument);
  double index = 0.0;
  if (!argument_number) return (void)fail(Alarm::kTypes), outcome_;
  if (!number(index_at, index)) return outcome_;
  const CallFrame& frame = calls_[depth_ - 1];
  if (!(index >= 1.0 && index <= static_cast<double>(frame.argument_count))) {
    return (void)fail(Alarm::kArguments), outcome_;
  }
  const Argument& argument = frame.arguments[static_cast<std::size_t>(index) - 1];
  if (argument.is_position != to_position) return (void)fail(Alarm::kTypes), outcome_;
  std::size_t at = 0;
  if (to_position) {
    PositionValue* position = position_variable(at);
    if (position == nullptr) return outcome_;
    *position = argument.position;
    return Outcome::kNext;
  }
  VariableId id;
  return variable(at, id) && check(variables_.store(id, argument.number)) ? Outcome::kNext : outcome_;
}

Machine::Outcome Machine::show_message() noexcept {
  std::string_view text = operands_.empty() ? std::string_view{} : memory_.text_at(text_of(operand(0)));
  const auto bare = [](char character) { return character == ' ' || character == '"'; };
  while (!text.empty() && bare(text.front())) text.remove_prefix(1);
  while (!text.empty() && bare(text.back())) text.remove_suffix(1);
  note(ProgramNote::Kind::kMessage, text);
  return Outcome::kNext;
}

Machine::Outcome Machine::raise_user_alarm() noexcept {
  if (!wait_until_done()) return outcome_;
  std::size_t at = 0;
  double code = 0.0;
  if (!number(at, code)) return outcome_;
  const auto first = FixedText<32>{} << "SETUALM " << static_cast<std::int64_t>(code);
  note(ProgramNote::Kind::kAlarm, first.view(), memory_.text_at(text_of(operand(at))));
  return (void)fail(Alarm::kUser), outcome_;
}

}  // namespace armature::job
