// How the machine reads operands: values, expressions, conditions.
#include <cmath>

#include "controller/language/job/machine.hpp"

namespace armature::job {
namespace {

IoType io_type(const Operand& operand) noexcept {
  return static_cast<IoType>(operand.what);
}

// The number of pins that an input or output stands for; 0: none that exists here.
std::size_t pins_of(IoType type) noexcept {
  switch (type) {
    case IoType::kInput:
    case IoType::kOutput:
      return 1;
    case IoType::kInputHalfGroup:
    case IoType::kOutputHalfGroup:
      return 4;
    case IoType::kInputGroup:
    case IoType::kOutputGroup:
      return 8;
    default:
      return 0;
  }
}

bool compare(Word word, double a, double b) noexcept {
  switch (word) {
    case Word::kEqual:
      return a == b;
    case Word::kNotEqual:
      return a != b;
    case Word::kLess:
      return a < b;
    case Word::kLessEqual:
      return a <= b;
    case Word::kGreater:
      return a > b;
    default:
      return a >= b;
  }
}

}  // namespace

bool Machine::is_word(std::size_t at, Word word) const noexcept {
  return at < operands_.size() && operand(at).kind == OperandKind::kWord &&
         operand(at).what == static_cast<std::uint8_t>(word);
}

void Machine::skip(std::size_t& at) const noexcept {
  while (at < operands_.size() && (operand(at).flags & Operand::kIndexed) != 0) ++at;
  ++at;
}

bool Machine::is_position_variable(std::size_t at) const noexcept {
  return at < operands_.size() && operand(at).kind == OperandKind::kVariable &&
         operand(at).what >= static_cast<std::uint8_t>(VariableType::kP) &&
         operand(at).what <= static_cast<std::uint8_t>(VariableType::kEx);
}

bool Machine::variable(std::size_t& at, VariableId& id) noexcept {
  const Operand& read = operand(at++);
  id = {static_cast<VariableType>(read.what), (read.flags & Operand::kLocal) != 0, static_cast<double>(read.a)};
  const bool foreign = id.type == VariableType::kS || id.type == VariableType::kBp || id.type == VariableType::kEx ||
                       (read.flags & Operand::kSystem) != 0;
  if (foreign && id.type != VariableType::kReturn) return fail(Alarm::kUnsupported);
  return (read.flags & Operand::kIndexed) == 0 || number(at, id.number);
}

PositionValue* Machine::position_variable(std::size_t& at) noexcept {
  VariableId id;
  if (!variable(at, id)) return nullptr;
  PositionValue* position = variables_.position(id);
  if (position == nullptr) (void)fail(Alarm::kIndex);
  return position;
}

bool Machine::number(std::size_t& at, double& value) noexcept {
  const Operand& read = operand(at);
  switch (read.kind) {
    case OperandKind::kNumber:
      value = read.number;
      return ++at, true;
    case OperandKind::kIo:
      return pin_value(at, value);
    case OperandKind::kWord:
      if (is_word(at, Word::kMinus)) {
        if (!number(++at, value)) return false;
        value = -value;
        return true;
      }
      value = is_word(at, Word::kOn) ? 1.0 : 0.0;
      return ++at, true;
    case OperandKind::kVariable: {
      VariableId id;
      if (!variable(at, id)) return false;
      if (id.type == VariableType::kReturn) return value = returned_, true;
      if (id.type == VariableType::kP) return fail(Alarm::kTypes);
      return check(variables_.load(id, value));
    }
    default:
      return fail(Alarm::kTypes);
  }
}

// 1 or 0 for one pin, otherwise the number that a group of pins shows.
bool Machine::pin_value(std::size_t& at, double& value) noexcept {
  const IoType type = io_type(operand(at++));
  const std::size_t pins = pins_of(type);
  if (pins == 0) return fail(Alarm::kUnsupported);
  double index = 0.0;
  if (!number(at, index)) return false;
  const bool output = type == IoType::kOutput || type == IoType::kOutputGroup || type == IoType::kOutputHalfGroup;
  const double last = std::floor(static_cast<double>(output ? kMostOutputs : kPins) / static_cast<double>(pins));
  if (!(index >= 1.0 && index <= last)) return fail(Alarm::kPin);
  const std::size_t first = (static_cast<std::size_t>(index) - 1) * pins + 1;
  // The levels of the others are those that the program has set.
  if (first <= kPins && !wait_until_done()) return false;
  unsigned levels = 0;
  for (std::size_t i = 0; i < pins; ++i) {
    const std::size_t pin = first + i;
    const bool level = pin > kPins ? outputs_[pin] : port_->level(static_cast<std::uint8_t>(pin), output);
    levels |= (level ? 1U : 0U) << i;
  }
  value = levels;
  return true;
}

bool Machine::tag_number(std::size_t& at, double unit, double& value) noexcept {
  const Operand& tag = operand(at++);
  if ((tag.flags & Operand::kIndexed) == 0) return value = tag.number, true;
  if (!number(at, value)) return false;
  value *= unit;
  return true;
}

// value { + - * / value } with parentheses, by two stacks: no recursion, so its depth is bounded.
bool Machine::expression(std::size_t& at, double& value) noexcept {
  constexpr std::size_t kDeepest = 32;
  std::array<double, kDeepest> values{};
  std::array<Word, kDeepest> words{};
  std::size_t value_count = 0, word_count = 0;
  const auto reduce = [&] {
    const Word word = words[--word_count];
    const double b = values[--value_count];
    double& a = values[value_count - 1];
    if (word == Word::kDivide && b == 0.0) return fail(Alarm::kDivision);
    a = word == Word::kPlus ? a + b : word == Word::kMinus ? a - b : word == Word::kTimes ? a * b : a / b;
    return true;
  };
  const auto product = [](Word word) { return word == Word::kTimes || word == Word::kDivide; };
  while (true) {
    while (is_word(at, Word::kOpen)) {
      if (word_count == kDeepest) return fail(Alarm::kRange);
      words[word_count++] = Word::kOpen;
      ++at;
    }
    // A minus before a parenthesis: 0 - ( ... ), which binds as its term does.
    if (is_word(at, Word::kMinus) && is_word(at + 1, Word::kOpen)) {
      if (word_count == kDeepest || value_count == kDeepest) return fail(Alarm::kRange);
      values[value_count++] = -1.0;
      words[word_count++] = Word::kTimes;
      ++at;
      continue;
    }
    double read = 0.0;
    if (!number(at, read)) return false;
    if (value_count == kDeepest) return fail(Alarm::kRange);
    values[value_count++] = read;
    while (is_word(at, Word::kClose)) {
      while (word_count > 0 && words[word_count - 1] != Word::kOpen) {
        if (!reduce()) return false;
      }
      if (word_count > 0) --word_count;
      ++at;
    }
    if (at >= operands_.size() || operand(at).kind != OperandKind::kWord) break;
    const auto word = static_cast<Word>(operand(at).what);
    if (!is_calculation(word)) break;
    while (word_count > 0 && words[word_count - 1] != Word::kOpen &&
           (product(words[word_count - 1]) || !product(word))) {
      if (!reduce()) return false;
    }
    if (word_count == kDeepest) return fail(Alarm::kRange);
    words[word_count++] = word;
    ++at;
  }
  while (word_count > 0) {
    if (!reduce()) return false;
  }
  value = values[0];
  return true;
}

bool Machine::comparison(std::size_t& at, bool& holds) noexcept {
  double a = 0.0, b = 0.0;
  if (!number(at, a)) return false;
  const auto word = static_cast<Word>(operand(at++).what);
  if (!number(at, b)) return false;
  holds = compare(word, a, b);
  return true;
}

// AND binds before OR.
bool Machine::condition(std::size_t& at, bool& holds) noexcept {
  if (is_word(at, Word::kForExpress)) ++at;
  bool any = false, all = true;
  while (true) {
    bool one = false;
    if (!comparison(at, one)) return false;
    all = all && one;
    if (is_word(at, Word::kAndExp) || is_word(at, Word::kAndIf)) {
      ++at;
    } else if (is_word(at, Word::kOrExp) || is_word(at, Word::kOrIf)) {
      any = any || all;
      all = true;
      ++at;
    } else {
      holds = any || all;
      return true;
    }
  }
}

// The condition behind IF, anywhere in the line; none holds.
bool Machine::guard(std::size_t at, bool& holds) noexcept {
  holds = true;
  for (; at < operands_.size(); ++at) {
    if (!is_word(at, Word::kIf) && !is_word(at, Word::kIfExpress)) continue;
    ++at;
    return condition(at, holds);
  }
  return true;
}

}  // namespace armature::job
