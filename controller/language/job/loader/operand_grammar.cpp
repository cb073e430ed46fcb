#include "controller/language/job/loader/operand_grammar.hpp"

namespace armature::job {
namespace {

constexpr std::uint32_t bit(VariableType type) {
  return 1U << static_cast<unsigned>(type);
}
constexpr std::uint32_t bit(IoType type) {
  return 1U << static_cast<unsigned>(type);
}

constexpr std::uint32_t kNumeric =
    bit(VariableType::kB) | bit(VariableType::kI) | bit(VariableType::kD) | bit(VariableType::kR);
constexpr std::uint32_t kPositions = bit(VariableType::kP) | bit(VariableType::kBp) | bit(VariableType::kEx);
constexpr std::uint32_t kAnyVariable = kNumeric | kPositions | bit(VariableType::kS);
constexpr std::uint32_t kOutputs = bit(IoType::kOutput) | bit(IoType::kOutputGroup) | bit(IoType::kOutputHalfGroup);
constexpr std::uint32_t kInputs = kOutputs | bit(IoType::kInput) | bit(IoType::kInputGroup) |
                                  bit(IoType::kInputHalfGroup) | bit(IoType::kSpecificInput) |
                                  bit(IoType::kSpecificOutput) | bit(IoType::kRegister) | bit(IoType::kRobotInput);

}  // namespace

bool OperandGrammar::expected(std::string_view what) noexcept {
  problem_.column = at_end() ? end_column_ : line_.columns[at_];
  problem_.text = DiagnosticText{"expected "} << what;
  return false;
}

bool OperandGrammar::take(Word word) noexcept {
  if (!is_word(word)) return false;
  ++at_;
  return true;
}

void OperandGrammar::skip() noexcept {
  while (!at_end() && (here().flags & Operand::kIndexed) != 0 && here().kind != OperandKind::kTag) ++at_;
  ++at_;
}

bool OperandGrammar::matches(const Instruction& instruction) noexcept {
  bool optional = false;
  for (const char letter : instruction.pattern) {
    if (letter == '?') {
      optional = true;
      continue;
    }
    if (line_.unsupported && is_kind(OperandKind::kText)) break;
    if (optional && is_left_out(letter)) continue;
    if (!match(letter, instruction)) return false;
  }
  const bool comment_or_rest = is_move(instruction.op) || line_.unsupported;
  if (comment_or_rest && is_kind(OperandKind::kText)) ++at_;
  if (!at_end()) return expected("the end of the line");
  return check_ranges();
}

// Of an optional operand.
bool OperandGrammar::is_left_out(char letter) const noexcept {
  if (letter == 't') return false;  // match_tags() also checks that there is a tag where the line needs one
  if (letter == 'y') return !is_word(Word::kUntil);
  // WAIT T=1.00 has no condition, and RET IF ... no value.
  if (at_end() || is_kind(OperandKind::kTag)) return true;
  return letter != 'g' && (is_word(Word::kIf) || is_word(Word::kIfExpress));
}

bool OperandGrammar::match(char letter, const Instruction& instruction) noexcept {
  switch (letter) {
    case 'm':
      return match_move_target();
    case 'p':
      return match_variable(kPositions, "a position variable");
    case 'd':
      return match_variable(kAnyVariable, "a variable");
    case 'n':
      return match_variable(kNumeric, "a variable B, I, D or R");
    case 'v':
      return match_value();
    case 'e':
      return take(Word::kExpress) ? match_expression() : match_value();
    case 'x':
      return match_element();
    case 'i':
      return match_io(kInputs, "an input or output");
    case 'o':
      return match_io(kOutputs, "OT#, OG# or OGH#");
    case 's':
      return match_value();
    case 'c':
      static_cast<void>(take(Word::kForExpress));
      return match_condition();
    case 'g':
      return match_guard();
    case 'l':
      return match_jump();
    case 'j':
      return match_kind(OperandKind::kJob, "JOB: and a name");
    case 'a':
      return match_arguments();
    case 'f':
      return match_frame();
    case 'u':
      return match_io(bit(IoType::kUserFrame), "UF# and a number");
    case 'k':
      return match_io(bit(IoType::kTool), "TL# and a number");
    case 'q':
      return match_kind(OperandKind::kQuoted, "a text in quotation marks");
    case 't':
      return match_tags(instruction);
    case 'h':
      return match_loop(instruction);
    case 'y':
      return match_until();
    default:
      return true;
  }
}

bool OperandGrammar::match_kind(OperandKind kind, std::string_view what) noexcept {
  if (!is_kind(kind)) return expected(what);
  ++at_;
  return true;
}

bool OperandGrammar::match_variable(std::uint32_t types, std::string_view what) noexcept {
  const bool fits =
      is_kind(OperandKind::kVariable) && (here().flags & Operand::kSystem) == 0 && (types >> here().what & 1U) != 0;
  if (!fits) return expected(what);
  skip();
  return true;
}

bool OperandGrammar::match_tag_variable() noexcept {
  return match_variable(kNumeric, "a number, or a variable B, I, D or R");
}

bool OperandGrammar::match_move_target() noexcept {
  if (is_kind(OperandKind::kPosition)) {
    ++at_;
    return true;
  }
  return match_variable(bit(VariableType::kP), "a position: C000, P000 or LP000");
}

bool OperandGrammar::match_value() noexcept {
  if (at_end()) return expected("a value");
  switch (here().kind) {
    case OperandKind::kNumber:
    case OperandKind::kQuoted:
      ++at_;
      return true;
    case OperandKind::kVariable:
    case OperandKind::kIo:
      skip();
      return true;
    case OperandKind::kWord:
      if (take(Word::kOn) || take(Word::kOff) || take(Word::kAll)) return true;
      if (take(Word::kMinus)) return match_value();
      break;
    default:
      break;
  }
  return expected("a value");
}

// value { + - * / value }, with parentheses around any part.
bool OperandGrammar::match_expression() noexcept {
  int open = 0;
  while (true) {
    while (is_word(Word::kOpen) || is_word(Word::kMinus)) {
      open += is_word(Word::kOpen) ? 1 : 0;
      ++at_;
    }
    if (!match_value()) return false;
    while (open > 0 && take(Word::kClose)) --open;
    if (!is_kind(OperandKind::kWord) || !is_calculation(static_cast<Word>(here().what))) break;
    ++at_;
  }
  return open == 0 || expected("')' or a calculation");
}

bool OperandGrammar::match_condition() noexcept {
  while (true) {
    if (!match_value()) return false;
    if (!is_kind(OperandKind::kWord) || !is_comparison(static_cast<Word>(here().what))) {
      return expected("one of = <> < <= > >=");
    }
    ++at_;
    if (!match_value()) return false;
    if (!take(Word::kAndExp) && !take(Word::kOrExp) && !take(Word::kAndIf) && !take(Word::kOrIf)) return true;
  }
}

bool OperandGrammar::match_guard() noexcept {
  return (!take(Word::kIf) && !take(Word::kIfExpress)) || match_condition();
}

bool OperandGrammar::match_until() noexcept {
  ++at_;
  if (!match_io(bit(IoType::kInput), "IN# and a number")) return false;
  if (!take(Word::kEqual)) return expected("'='");
  return take(Word::kOn) || take(Word::kOff) || expected("ON or OFF");
}

bool OperandGrammar::match_element() noexcept {
  if (!take(Word::kOpen)) return expected("the number of an element: (0) to (6)");
  if (!match_value()) return false;
  return take(Word::kClose) || expected("')'");
}

bool OperandGrammar::match_io(std::uint32_t types, std::string_view what) noexcept {
  if (!is_kind(OperandKind::kIo) || (types >> here().what & 1U) == 0) return expected(what);
  skip();
  return true;
}

bool OperandGrammar::match_frame() noexcept {
  if (take(Word::kBaseFrame) || take(Word::kRobotFrame) || take(Word::kToolFrame) || take(Word::kMasterTool))
    return true;
  return match_io(bit(IoType::kUserFrame), "BF, RF, TF or UF#");
}

bool OperandGrammar::match_jump() noexcept {
  if (take(Word::kLabelOf)) return match_value();
  if (is_kind(OperandKind::kLabel) || is_kind(OperandKind::kJob)) {
    ++at_;
    return true;
  }
  return expected("*LABEL, LABEL: and a variable, or JOB:NAME");
}

bool OperandGrammar::match_arguments() noexcept {
  while (take(Word::kArgument)) {
    if (!match_value()) return false;
  }
  return true;
}

}  // namespace armature::job
