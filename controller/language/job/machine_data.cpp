// How the machine calculates with numbers.
#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/language/job/machine.hpp"

namespace armature::job {
namespace {

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

}  // namespace

Machine::Outcome Machine::calculate() noexcept {
  std::size_t at = 0;
  if (is_position_variable(at)) {
    PositionValue* position = position_variable(at);
    if (position == nullptr) return outcome_;
    return calculate_position(at, *position);
  }
  VariableId id;
  double a = 0.0, b = 0.0, result = 0.0;
  if (!variable(at, id) || !check(variables_.load(id, a))) return outcome_;
  if (at < operands_.size() && !number(at, b)) return outcome_;
  if (!check(calculated(here().op, id.type, a, b, result))) return outcome_;
  return check(variables_.store(id, result)) ? Outcome::kNext : outcome_;
}

Machine::Outcome Machine::assign() noexcept {
  std::size_t at = 0;
  if (is_position_variable(at)) {
    PositionValue* to = position_variable(at);
    if (to == nullptr) return outcome_;
    if (!is_position_variable(at)) return (void)fail(Alarm::kTypes), outcome_;
    const PositionValue* from = position_variable(at);
    if (from == nullptr) return outcome_;
    *to = *from;
    return Outcome::kNext;
  }
  VariableId id;
  if (!variable(at, id)) return outcome_;
  double value = 0.0;
  const bool calculation = is_word(at, Word::kExpress);
  if (calculation) ++at;
  if (calculation ? !expression(at, value) : !number(at, value)) return outcome_;
  return check(variables_.store(id, value)) ? Outcome::kNext : outcome_;
}

// From a variable on: one, a number of them, or all of its type up to the last one.
Machine::Outcome Machine::clear() noexcept {
  std::size_t at = 0;
  const bool positions = is_position_variable(at);
  VariableId id;
  if (!variable(at, id)) return outcome_;
  const bool all = is_word(at, Word::kAll);
  double count = 1.0;
  if (!all && at < operands_.size() && !number(at, count)) return outcome_;
  if (!(count >= 0.0)) return (void)fail(Alarm::kRange), outcome_;
  for (double cleared = 0.0; all || cleared < count; cleared += 1.0, id.number += 1.0) {
    PositionValue* position = positions ? variables_.position(id) : nullptr;
    if (position != nullptr) *position = {};
    const Alarm alarm = !positions ? variables_.store(id, 0.0) : position == nullptr ? Alarm::kIndex : Alarm::kNone;
    if (all && alarm == Alarm::kIndex && cleared > 0.0) break;
    if (!check(alarm)) return outcome_;
  }
  return Outcome::kNext;
}

}  // namespace armature::job
