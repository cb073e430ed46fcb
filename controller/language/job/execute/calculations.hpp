// Instructions that calculate with variables. False: the step says why the record is not executed.
//
// Elements of positions in SETE and GETE are 0.001 mm and 0.0001 deg, or pulses.
#pragma once

#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"

namespace armature::job {

// ADD, SUB, MUL, DIV, INC, DEC, AND, OR, XOR, NOT, SQRT, SIN, COS, ATAN.
[[nodiscard]] bool calculate(Step& step, OperandReader& operands) noexcept;
// SET.
[[nodiscard]] bool assign(Step& step, OperandReader& operands) noexcept;
// CLEAR: from a variable on one, a number of them, or all of its type up to the last one.
[[nodiscard]] bool clear(Step& step, OperandReader& operands) noexcept;
// SETE and GETE.
[[nodiscard]] bool set_element(Step& step, OperandReader& operands) noexcept;
[[nodiscard]] bool get_element(Step& step, OperandReader& operands) noexcept;

}  // namespace armature::job
