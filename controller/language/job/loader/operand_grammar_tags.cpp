// The tags of instructions, and the ranges of constants.
#include <cmath>

#include "controller/language/job/loader/operand_grammar.hpp"

namespace armature::job {
namespace {

// The range of the constant of a tag.
struct TagRange {
  double least = 0.0, most = 0.0;
  bool whole = false;
};

constexpr std::array<TagRange, kCountOf<TagName>> kTagRanges{{
    {0.01, 100.0, false},                 // VJ
    {0.1, 30'000.0, false},               // V
    {0.1, 1'000.0, false},                // VR
    {0.1, 30'000.0, false},               // VE
    {0.0, 8.0, true},                     // PL
    {0.0, 1'000.0, false},                // CR
    {1.0, 100.0, true},                   // ACC
    {1.0, 100.0, true},                   // DEC
    {0.01, 655.35, false},                // T
    {-2147483648.0, 2147483647.0, true},  // START
    {-32768.0, 32767.0, true},            // STEP
    {0.0, 9.0, true},                     // SMODE
}};

}  // namespace

bool OperandGrammar::match_tags(const Instruction& instruction) noexcept {
  std::uint32_t seen = 0;
  while (!at_end()) {
    if ((is_arc(instruction.op) || instruction.op == Op::kMovs) && take(Word::kFpt)) continue;
    if (here().kind != OperandKind::kTag) break;
    const std::uint32_t tag = 1U << here().what;
    if ((instruction.tags & tag) == 0) {
      problem_.text = DiagnosticText{instruction.name} << " has no " << kTagNames[here().what] << '=';
      problem_.column = line_.columns[at_];
      return false;
    }
    if ((seen & tag) != 0) return expected("each tag once");
    seen |= tag;
    if (!check_tag(here())) return false;
    const bool by_variable = (here().flags & Operand::kIndexed) != 0;
    ++at_;
    if (by_variable && !match_tag_variable()) return false;
  }
  if ((instruction.op == Op::kTimer || instruction.op == Op::kWait) && seen == 0 && line_.count == seen) {
    return expected(instruction.op == Op::kTimer ? std::string_view{"T= and seconds"}
                                                 : std::string_view{"a condition, or T= and seconds"});
  }
  return true;
}

bool OperandGrammar::check_tag(const Operand& tag) noexcept {
  if ((tag.flags & Operand::kIndexed) != 0) return true;
  const TagRange& range = kTagRanges[tag.what];
  const double value = tag.number;
  if (value >= range.least && value <= range.most && (!range.whole || std::floor(value) == value)) return true;
  const auto number = [&](double x) {
    const auto hundredths = static_cast<std::int64_t>(std::floor(std::fabs(x) * 100.0 + 0.5));
    if (x < 0.0) problem_.text << '-';
    problem_.text << hundredths / 100;
    if (hundredths % 100 != 0)
      problem_.text.operator<<('.').append_digits(static_cast<std::uint64_t>(hundredths % 100), 2);
  };
  problem_.column = line_.columns[at_];
  problem_.text = DiagnosticText{kTagNames[tag.what]}
                  << "= must be "
                  << (range.whole ? std::string_view{"a whole number from "} : std::string_view{"from "});
  number(range.least);
  problem_.text << " to ";
  number(range.most);
  return false;
}

bool OperandGrammar::match_loop(const Instruction& instruction) noexcept {
  if (at_end() || here().kind != OperandKind::kTag || here().what != static_cast<std::uint8_t>(TagName::kStart)) {
    return expected("START= and the first value");
  }
  const bool by_variable = (here().flags & Operand::kIndexed) != 0;
  if (!check_tag(here())) return false;
  ++at_;
  if (by_variable && !match_tag_variable()) return false;
  if (!take(Word::kTo)) return expected("TO and the last value");
  return match_value() && match_tags(instruction);
}

bool OperandGrammar::check_ranges() noexcept {
  for (at_ = 0; !at_end(); ++at_) {
    const Operand& operand = here();
    const bool counted = operand.kind == OperandKind::kVariable && (operand.flags & Operand::kIndexed) == 0;
    if (counted && operand.a >= kVariablesOfType) return expected("a variable number below 256");
    if (operand.kind == OperandKind::kIo && at_ + 1 < line_.count) {
      const Operand& index = line_.operands[at_ + 1];
      const bool first = operand.what == static_cast<std::uint8_t>(IoType::kUserFrame) ||
                         operand.what == static_cast<std::uint8_t>(IoType::kTool);
      if (index.kind == OperandKind::kNumber && index.number < (first ? 0.0 : 1.0)) return expected("a number from 1");
    }
  }
  return true;
}

}  // namespace armature::job
