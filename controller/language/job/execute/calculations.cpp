#include "controller/language/job/execute/calculations.hpp"

#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/language/job/state/expression.hpp"

namespace armature::job {
namespace {

constexpr double kUnitsPerMm = 1'000.0;
constexpr double kUnitsPerDegree = 10'000.0;

std::int64_t bits_of(double value) noexcept {
  return static_cast<std::int64_t>(value);
}

// The new value of a variable. B is a byte, so its bits are inverted within a byte.
Alarm calculated(Op op, VariableType type, double a, double b, double& result) noexcept {
  switch (op) {
    case Op::kAdd:
      result = a + b;
      break;
    case Op::kSub:
      result = a - b;
      break;
    case Op::kMul:
      result = a * b;
      break;
    case Op::kDiv:
      if (b == 0.0) return Alarm::kDivision;
      result = a / b;
      break;
    case Op::kInc:
      result = a + 1.0;
      break;
    case Op::kDec:
      result = a - 1.0;
      break;
    case Op::kAnd:
      result = static_cast<double>(bits_of(a) & bits_of(b));
      break;
    case Op::kOr:
      result = static_cast<double>(bits_of(a) | bits_of(b));
      break;
    case Op::kXor:
      result = static_cast<double>(bits_of(a) ^ bits_of(b));
      break;
    case Op::kNot:
      result = static_cast<double>(type == VariableType::kB ? ~bits_of(b) & 0xFF : ~bits_of(b));
      break;
    case Op::kSqrt:
      if (b < 0.0) return Alarm::kDivision;
      result = std::sqrt(b);
      break;
    case Op::kSin:
      result = math::sin(direction_rad(b));
      break;
    case Op::kCos:
      result = math::cos(direction_rad(b));
      break;
    default:
      result = math::atan2(b, 1.0) / kRadPerDeg;
      break;
  }
  return Alarm::kNone;
}

// How many units of SETE and GETE one unit of a position has.
double units_of(const PositionValue& position, std::size_t element) noexcept {
  if (position.frame == Frame::kPulse) return 1.0;
  return position.is_cartesian() && element < 3 ? kUnitsPerMm : kUnitsPerDegree;
}

// MUL and DIV by a number.
bool scale_position(Step& step, OperandReader& operands, PositionValue& result) noexcept {
  const bool multiply = step.record().op == Op::kMul;
  double factor = 0.0;
  if (!operands.number(factor)) return false;
  if (!multiply && factor == 0.0) return step.fail(Alarm::kDivision);
  for (double& value : result.value) value = multiply ? value * factor : value / factor;
  return true;
}

// ADD and SUB of two positions of one kind.
bool add_position(Step& step, OperandReader& operands, PositionValue& result) noexcept {
  const PositionValue* other = operands.set_position_variable();
  if (other == nullptr) return false;
  const bool alike = result.is_cartesian() ? other->is_cartesian() : other->frame == result.frame;
  if (!alike) return step.fail(Alarm::kTypes);
  const bool add = step.record().op == Op::kAdd;
  for (std::size_t i = 0; i < result.value.size(); ++i) result.value[i] += add ? other->value[i] : -other->value[i];
  return true;
}

bool calculate_position(Step& step, OperandReader& operands) noexcept {
  PositionValue* result = operands.position_variable();
  if (result == nullptr) return false;
  if (!result->set) return step.fail(Alarm::kNotSet);
  const Op op = step.record().op;
  const bool by_position = operands.is_position_variable();
  if (by_position && (op == Op::kAdd || op == Op::kSub)) return add_position(step, operands, *result);
  if (!by_position && (op == Op::kMul || op == Op::kDiv)) return scale_position(step, operands, *result);
  return step.fail(Alarm::kTypes);
}

bool assign_position(Step& step, OperandReader& operands) noexcept {
  PositionValue* to = operands.position_variable();
  if (to == nullptr) return false;
  if (!operands.is_position_variable()) return step.fail(Alarm::kTypes);
  const PositionValue* from = operands.position_variable();
  if (from == nullptr) return false;
  *to = *from;
  return true;
}

Alarm clear_variable(Variables& variables, const VariableId& id) noexcept {
  if (id.type != VariableType::kP) return variables.store(id, 0.0);
  PositionValue* position = variables.position(id);
  if (position == nullptr) return Alarm::kIndex;
  *position = {};
  return Alarm::kNone;
}

}  // namespace

bool calculate(Step& step, OperandReader& operands) noexcept {
  if (operands.is_position_variable()) return calculate_position(step, operands);
  VariableId id;
  double a = 0.0, b = 0.0, result = 0.0;
  if (!operands.variable(id) || !operands.load(id, a)) return false;
  if (!operands.at_end() && !operands.number(b)) return false;
  return step.check(calculated(step.record().op, id.type, a, b, result)) && operands.store(id, result);
}

bool assign(Step& step, OperandReader& operands) noexcept {
  if (operands.is_position_variable()) return assign_position(step, operands);
  VariableId id;
  double value = 0.0;
  if (!operands.variable(id)) return false;
  const bool read = operands.take(Word::kExpress) ? read_expression(step, operands, value) : operands.number(value);
  return read && operands.store(id, value);
}

bool clear(Step& step, OperandReader& operands) noexcept {
  VariableId id;
  if (!operands.variable(id)) return false;
  const bool all = operands.is(Word::kAll);
  double count = 1.0;
  if (!all && !operands.at_end() && !operands.number(count)) return false;
  if (!(count >= 0.0)) return step.fail(Alarm::kRange);
  for (double cleared = 0.0; all || cleared < count; cleared += 1.0, id.number += 1.0) {
    const Alarm alarm = clear_variable(operands.variables(), id);
    if (all && alarm == Alarm::kIndex && cleared > 0.0) break;
    if (!step.check(alarm)) return false;
  }
  return true;
}

bool set_element(Step& step, OperandReader& operands) noexcept {
  PositionValue* position = operands.position_variable();
  double element = 0.0, value = 0.0;
  if (position == nullptr || !operands.element(element) || !operands.number(value)) return false;
  if (!(element >= 0.0 && element <= 6.0)) return step.fail(Alarm::kIndex);
  // A variable that was not set becomes a position in the base.
  if (!position->set) *position = {.frame = Frame::kBase, .set = true};
  for (std::size_t i = 0; i < position->value.size(); ++i) {
    if (element == 0.0 || i + 1 == static_cast<std::size_t>(element)) {
      position->value[i] = value / units_of(*position, i);
    }
  }
  return true;
}

bool get_element(Step& step, OperandReader& operands) noexcept {
  VariableId id;
  if (!operands.variable(id)) return false;
  const PositionValue* position = operands.position_variable();
  double element = 0.0;
  if (position == nullptr || !operands.element(element)) return false;
  if (!(element >= 1.0 && element <= 6.0)) return step.fail(Alarm::kIndex);
  if (!position->set) return step.fail(Alarm::kNotSet);
  const std::size_t i = static_cast<std::size_t>(element) - 1;
  // 1e-6 of a unit is rounding: 0.3 mm are 300 units, not 299.
  const double units = position->value[i] * units_of(*position, i);
  const double rounded = std::floor(units + 0.5);
  const bool whole = std::fabs(units - rounded) < 1e-6;
  return operands.store(id, whole ? rounded : units);
}

}  // namespace armature::job
