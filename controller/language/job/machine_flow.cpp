// How the machine goes from one instruction to the next: jumps and blocks.
#include "controller/language/job/machine.hpp"

namespace armature::job {

Machine::Outcome Machine::execute() noexcept {
  const Op op = here().op;
  if (const std::optional<Switch> found = is_supported(op) ? std::nullopt : switch_of(op)) {
    const std::uint8_t pin = setup_.settings.pin_of(found->device);
    if (pin != 0) return switch_output(pin, found->on);
  }
  if (!is_supported(op) || (here().flags & Record::kUnsupported) != 0) return (void)fail(Alarm::kUnsupported), outcome_;
  switch (op) {
    case Op::kMovj:
    case Op::kMovl:
    case Op::kMovc:
    case Op::kMovs:
    case Op::kSmovl:
    case Op::kSmovc:
      return move();
    case Op::kImov:
      return move_relative();
    case Op::kSpeed:
      return set_speeds();
    case Op::kSfton:
      return set_shift();
    case Op::kSftof:
      return base_shift_.reset(), tool_shift_.reset(), shift_mm_.reset(), Outcome::kNext;
    case Op::kMframe:
      return make_frame();
    case Op::kCnvrt:
      return convert();
    case Op::kGets:
      return get_system();
    case Op::kSete:
      return set_element();
    case Op::kGete:
      return get_element();
    case Op::kSet:
      return assign();
    case Op::kClear:
      return clear();
    case Op::kAdd:
    case Op::kSub:
    case Op::kMul:
    case Op::kDiv:
    case Op::kInc:
    case Op::kDec:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kNot:
    case Op::kSqrt:
    case Op::kSin:
    case Op::kCos:
    case Op::kAtan:
      return calculate();
    case Op::kGetarg:
      return get_argument();
    case Op::kMsg:
      return show_message();
    case Op::kSetualm:
      return raise_user_alarm();
    case Op::kTimer:
      return dwell();
    case Op::kWait:
      return wait();
    case Op::kCwait:
      return wait_until_done() ? Outcome::kNext : outcome_;
    case Op::kDout:
      return switch_outputs();
    case Op::kDin:
      return read_inputs();
    case Op::kPulse:
      return begin_pulse();
    default:
      return execute_flow(op);
  }
}

Machine::Outcome Machine::execute_flow(Op op) noexcept {
  switch (op) {
    case Op::kJump:
      return jump();
    case Op::kCall:
      return call();
    case Op::kRet:
      return return_value();
    case Op::kEnd:
      return return_from_job();
    case Op::kPause:
      return guarded(Outcome::kPause);
    case Op::kAbort:
      return (void)(wait_until_done() && fail(Alarm::kAborted)), outcome_;
    case Op::kIfthenexp:
    case Op::kIfthen:
      return branch();
    case Op::kElseifexp:
    case Op::kElseif:
    case Op::kElse:
    case Op::kCase:
    case Op::kDefault:
      return go_to(here().partner);  // the branch before ends here
    case Op::kWhileexp:
    case Op::kWhile: {
      std::size_t at = 0;
      bool holds = false;
      if (!condition(at, holds)) return outcome_;
      return holds ? Outcome::kNext : go_to(static_cast<std::uint16_t>(here().target + 1));
    }
    case Op::kEndwhile:
      return go_to(here().partner);
    case Op::kFor:
      return loop(true);
    case Op::kNext:
      return next_loop();
    case Op::kSwitch:
      return select_case();
    default:
      return Outcome::kNext;  // labels, comments, NOP, the ends of blocks, REFP
  }
}

Machine::Outcome Machine::go_to(std::uint16_t to) noexcept {
  pc_ = to;
  return Outcome::kJumped;
}

// From IFTHEN to the first branch whose condition holds.
Machine::Outcome Machine::branch() noexcept {
  std::uint16_t at_record = pc_;
  while (true) {
    operands_ = memory_.operands_of(record(at_record));
    std::size_t at = 0;
    bool holds = false;
    if (!condition(at, holds)) return outcome_;
    if (holds) return go_to(static_cast<std::uint16_t>(at_record + 1));
    at_record = record(at_record).target;
    const Op op = record(at_record).op;
    if (op != Op::kElseif && op != Op::kElseifexp) return go_to(static_cast<std::uint16_t>(at_record + 1));
  }
}

Machine::Outcome Machine::select_case() noexcept {
  std::size_t at = 0;
  double wanted = 0.0;
  if (!number(at, wanted)) return outcome_;
  std::uint16_t to = here().target;
  for (; record(to).op == Op::kCase; to = record(to).target) {
    operands_ = memory_.operands_of(record(to));
    at = 0;
    double value = 0.0;
    if (!number(at, value)) return outcome_;
    if (value == wanted) break;
  }
  return go_to(static_cast<std::uint16_t>(to + 1));
}

Machine::Outcome Machine::next_loop() noexcept {
  const std::uint16_t next = pc_;
  pc_ = here().partner;
  operands_ = memory_.operands_of(here());
  const Outcome outcome = loop(false);
  if (outcome == Outcome::kJumped || outcome == Outcome::kNext) {
    if (outcome == Outcome::kNext) ++pc_;
    return Outcome::kJumped;
  }
  pc_ = next;
  return outcome;
}

// At FOR: sets the variable, or adds the step to it. The last value and the step are those of now.
Machine::Outcome Machine::loop(bool first) noexcept {
  std::size_t at = 0;
  VariableId id;
  if (!variable(at, id)) return outcome_;
  double from = 0.0, to = 0.0, step = 1.0, value = 0.0;
  if (!tag_number(at, 1.0, from)) return outcome_;
  ++at;  // TO
  if (!number(at, to)) return outcome_;
  if (at < operands_.size() && !tag_number(at, 1.0, step)) return outcome_;
  if (!check(variables_.load(id, value))) return outcome_;
  value = first ? from : value + step;
  const bool over = step < 0.0 ? value < to : value > to;
  // The variable keeps the value of the last round when the next one would not fit.
  if ((!over || first) && !check(variables_.store(id, value))) return outcome_;
  return over ? go_to(static_cast<std::uint16_t>(here().target + 1)) : Outcome::kNext;
}

Machine::Outcome Machine::guarded(Outcome outcome) noexcept {
  bool holds = false;
  if (!guard(0, holds)) return outcome_;
  return holds ? outcome : Outcome::kNext;
}

Machine::Outcome Machine::jump() noexcept {
  bool holds = false;
  if (!guard(0, holds)) return outcome_;
  if (!holds) return Outcome::kNext;
  if (operand(0).kind == OperandKind::kLabel) return go_to(here().target);
  if (operand(0).kind == OperandKind::kJob) {
    const auto to = static_cast<std::size_t>(operand(0).number);
    variables_.leave();
    return check(enter_job(to)) ? Outcome::kJumped : outcome_;
  }
  std::size_t at = 1;
  double wanted = 0.0;
  if (!number(at, wanted)) return outcome_;
  const auto name = FixedText<24>{} << static_cast<std::int64_t>(wanted);
  for (std::uint16_t to = 0; to < memory_.jobs[job_].record_count; ++to) {
    if (record(to).op != Op::kLabel) continue;
    if (memory_.text_at(text_of(memory_.operands_of(record(to))[0])) == name.view()) return go_to(to);
  }
  return (void)fail(Alarm::kLabel), outcome_;
}

}  // namespace armature::job
