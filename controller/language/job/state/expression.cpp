#include "controller/language/job/state/expression.hpp"

#include <array>
#include <cstddef>

namespace armature::job {
namespace {

int binding_of(Word word) noexcept {
  if (word == Word::kOpen) return 0;
  return word == Word::kPlus || word == Word::kMinus ? 1 : 2;
}

// Values and words that wait for what binds more tightly: two stacks and no recursion, so the depth is bounded.
class Stacks {
 public:
  explicit Stacks(Step& step) noexcept : step_{step} {}

  [[nodiscard]] bool push(double value) noexcept {
    if (value_count_ == kMaxDepth) return step_.fail(Alarm::kRange);
    values_[value_count_++] = value;
    return true;
  }
  [[nodiscard]] bool push(Word word) noexcept {
    if (word_count_ == kMaxDepth) return step_.fail(Alarm::kRange);
    words_[word_count_++] = word;
    return true;
  }
  // Calculates what is on top and binds at least so tightly.
  [[nodiscard]] bool reduce(int binding) noexcept {
    while (word_count_ > 0 && binding_of(words_[word_count_ - 1]) >= binding) {
      const Word word = words_[--word_count_];
      const double b = values_[--value_count_];
      double& a = values_[value_count_ - 1];
      if (word == Word::kDivide && b == 0.0) return step_.fail(Alarm::kDivision);
      a = word == Word::kPlus ? a + b : word == Word::kMinus ? a - b : word == Word::kTimes ? a * b : a / b;
    }
    return true;
  }
  // Calculates the parenthesis that was opened last.
  [[nodiscard]] bool close() noexcept {
    if (!reduce(1)) return false;
    if (word_count_ > 0) --word_count_;
    return true;
  }
  [[nodiscard]] double top() const noexcept { return values_[value_count_ - 1]; }

 private:
  static constexpr std::size_t kMaxDepth = 32;

  Step& step_;
  std::array<double, kMaxDepth> values_{};
  std::array<Word, kMaxDepth> words_{};
  std::size_t value_count_ = 0, word_count_ = 0;
};

// The parentheses before a value. A minus before one is -1 * ( ... ), which binds as its term does.
bool open_parentheses(OperandReader& operands, Stacks& stacks) noexcept {
  while (true) {
    if (operands.take(Word::kOpen)) {
      if (!stacks.push(Word::kOpen)) return false;
      continue;
    }
    OperandReader behind = operands;
    if (!behind.take(Word::kMinus) || !behind.is(Word::kOpen)) return true;
    operands.next();
    if (!stacks.push(-1.0) || !stacks.push(Word::kTimes)) return false;
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

bool read_comparison(OperandReader& operands, bool& holds) noexcept {
  double a = 0.0, b = 0.0;
  if (!operands.number(a)) return false;
  const Word word = operands.word_here();
  operands.next();
  if (!operands.number(b)) return false;
  holds = compare(word, a, b);
  return true;
}

}  // namespace

bool read_expression(Step& step, OperandReader& operands, double& value) noexcept {
  Stacks stacks{step};
  while (true) {
    double read = 0.0;
    if (!open_parentheses(operands, stacks) || !operands.number(read) || !stacks.push(read)) return false;
    while (operands.take(Word::kClose)) {
      if (!stacks.close()) return false;
    }
    if (!operands.is(OperandKind::kWord) || !is_calculation(operands.word_here())) break;
    const Word word = operands.word_here();
    operands.next();
    if (!stacks.reduce(binding_of(word)) || !stacks.push(word)) return false;
  }
  if (!stacks.reduce(1)) return false;
  value = stacks.top();
  return true;
}

bool read_condition(OperandReader& operands, bool& holds) noexcept {
  static_cast<void>(operands.take(Word::kForExpress));
  bool any = false, all = true;
  while (true) {
    bool one = false;
    if (!read_comparison(operands, one)) return false;
    all = all && one;
    if (operands.take(Word::kAndExp) || operands.take(Word::kAndIf)) continue;
    any = any || all;
    if (!operands.take(Word::kOrExp) && !operands.take(Word::kOrIf)) break;
    all = true;
  }
  holds = any;
  return true;
}

bool read_guard(OperandReader operands, bool& holds) noexcept {
  holds = true;
  for (; !operands.at_end(); operands.next()) {
    if (operands.take(Word::kIf) || operands.take(Word::kIfExpress)) return read_condition(operands, holds);
  }
  return true;
}

}  // namespace armature::job
