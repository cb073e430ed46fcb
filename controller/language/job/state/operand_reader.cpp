#include "controller/language/job/state/operand_reader.hpp"

#include <cmath>

namespace armature::job {

bool OperandReader::is_position_variable() const noexcept {
  return is(OperandKind::kVariable) && here().what >= static_cast<std::uint8_t>(VariableType::kP) &&
         here().what <= static_cast<std::uint8_t>(VariableType::kEx);
}

bool OperandReader::take(Word word) noexcept {
  if (!is(word)) return false;
  ++at_;
  return true;
}

void OperandReader::skip() noexcept {
  while (!at_end() && (here().flags & Operand::kIndexed) != 0) ++at_;
  ++at_;
}

bool OperandReader::find(Word word) noexcept {
  while (!at_end() && !is(word)) ++at_;
  return !at_end();
}

bool OperandReader::variable(VariableId& id) noexcept {
  const Operand& read = here();
  ++at_;
  id = {static_cast<VariableType>(read.what), (read.flags & Operand::kLocal) != 0, static_cast<double>(read.a)};
  const bool foreign = id.type == VariableType::kS || id.type == VariableType::kBp || id.type == VariableType::kEx ||
                       (read.flags & Operand::kSystem) != 0;
  if (foreign && id.type != VariableType::kReturn) return step_.fail(Alarm::kUnsupported);
  return (read.flags & Operand::kIndexed) == 0 || number(id.number);
}

PositionValue* OperandReader::position_variable() noexcept {
  VariableId id;
  if (!variable(id)) return nullptr;
  PositionValue* position = variables_.position(id);
  if (position == nullptr) static_cast<void>(step_.fail(Alarm::kIndex));
  return position;
}

const PositionValue* OperandReader::set_position_variable() noexcept {
  const PositionValue* position = position_variable();
  if (position == nullptr || position->set) return position;
  static_cast<void>(step_.fail(Alarm::kNotSet));
  return nullptr;
}

bool OperandReader::position(PositionValue& value) noexcept {
  if (is(OperandKind::kPosition)) {
    value = PositionValue::of(memory_.positions[static_cast<std::size_t>(here().number)]);
    ++at_;
    return true;
  }
  const PositionValue* variable = set_position_variable();
  if (variable == nullptr) return false;
  value = *variable;
  return true;
}

bool OperandReader::number(double& value) noexcept {
  switch (here().kind) {
    case OperandKind::kNumber:
      value = here().number;
      ++at_;
      return true;
    case OperandKind::kIo:
      return pins(value);
    case OperandKind::kWord:
      if (take(Word::kMinus)) {
        if (!number(value)) return false;
        value = -value;
        return true;
      }
      value = is(Word::kOn) ? 1.0 : 0.0;
      ++at_;
      return true;
    case OperandKind::kVariable: {
      VariableId id;
      if (!variable(id)) return false;
      if (id.type == VariableType::kP) return step_.fail(Alarm::kTypes);
      if (id.type != VariableType::kReturn) return load(id, value);
      value = variables_.returned();
      return true;
    }
    default:
      return step_.fail(Alarm::kTypes);
  }
}

bool OperandReader::pins(double& value) noexcept {
  const IoType type = io_here();
  const std::size_t count = pins_of(type);
  if (count == 0) return step_.fail(Alarm::kUnsupported);
  double index = 0.0;
  if (!io_number(index)) return false;
  const bool output = is_output(type);
  const std::size_t highest = output ? PinLevels::kMaxOutputs : PinLevels::kPins;
  if (!(index >= 1.0 && index <= std::floor(static_cast<double>(highest) / static_cast<double>(count)))) {
    return step_.fail(Alarm::kPin);
  }
  const std::size_t first = (static_cast<std::size_t>(index) - 1) * count + 1;
  // The levels of the others are those that the program has set.
  if (first <= PinLevels::kPins && !step_.wait_until_done()) return false;
  unsigned shown = 0;
  for (std::size_t i = 0; i < count; ++i) {
    shown |= (levels_.level(first + i, output, step_.port()) ? 1U : 0U) << i;
  }
  value = shown;
  return true;
}

bool OperandReader::io_number(double& value) noexcept {
  ++at_;
  return number(value);
}

bool OperandReader::element(double& value) noexcept {
  ++at_;
  if (!number(value)) return false;
  ++at_;
  return true;
}

bool OperandReader::tag(double unit, double& value) noexcept {
  const Operand& tag = here();
  ++at_;
  if ((tag.flags & Operand::kIndexed) == 0) {
    value = tag.number;
    return true;
  }
  if (!number(value)) return false;
  value *= unit;
  return true;
}

std::string_view OperandReader::text() const noexcept {
  return at_end() ? std::string_view{} : memory_.text_at(text_of(here()));
}

}  // namespace armature::job
