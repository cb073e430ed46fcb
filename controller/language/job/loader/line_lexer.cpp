#include "controller/language/job/loader/line_lexer.hpp"

#include <algorithm>
#include <utility>

#include "controller/language/job/memory/number_text.hpp"
#include "controller/language/job/memory/words.hpp"

namespace armature::job {
namespace {

constexpr int kDeepestIndex = 3;
constexpr std::size_t kMaxDigitsOfNumber = 5;

bool is_capital(char character) {
  return character >= 'A' && character <= 'Z';
}

bool is_name_end(char character) {
  return character == '\0' || character == ' ' || character == '\t';
}

// The capital letters at the start.
std::string_view capitals(std::string_view text) {
  std::size_t size = 0;
  while (size < text.size() && (is_capital(text[size]) || text[size] == '_')) ++size;
  return part(text, 0, size);
}

Operand word_operand(Word word) {
  return {.kind = OperandKind::kWord, .what = static_cast<std::uint8_t>(word)};
}

}  // namespace

std::optional<TextRef> add_text(ProgramMemory& memory, std::string_view text) noexcept {
  if (text.size() > memory.text.size() - memory.text_size) return std::nullopt;
  const TextRef ref{static_cast<std::uint16_t>(memory.text_size), static_cast<std::uint16_t>(text.size())};
  std::copy(text.begin(), text.end(), memory.text.begin() + static_cast<std::ptrdiff_t>(memory.text_size));
  memory.text_size += text.size();
  return ref;
}

bool LineLexer::lex(std::size_t from, LexedLine& result) noexcept {
  at_ = from;
  while (true) {
    const std::size_t start = at_;
    while (peek() == ' ') ++at_;
    const std::size_t blanks = at_ - start;
    if (blanks > 255) return fail(start, "more than 255 blanks");
    gap_ = static_cast<std::uint8_t>(blanks);
    if (at_ == line_.size()) {
      result.blanks_after = gap_;
      return true;
    }
    if (!lex_one(result)) return false;
  }
}

bool LineLexer::lex_text(std::size_t from, LexedLine& result) noexcept {
  at_ = from;
  gap_ = 0;
  return at_ == line_.size() || lex_rest(result);
}

bool LineLexer::fail(std::size_t at, const DiagnosticText& text) noexcept {
  problem_ = {at + 1, text};
  return false;
}

bool LineLexer::add(LexedLine& result, const Operand& operand, std::size_t size) noexcept {
  if (result.count == result.operands.size()) return fail(at_, "more than 100 operands in one line");
  result.columns[result.count] = static_cast<std::uint16_t>(at_ + 1);
  Operand& added = result.operands[result.count++] = operand;
  added.gap = std::exchange(gap_, std::uint8_t{0});
  at_ += size;
  return true;
}

bool LineLexer::after_value(const LexedLine& result) const noexcept {
  if (result.count == 0) return false;
  const Operand& before = result.operands[result.count - 1];
  switch (before.kind) {
    case OperandKind::kNumber:
    case OperandKind::kVariable:
    case OperandKind::kIo:
      return true;
    case OperandKind::kWord:
      return before.what == static_cast<std::uint8_t>(Word::kClose);
    default:
      return false;
  }
}

bool LineLexer::lex_one(LexedLine& result) noexcept {
  const char first = peek();
  if (first == '/' && peek(1) == '/') return lex_rest(result);
  if (first == '"') return lex_quoted(result);
  if (first == '$') return lex_system(result);
  if (first == '*' && !is_name_end(peek(1)) && !after_value(result)) return lex_name(result, OperandKind::kLabel, 1);
  if (is_digit(first) || first == '.') return lex_number(result);
  if (is_capital(first)) return lex_identifier(result);
  return lex_sign(result);
}

bool LineLexer::lex_sign(LexedLine& result) noexcept {
  const bool sign = peek() == '+' || peek() == '-';
  if (sign && peek() == '+' && is_move(op_) && is_capital(peek(1))) {
    result.unsupported = true;
    return lex_rest(result);
  }
  if (sign && (is_digit(peek(1)) || peek(1) == '.') && !(after_value(result) && gap_ == 0)) return lex_number(result);
  for (std::size_t size = 2; size > 0; --size) {
    const std::string_view name = part(rest(), 0, size);
    const auto word = named<Word>(kWordNames, name);
    if (word) return add(result, word_operand(*word), name.size());
  }
  const char unknown = peek();
  if (unknown == '\t') return fail(at_, "a tab between operands; expected blanks");
  if (unknown < ' ' || unknown > '~') return fail(at_, "a character that is not ASCII");
  return fail(at_, DiagnosticText{"unexpected '"} << unknown << "'");
}

bool LineLexer::add_number(LexedLine& result, Operand& operand) noexcept {
  const auto number = read_number(rest());
  if (!number) return fail(at_, "not a number of at most 15 digits, with digits behind its point");
  operand.number = number->value;
  operand.form = number->form;
  operand.a = number->exponent_form == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(number->exponent + 1'000);
  operand.b = number->exponent_form;
  return add(result, operand, number->size);
}

bool LineLexer::lex_number(LexedLine& result) noexcept {
  Operand operand{.kind = OperandKind::kNumber};
  return add_number(result, operand);
}

bool LineLexer::lex_quoted(LexedLine& result) noexcept {
  const std::size_t end = place_where(
      line_, [](char character) { return character == '"'; }, at_ + 1);
  if (end == line_.size()) return fail(at_, "the text has no closing quotation mark");
  const auto text = add_text(memory_, part(line_, at_ + 1, end - at_ - 1));
  if (!text) return fail(at_, "the program memory has no room for more text");
  Operand operand{.kind = OperandKind::kQuoted};
  set_text(operand, *text);
  return add(result, operand, end + 1 - at_);
}

bool LineLexer::lex_rest(LexedLine& result) noexcept {
  const auto text = add_text(memory_, rest());
  if (!text) return fail(at_, "the program memory has no room for more text");
  Operand operand{.kind = OperandKind::kText};
  set_text(operand, *text);
  return add(result, operand, rest().size());
}

bool LineLexer::lex_name(LexedLine& result, OperandKind kind, std::size_t skip) noexcept {
  std::size_t size = skip;
  while (!is_name_end(peek(size))) ++size;
  if (size == skip) return fail(at_ + skip, "expected a name");
  if (size - skip > 32) return fail(at_ + skip, "a name of more than 32 characters");
  const auto text = add_text(memory_, part(rest(), skip, size - skip));
  if (!text) return fail(at_, "the program memory has no room for more text");
  Operand operand{.kind = kind};
  set_text(operand, *text);
  return add(result, operand, size);
}

bool LineLexer::starts_foreign_part(std::string_view letters) const noexcept {
  if (op_ == Op::kMframe) return letters == "MTOOL";
  if (op_ == Op::kClear) return letters == "MPF" || letters == "STACK";
  if (!is_move(op_)) return false;
  constexpr std::array<std::string_view, 10> kForeign{"BC",  "EC", "BP",   "EX",    "LBP",
                                                      "LEX", "T",  "SRCH", "UNTIL", "NWAIT"};
  if (letters == "UNTIL" && may_end_early(op_)) return false;
  const bool tag = peek(letters.size()) == '=';
  return !tag && std::find(kForeign.begin(), kForeign.end(), letters) != kForeign.end();
}

bool LineLexer::lex_identifier(LexedLine& result) noexcept {
  const std::string_view letters = capitals(rest());
  if (starts_foreign_part(letters)) {
    result.unsupported = true;
    return lex_rest(result);
  }
  const char next = peek(letters.size());
  if (next == '#') return lex_io(result, letters);
  if (next == ':' && letters == "JOB") return lex_name(result, OperandKind::kJob, 4);
  if (next == ':' && letters == "LABEL") return add(result, word_operand(Word::kLabelOf), 6);
  constexpr std::string_view kArgument = "ARGF";
  if (part(letters, 0, kArgument.size()) == kArgument) {
    return add(result, word_operand(Word::kArgument), kArgument.size());
  }
  const auto tag = named<TagName>(kTagNames, letters);
  if (tag && next == '=') return lex_tag(result, *tag, letters.size());
  if (is_digit(next) || next == '[') return lex_variable(result, letters);
  const auto word = named<Word>(kWordNames, letters);
  if (word) return add(result, word_operand(*word), letters.size());
  return fail(at_, DiagnosticText{"unknown word '"} << letters << "'");
}

bool LineLexer::lex_io(LexedLine& result, std::string_view name) noexcept {
  const auto type = named<IoType>(kIoNames, name);
  if (!type) return fail(at_, DiagnosticText{"unknown '"} << name << "#'");
  if (peek(name.size() + 1) != '(') return fail(at_ + name.size() + 1, "expected '(' and a number");
  const std::size_t place = result.count;
  if (!add(result, {.kind = OperandKind::kIo, .what = static_cast<std::uint8_t>(*type), .flags = Operand::kIndexed},
           name.size() + 2)) {
    return false;
  }
  return lex_index(result, ')') && place < result.count;
}

bool LineLexer::lex_index(LexedLine& result, char close) noexcept {
  if (depth_ == kDeepestIndex) return fail(at_, "too many indices within each other");
  ++depth_;
  const bool lexed = is_digit(peek()) ? lex_number(result) : lex_variable(result, capitals(rest()));
  --depth_;
  if (!lexed) return false;
  if (peek() != close) return fail(at_, DiagnosticText{"expected '"} << close << "'");
  ++at_;
  return true;
}

bool LineLexer::lex_tag(LexedLine& result, TagName tag, std::size_t size) noexcept {
  const std::size_t column = at_ + 1;
  at_ += size + 1;
  Operand operand{.kind = OperandKind::kTag, .what = static_cast<std::uint8_t>(tag)};
  if (peek() == ' ' && (is_digit(peek(1)) || peek(1) == '-')) {
    operand.flags = Operand::kBlankAfter;
    ++at_;
  }
  const bool constant = is_digit(peek()) || peek() == '.' || peek() == '-' || peek() == '+';
  if (!constant) operand.flags |= Operand::kIndexed;
  if (constant ? !add_number(result, operand) : !add(result, operand, 0)) return false;
  result.columns[result.count - 1] = static_cast<std::uint16_t>(column);
  return true;
}

bool LineLexer::lex_variable(LexedLine& result, std::string_view letters) noexcept {
  std::string_view name = letters;
  Operand operand{.kind = OperandKind::kVariable};
  if (const auto letter = named<PositionLetter>(kPositionNames, name); letter && *letter <= PositionLetter::kEc) {
    operand.kind = OperandKind::kPosition;
    operand.what = static_cast<std::uint8_t>(*letter);
  } else {
    if (name.size() > 1 && name.front() == 'L') {
      operand.flags |= Operand::kLocal;
      name.remove_prefix(1);
    }
    if (name == "PX") {
      operand.flags |= Operand::kWithX;
      name.remove_suffix(1);
    }
    const auto type = named<VariableType>(kVariableNames, name);
    if (!type || *type == VariableType::kReturn)
      return fail(at_, DiagnosticText{"unknown variable '"} << letters << "'");
    operand.what = static_cast<std::uint8_t>(*type);
  }
  const std::size_t size = letters.size();
  if (peek(size) == '[') {
    if (operand.kind == OperandKind::kPosition) return fail(at_, "positions of a job have no index");
    operand.flags |= Operand::kIndexed;
    return add(result, operand, size + 1) && lex_index(result, ']');
  }
  std::size_t digits = 0;
  std::uint32_t number = 0;
  while (is_digit(peek(size + digits))) {
    number = 10 * number + static_cast<std::uint32_t>(peek(size + digits) - '0');
    if (++digits > kMaxDigitsOfNumber) return fail(at_, "a number of more than 5 digits");
  }
  if (digits == 0) return fail(at_, DiagnosticText{"expected a number behind '"} << letters << "'");
  if (number >= kNowhere) return fail(at_, "a number above 65534");
  operand.a = static_cast<std::uint16_t>(number);
  operand.b = static_cast<std::uint8_t>(digits);
  return add(result, operand, size + digits);
}

bool LineLexer::lex_system(LexedLine& result) noexcept {
  ++at_;
  const std::string_view letters = capitals(rest());
  const std::size_t place = result.count;
  if (letters == "RV") {
    const Operand operand{.kind = OperandKind::kVariable, .what = static_cast<std::uint8_t>(VariableType::kReturn)};
    if (!add(result, operand, letters.size())) return false;
  } else if (!lex_variable(result, letters)) {
    return false;
  }
  result.operands[place].flags |= Operand::kSystem;
  --result.columns[place];
  return true;
}

}  // namespace armature::job
