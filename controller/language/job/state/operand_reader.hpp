// Reads the operands of a record from left to right: numbers, variables, pins and positions.
//
// What is read stands behind the reader then. False: it could not be read, and the step says why.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/pin_levels.hpp"
#include "controller/language/job/state/step.hpp"
#include "controller/language/job/state/variables.hpp"

namespace armature::job {

class OperandReader {
 public:
  // References must outlive the reader and its copies.
  OperandReader(const ProgramMemory& memory, Variables& variables, const PinLevels& levels, Step& step) noexcept
      : memory_{memory},
        variables_{variables},
        levels_{levels},
        step_{step},
        operands_{memory.operands_of(step.record())} {}
  // From the first operand of another record on.
  [[nodiscard]] OperandReader of(const Record& record) const noexcept {
    OperandReader other = *this;
    other.operands_ = memory_.operands_of(record);
    other.at_ = 0;
    return other;
  }

  [[nodiscard]] bool at_end() const noexcept { return at_ >= operands_.size(); }
  [[nodiscard]] const Operand& here() const noexcept { return operands_[at_]; }
  [[nodiscard]] bool is(OperandKind kind) const noexcept { return !at_end() && here().kind == kind; }
  [[nodiscard]] bool is(Word word) const noexcept { return is(OperandKind::kWord) && word == word_here(); }
  [[nodiscard]] bool is_position_variable() const noexcept;
  [[nodiscard]] Word word_here() const noexcept { return static_cast<Word>(here().what); }
  [[nodiscard]] IoType io_here() const noexcept { return static_cast<IoType>(here().what); }

  void next() noexcept { ++at_; }
  [[nodiscard]] bool take(Word word) noexcept;
  // Moves behind a value with its index.
  void skip() noexcept;
  // Moves to the word. False: there is none from here on.
  [[nodiscard]] bool find(Word word) noexcept;

  [[nodiscard]] bool number(double& value) noexcept;
  // 1 or 0 for one pin, otherwise the number that a group of pins shows.
  [[nodiscard]] bool pins(double& value) noexcept;
  // The number behind the name of an input, an output or a frame.
  [[nodiscard]] bool io_number(double& value) noexcept;
  // (n), an element of a position.
  [[nodiscard]] bool element(double& value) noexcept;
  // NAME=; `unit`: what 1 of a variable means.
  [[nodiscard]] bool tag(double unit, double& value) noexcept;
  [[nodiscard]] bool variable(VariableId& id) noexcept;
  // A position variable, and one that is set; null: could not be read.
  [[nodiscard]] PositionValue* position_variable() noexcept;
  [[nodiscard]] const PositionValue* set_position_variable() noexcept;
  // A position of the job, or a variable that is set.
  [[nodiscard]] bool position(PositionValue& value) noexcept;
  // The text of a label, or the rest of a line; empty at the end.
  [[nodiscard]] std::string_view text() const noexcept;

  [[nodiscard]] bool load(const VariableId& id, double& value) noexcept {
    return step_.check(variables_.load(id, value));
  }
  [[nodiscard]] bool store(const VariableId& id, double value) noexcept {
    return step_.check(variables_.store(id, value));
  }
  [[nodiscard]] Variables& variables() const noexcept { return variables_; }

 private:
  const ProgramMemory& memory_;
  Variables& variables_;
  const PinLevels& levels_;
  Step& step_;
  std::span<const Operand> operands_;
  std::size_t at_ = 0;
};

}  // namespace armature::job
