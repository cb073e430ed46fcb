// Calculations and conditions among the operands of a record. False: one could not be read, and the step says why.
#pragma once

#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"

namespace armature::job {

// value { + - * / value } with parentheses.
[[nodiscard]] bool read_expression(Step& step, OperandReader& operands, double& value) noexcept;
// AND binds before OR.
[[nodiscard]] bool read_condition(OperandReader& operands, bool& holds) noexcept;
// The condition behind IF, anywhere from here on; none holds.
[[nodiscard]] bool read_guard(OperandReader operands, bool& holds) noexcept;

}  // namespace armature::job
