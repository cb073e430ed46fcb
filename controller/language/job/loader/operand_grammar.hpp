// Checks the operands of a line against the pattern of its instruction, and the ranges of constants.
#pragma once

#include "controller/language/job/loader/line_lexer.hpp"
#include "controller/language/job/memory/instruction.hpp"

namespace armature::job {

// The numbers of variables of each type begin with 0.
inline constexpr std::uint16_t kVariablesOfType = 256;

class OperandGrammar {
 public:
  // References must outlive the object.
  OperandGrammar(const LexedLine& line, std::size_t end_column) noexcept : line_{line}, end_column_{end_column} {}

  [[nodiscard]] bool matches(const Instruction& instruction) noexcept;
  [[nodiscard]] const LexProblem& problem() const noexcept { return problem_; }

 private:
  [[nodiscard]] bool is_left_out(char letter) const noexcept;
  [[nodiscard]] bool match(char letter, const Instruction& instruction) noexcept;
  [[nodiscard]] bool match_move_target() noexcept;
  [[nodiscard]] bool match_variable(std::uint32_t types, std::string_view expected) noexcept;
  [[nodiscard]] bool match_tag_variable() noexcept;
  [[nodiscard]] bool match_value() noexcept;
  [[nodiscard]] bool match_expression() noexcept;
  [[nodiscard]] bool match_condition() noexcept;
  [[nodiscard]] bool match_guard() noexcept;
  [[nodiscard]] bool match_until() noexcept;
  [[nodiscard]] bool match_element() noexcept;
  [[nodiscard]] bool match_io(std::uint32_t types, std::string_view expected) noexcept;
  [[nodiscard]] bool match_frame() noexcept;
  [[nodiscard]] bool match_jump() noexcept;
  [[nodiscard]] bool match_kind(OperandKind kind, std::string_view expected) noexcept;
  [[nodiscard]] bool match_arguments() noexcept;
  [[nodiscard]] bool match_tags(const Instruction& instruction) noexcept;
  [[nodiscard]] bool match_loop(const Instruction& instruction) noexcept;
  [[nodiscard]] bool check_tag(const Operand& tag) noexcept;
  [[nodiscard]] bool check_ranges() noexcept;

  [[nodiscard]] bool at_end() const noexcept { return at_ >= line_.count; }
  [[nodiscard]] const Operand& here() const noexcept { return line_.operands[at_]; }
  [[nodiscard]] bool is_kind(OperandKind kind) const noexcept { return !at_end() && here().kind == kind; }
  [[nodiscard]] bool is_word(Word word) const noexcept {
    return is_kind(OperandKind::kWord) && here().what == static_cast<std::uint8_t>(word);
  }
  [[nodiscard]] bool take(Word word) noexcept;
  void skip() noexcept;  // the operand here with its index
  [[nodiscard]] bool expected(std::string_view what) noexcept;

  const LexedLine& line_;
  std::size_t end_column_;
  std::size_t at_ = 0;
  LexProblem problem_{};
};

}  // namespace armature::job
