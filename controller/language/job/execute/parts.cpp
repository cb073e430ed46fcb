#include "controller/language/job/execute/parts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "controller/language/job/execute/calculations.hpp"
#include "controller/language/job/memory/switches.hpp"
#include "controller/language/job/state/expression.hpp"

namespace armature::job {
namespace {

using Executor = bool (*)(Parts& parts, Step& step, OperandReader& operands) noexcept;

template <auto kFunction>
bool of(Parts&, Step& step, OperandReader& operands) noexcept {
  return kFunction(step, operands);
}
template <auto kPart, auto kFunction>
bool of(Parts& parts, Step& step, OperandReader& operands) noexcept {
  return (parts.*kPart.*kFunction)(step, operands);
}

// Instructions that need no part.
bool does_nothing(Step&, OperandReader&) noexcept {
  return true;
}

bool wait_for_arm(Step& step, OperandReader&) noexcept {
  return step.wait_until_done();
}

bool pause_program(Step& step, OperandReader&) noexcept {
  step.pause_after();
  return true;
}

bool abort_program(Step& step, OperandReader&) noexcept {
  return step.wait_until_done() && step.fail(Alarm::kAborted);
}

bool show_message(Step& step, OperandReader& operands) noexcept {
  std::string_view text = operands.text();
  const auto bare = [](char character) { return character == ' ' || character == '"'; };
  while (!text.empty() && bare(text.front())) text.remove_prefix(1);
  while (!text.empty() && bare(text.back())) text.remove_suffix(1);
  step.note(ProgramNote::Kind::kMessage, text);
  return true;
}

bool raise_user_alarm(Step& step, OperandReader& operands) noexcept {
  double code = 0.0;
  if (!step.wait_until_done() || !operands.number(code)) return false;
  const auto first = FixedText<32>{} << "SETUALM " << static_cast<std::int64_t>(code);
  step.note(ProgramNote::Kind::kAlarm, first.view(), operands.text());
  return step.fail(Alarm::kUser);
}

struct Row {
  Op op;
  Executor executor;
};
// Who executes an instruction, in the order of Op.
constexpr std::array kRows{
    Row{Op::kBlank, of<does_nothing>},
    Row{Op::kComment, of<does_nothing>},
    Row{Op::kLabel, of<does_nothing>},
    Row{Op::kComm, of<does_nothing>},
    Row{Op::kNop, of<does_nothing>},
    Row{Op::kEnd, of<&Parts::flow, &Flow::return_from_job>},
    Row{Op::kMovj, of<&Parts::motion, &Motion::move>},
    Row{Op::kMovl, of<&Parts::motion, &Motion::move>},
    Row{Op::kMovc, of<&Parts::motion, &Motion::move>},
    Row{Op::kMovs, of<&Parts::motion, &Motion::move>},
    Row{Op::kSmovl, of<&Parts::motion, &Motion::move>},
    Row{Op::kSmovc, of<&Parts::motion, &Motion::move>},
    Row{Op::kImov, of<&Parts::motion, &Motion::move_relative>},
    Row{Op::kRefp, of<does_nothing>},
    Row{Op::kSpeed, of<&Parts::motion, &Motion::set_speeds>},
    Row{Op::kSfton, of<&Parts::positions, &Positions::set_shift>},
    Row{Op::kSftof, of<&Parts::positions, &Positions::end_shift>},
    Row{Op::kMframe, of<&Parts::positions, &Positions::make_frame>},
    Row{Op::kCnvrt, of<&Parts::positions, &Positions::convert>},
    Row{Op::kGets, of<&Parts::positions, &Positions::get_system>},
    Row{Op::kSete, of<set_element>},
    Row{Op::kGete, of<get_element>},
    Row{Op::kSet, of<assign>},
    Row{Op::kAdd, of<calculate>},
    Row{Op::kSub, of<calculate>},
    Row{Op::kMul, of<calculate>},
    Row{Op::kDiv, of<calculate>},
    Row{Op::kInc, of<calculate>},
    Row{Op::kDec, of<calculate>},
    Row{Op::kAnd, of<calculate>},
    Row{Op::kOr, of<calculate>},
    Row{Op::kXor, of<calculate>},
    Row{Op::kNot, of<calculate>},
    Row{Op::kSqrt, of<calculate>},
    Row{Op::kSin, of<calculate>},
    Row{Op::kCos, of<calculate>},
    Row{Op::kAtan, of<calculate>},
    Row{Op::kClear, of<clear>},
    Row{Op::kJump, of<&Parts::flow, &Flow::jump>},
    Row{Op::kCall, of<&Parts::flow, &Flow::call>},
    Row{Op::kGetarg, of<&Parts::flow, &Flow::get_argument>},
    Row{Op::kRet, of<&Parts::flow, &Flow::return_value>},
    Row{Op::kPause, of<pause_program>},
    Row{Op::kAbort, of<abort_program>},
    Row{Op::kMsg, of<show_message>},
    Row{Op::kSetualm, of<raise_user_alarm>},
    Row{Op::kIfthenexp, of<&Parts::flow, &Flow::branch>},
    Row{Op::kIfthen, of<&Parts::flow, &Flow::branch>},
    Row{Op::kElseifexp, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kElseif, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kElse, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kEndif, of<does_nothing>},
    Row{Op::kWhileexp, of<&Parts::flow, &Flow::start_while>},
    Row{Op::kWhile, of<&Parts::flow, &Flow::start_while>},
    Row{Op::kEndwhile, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kFor, of<&Parts::flow, &Flow::start_loop>},
    Row{Op::kNext, of<&Parts::flow, &Flow::repeat_loop>},
    Row{Op::kSwitch, of<&Parts::flow, &Flow::select_case>},
    Row{Op::kCase, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kDefault, of<&Parts::flow, &Flow::go_to_partner>},
    Row{Op::kEndswitch, of<does_nothing>},
    Row{Op::kTimer, of<&Parts::pins, &Pins::dwell>},
    Row{Op::kWait, of<&Parts::pins, &Pins::wait>},
    Row{Op::kCwait, of<wait_for_arm>},
    Row{Op::kDout, of<&Parts::pins, &Pins::switch_outputs>},
    Row{Op::kDin, of<&Parts::pins, &Pins::read_pins>},
    Row{Op::kPulse, of<&Parts::pins, &Pins::pulse>},
};
static_assert(has_each_op(kRows));

}  // namespace

Alarm Parts::start(std::size_t job, std::uint32_t line) noexcept {
  variables.reset();
  variables.set_positions(memory);
  pins.reset();
  tools.reset();
  positions.reset();
  arm.reset();
  motion.reset();
  return flow.start(job, line);
}

bool Parts::execute(Step& step) noexcept {
  const Record& record = step.record();
  if (!is_supported(record.op)) {
    const std::optional<Switch> found = switch_of(record.op);
    const std::uint8_t pin = found ? setup.settings.pin_of(found->device) : std::uint8_t{0};
    return pin != 0 ? pins.switch_output(step, pin, found->on) : step.fail(Alarm::kUnsupported);
  }
  if ((record.flags & Record::kUnsupported) != 0) return step.fail(Alarm::kUnsupported);
  OperandReader operands{memory, variables, pins.levels(), step};
  const auto op = static_cast<std::size_t>(record.op);
  if (std::ranges::any_of(kInstructions[op].pattern, [](char operand) { return operand == 'g'; })) {
    bool holds = false;
    if (!read_guard(operands, holds)) return false;
    if (!holds) return true;
  }
  return kRows[op].executor(*this, step, operands);
}

void Parts::advance() noexcept {
  flow.advance();
  pins.finish_record();
  arm.finish_record();
}

}  // namespace armature::job
