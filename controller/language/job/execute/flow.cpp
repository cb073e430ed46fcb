#include "controller/language/job/execute/flow.hpp"

#include "controller/language/job/state/expression.hpp"

namespace armature::job {

Alarm Flow::start(std::size_t job, std::uint32_t line) noexcept {
  calls_[0] = {};
  depth_ = 1;
  const std::span records = memory_.records_of(memory_.jobs[job]);
  std::uint16_t at = 0;
  while (at + 1U < records.size() && records[at].line < line) ++at;
  stand_at({job, at});
  return variables_.enter(memory_.jobs[job]);
}

bool Flow::jump(Step& step, OperandReader& operands) noexcept {
  if (operands.is(OperandKind::kLabel)) {
    go_to(step.record().target);
    return true;
  }
  if (!operands.is(OperandKind::kJob)) return jump_to_label(step, operands);
  const auto to = static_cast<std::size_t>(operands.here().number);
  variables_.leave();
  current_ = next_ = {to, 0};  // the alarm of a job whose variables have no room is one of its first line
  return step.check(variables_.enter(memory_.jobs[to]));
}

// JUMP LABEL: the label whose name is a value.
bool Flow::jump_to_label(Step& step, OperandReader& operands) noexcept {
  double wanted = 0.0;
  operands.next();
  if (!operands.number(wanted)) return false;
  const auto name = FixedText<24>{} << static_cast<std::int64_t>(wanted);
  const std::span all = records();
  for (std::size_t to = 0; to < all.size(); ++to) {
    if (all[to].op != Op::kLabel || operands.of(all[to]).text() != name.view()) continue;
    go_to(to);
    return true;
  }
  return step.fail(Alarm::kLabel);
}

bool Flow::call(Step& step, OperandReader& operands) noexcept {
  if (depth_ == calls_.size()) return step.fail(Alarm::kCalls);
  Call& call = calls_[depth_];
  const auto to = static_cast<std::size_t>(operands.here().number);
  operands.next();
  if (!read_arguments(step, operands, call)) return false;
  if (!step.check(variables_.enter(memory_.jobs[to]))) return false;
  call.return_to = next_;
  next_ = {to, 0};
  ++depth_;
  return true;
}

bool Flow::read_arguments(Step& step, OperandReader& operands, Call& call) noexcept {
  call.argument_count = 0;
  while (operands.take(Word::kArgument)) {
    if (call.argument_count == kMaxArguments) return step.fail(Alarm::kArguments);
    Argument& argument = call.arguments[call.argument_count++];
    argument.is_position = operands.is_position_variable();
    if (argument.is_position) {
      const PositionValue* position = operands.position_variable();
      if (position == nullptr) return false;
      argument.position = *position;
    } else if (!operands.number(argument.number)) {
      return false;
    }
  }
  return true;
}

bool Flow::get_argument(Step& step, OperandReader& operands) noexcept {
  OperandReader source = operands;
  source.skip();
  if (!source.is(OperandKind::kIo) || source.io_here() != IoType::kArgument) return step.fail(Alarm::kTypes);
  double index = 0.0;
  if (!source.io_number(index)) return false;
  const Call& call = calls_[depth_ - 1];
  if (!(index >= 1.0 && index <= static_cast<double>(call.argument_count))) return step.fail(Alarm::kArguments);
  const Argument& argument = call.arguments[static_cast<std::size_t>(index) - 1];
  if (argument.is_position != operands.is_position_variable()) return step.fail(Alarm::kTypes);
  if (argument.is_position) {
    PositionValue* position = operands.position_variable();
    if (position != nullptr) *position = argument.position;
    return position != nullptr;
  }
  VariableId id;
  return operands.variable(id) && operands.store(id, argument.number);
}

bool Flow::return_value(Step& step, OperandReader& operands) noexcept {
  if (!operands.at_end() && !operands.is(Word::kIf) && !operands.is(Word::kIfExpress)) {
    double value = 0.0;
    if (!operands.number(value)) return false;
    variables_.set_returned(value);
  }
  return return_from_job(step, operands);
}

bool Flow::return_from_job(Step& step, OperandReader&) noexcept {
  if (depth_ <= 1) return step.end_program();
  next_ = calls_[--depth_].return_to;
  variables_.leave();
  return true;
}

// From IFTHEN to the first branch whose condition holds.
bool Flow::branch(Step& step, OperandReader& operands) noexcept {
  std::uint16_t at = step.at();
  while (true) {
    OperandReader condition = operands.of(step.record(at));
    bool holds = false;
    if (!read_condition(condition, holds)) return false;
    if (holds) break;
    at = step.record(at).target;
    const Op op = step.record(at).op;
    if (op != Op::kElseif && op != Op::kElseifexp) break;
  }
  go_to(at + 1U);
  return true;
}

bool Flow::select_case(Step& step, OperandReader& operands) noexcept {
  double wanted = 0.0;
  if (!operands.number(wanted)) return false;
  std::uint16_t to = step.record().target;
  for (; step.record(to).op == Op::kCase; to = step.record(to).target) {
    double value = 0.0;
    if (!operands.of(step.record(to)).number(value)) return false;
    if (value == wanted) break;
  }
  go_to(to + 1U);
  return true;
}

bool Flow::start_while(Step& step, OperandReader& operands) noexcept {
  bool holds = false;
  if (!read_condition(operands, holds)) return false;
  if (!holds) go_to(step.record().target + 1U);
  return true;
}

bool Flow::start_loop(Step& step, OperandReader& operands) noexcept {
  return loop(step, operands, step.at(), true);
}

bool Flow::repeat_loop(Step& step, OperandReader& operands) noexcept {
  const std::uint16_t start = step.record().partner;
  OperandReader of_start = operands.of(step.record(start));
  return loop(step, of_start, start, false);
}

// The last value and the step are those of now.
bool Flow::loop(Step& step, OperandReader& operands, std::uint16_t at, bool first) noexcept {
  VariableId id;
  double from = 0.0, to = 0.0, by = 1.0, value = 0.0;
  if (!operands.variable(id) || !operands.tag(1.0, from)) return false;
  operands.next();  // TO
  if (!operands.number(to)) return false;
  if (!operands.at_end() && !operands.tag(1.0, by)) return false;
  if (!operands.load(id, value)) return false;
  value = first ? from : value + by;
  const bool over = by < 0.0 ? value < to : value > to;
  // The variable keeps the value of the last round when the next one would not fit.
  if ((!over || first) && !operands.store(id, value)) return false;
  go_to(over ? step.record(at).target + 1U : at + 1U);
  return true;
}

bool Flow::go_to_partner(Step& step, OperandReader&) noexcept {
  go_to(step.record().partner);
  return true;
}

}  // namespace armature::job
