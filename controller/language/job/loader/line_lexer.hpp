// Splits the operands of one line into a list.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/job/memory/instruction.hpp"
#include "controller/language/job/memory/operand.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/text/diagnostics.hpp"
#include "controller/language/text/parts.hpp"

namespace armature::job {

inline constexpr std::size_t kMaxOperandsOfLine = 100;

struct LexedLine {
  std::array<Operand, kMaxOperandsOfLine> operands{};
  std::array<std::uint16_t, kMaxOperandsOfLine> columns{};  // from 1
  std::size_t count = 0;
  std::uint8_t blanks_after = 0;
  bool unsupported = false;  // the rest of the line is a form that cannot be executed
};

struct LexProblem {
  std::size_t column = 0;  // from 1
  DiagnosticText text{};
};

// Adds a text to the pool of the memory; nothing if it is full.
[[nodiscard]] std::optional<TextRef> add_text(ProgramMemory& memory, std::string_view text) noexcept;

class LineLexer {
 public:
  // References must outlive the lexer. `op`: what the rest of the line belongs to.
  LineLexer(ProgramMemory& memory, std::string_view line, Op op) noexcept : memory_{memory}, line_{line}, op_{op} {}

  // The operands from this place of the line to its end; nothing after a problem(). Texts go to the memory.
  [[nodiscard]] bool lex(std::size_t from, LexedLine& result) noexcept;
  // The rest of the line as one text.
  [[nodiscard]] bool lex_text(std::size_t from, LexedLine& result) noexcept;
  [[nodiscard]] const LexProblem& problem() const noexcept { return problem_; }

 private:
  [[nodiscard]] bool lex_one(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_identifier(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_number(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_quoted(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_sign(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_name(LexedLine& result, OperandKind kind, std::size_t skip) noexcept;
  [[nodiscard]] bool lex_io(LexedLine& result, std::string_view name) noexcept;
  [[nodiscard]] bool lex_tag(LexedLine& result, TagName tag, std::size_t size) noexcept;
  [[nodiscard]] bool lex_variable(LexedLine& result, std::string_view letters) noexcept;
  [[nodiscard]] bool lex_system(LexedLine& result) noexcept;
  [[nodiscard]] bool lex_index(LexedLine& result, char close) noexcept;
  [[nodiscard]] bool lex_rest(LexedLine& result) noexcept;
  [[nodiscard]] bool add_number(LexedLine& result, Operand& operand) noexcept;
  [[nodiscard]] bool add(LexedLine& result, const Operand& operand, std::size_t size) noexcept;
  [[nodiscard]] bool starts_foreign_part(std::string_view letters) const noexcept;
  [[nodiscard]] bool after_value(const LexedLine& result) const noexcept;
  [[nodiscard]] bool fail(std::size_t at, const DiagnosticText& text) noexcept;
  [[nodiscard]] std::string_view rest() const noexcept { return part(line_, at_); }
  [[nodiscard]] char peek(std::size_t ahead = 0) const noexcept {
    return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0';
  }

  ProgramMemory& memory_;
  std::string_view line_;
  Op op_;
  std::size_t at_ = 0;
  std::uint8_t gap_ = 0;
  int depth_ = 0;  // of indices within indices
  LexProblem problem_{};
};

}  // namespace armature::job
