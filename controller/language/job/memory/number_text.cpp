#include "controller/language/job/memory/number_text.hpp"

#include <bit>
#include <cmath>

#include "controller/base/rounding.hpp"

namespace armature::job {
namespace {

constexpr int kMaxDigits = 15;  // all numbers of so many digits differ as double
constexpr int kMaxExponent = 99;
constexpr int kMaxExponentDigits = 3;
constexpr std::uint8_t kPlusForm = 0x10;
constexpr std::uint8_t kSmallForm = 0x20;
constexpr int kZerosShift = 5;
constexpr int kNoWholeDigits = 7;  // instead of leading zeros: .5

double power_of_ten(int exponent) noexcept {
  double power = 1.0;
  for (int i = 0; i < exponent; ++i) power *= 10.0;
  return power;
}

double scaled(double value, int exponent) noexcept {
  return exponent < 0 ? value / power_of_ten(-exponent) : value * power_of_ten(exponent);
}

// Reads a number from left to right. Each step returns false if the text is no number that can be kept.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) noexcept : text_{text} {}

  [[nodiscard]] std::optional<NumberText> read() noexcept {
    const bool negative = take('-');
    const bool plus = !negative && take('+');
    if (!read_whole() || !read_decimals() || !is_complete() || !read_exponent()) return std::nullopt;
    const double magnitude = scaled(static_cast<double>(mantissa_) / power_of_ten(decimals_), number_.exponent);
    number_.value = negative ? -magnitude : magnitude;
    number_.form = static_cast<NumberForm>(decimals_ | (plus ? kPlusForm : 0) | zeros_ << kZerosShift);
    number_.size = at_;
    return number_;
  }

 private:
  // The digits before the point.
  [[nodiscard]] bool read_whole() noexcept {
    for (; is_digit(here()); ++whole_) {
      if (mantissa_ == 0 && here() == '0') ++zeros_;
      if (!take_digit()) return false;
    }
    if (whole_ == zeros_ && zeros_ > 0) --zeros_;  // the zero of 0.5 does not lead
    return true;
  }

  [[nodiscard]] bool read_decimals() noexcept {
    if (!take('.')) return true;
    for (; is_digit(here()); ++decimals_) {
      if (decimals_ == kMaxDigits || !take_digit()) return false;
    }
    return decimals_ > 0;
  }

  // Whether there are digits, and no more leading zeros than a form can tell.
  [[nodiscard]] bool is_complete() noexcept {
    if (whole_ > 0) return zeros_ < kNoWholeDigits;
    zeros_ = kNoWholeDigits;
    return decimals_ > 0;
  }

  [[nodiscard]] bool read_exponent() noexcept {
    const bool small = here() == 'e';
    if (!take('E') && !take('e')) return true;
    const bool minus = take('-');
    const bool plus = !minus && take('+');
    int size = 0, count = 0;
    for (; is_digit(here()) && count < kMaxExponentDigits; ++at_, ++count) size = 10 * size + (here() - '0');
    if (count == 0 || size > kMaxExponent) return false;
    number_.exponent = static_cast<std::int16_t>(minus ? -size : size);
    number_.exponent_form = static_cast<std::uint8_t>(count | (plus ? kPlusForm : 0) | (small ? kSmallForm : 0));
    return !(minus && size == 0);  // a negative zero would lose its sign
  }

  // Adds a digit to the mantissa; false: it would have too many.
  [[nodiscard]] bool take_digit() noexcept {
    if ((mantissa_ > 0 || here() != '0') && ++digits_ > kMaxDigits) return false;
    mantissa_ = 10 * mantissa_ + (here() - '0');
    ++at_;
    return true;
  }
  [[nodiscard]] bool take(char character) noexcept {
    if (here() != character) return false;
    ++at_;
    return true;
  }
  // 0 at the end of the text.
  [[nodiscard]] char here() const noexcept { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view text_;
  std::size_t at_ = 0;
  std::int64_t mantissa_ = 0;  // the number without its point
  int digits_ = 0;             // of the mantissa
  int whole_ = 0;              // digits before the point
  int zeros_ = 0;              // of these, leading ones
  int decimals_ = 0;
  NumberText number_;
};

void add(NumberDigits& text, char character) noexcept {
  if (text.size < kNumberSize) text.text[text.size++] = character;
}

// `mantissa` with a point before its last `decimals` digits, and leading zeros.
void add_decimal(NumberDigits& text, std::int64_t mantissa, int decimals, int zeros) noexcept {
  char reversed[24];
  int count = 0;
  for (; (mantissa > 0 || count <= decimals) && count < 24; mantissa /= 10) {
    reversed[count++] = static_cast<char>('0' + mantissa % 10);
  }
  if (zeros == kNoWholeDigits) {
    if (count == decimals + 1 && reversed[decimals] == '0') --count;
  } else {
    for (int i = 0; i < zeros; ++i) add(text, '0');
  }
  while (count > 0) {
    if (count == decimals && decimals > 0) add(text, '.');
    add(text, reversed[--count]);
  }
}

void add_exponent(NumberDigits& text, int exponent, std::uint8_t form) noexcept {
  add(text, (form & kSmallForm) != 0 ? 'e' : 'E');
  if (exponent < 0) add(text, '-');
  if ((form & kPlusForm) != 0) add(text, '+');
  const int size = exponent < 0 ? -exponent : exponent;
  for (int place = form & 0x0F; place > 0; --place) {
    const auto power = static_cast<std::int64_t>(power_of_ten(place - 1));
    add(text, static_cast<char>('0' + size / power % 10));
  }
}

}  // namespace

std::optional<NumberText> read_number(std::string_view text) noexcept {
  return NumberReader{text}.read();
}

NumberDigits number_digits(double value, NumberForm form, std::int16_t exponent, std::uint8_t exponent_form) noexcept {
  NumberDigits result;
  if (std::bit_cast<std::uint64_t>(value) >> 63U != 0) {
    add(result, '-');
  } else if ((form & kPlusForm) != 0) {
    add(result, '+');
  }
  const int decimals = decimals_of(form);
  const double units = scaled(std::fabs(value), -exponent) * power_of_ten(decimals);
  const std::int64_t mantissa = units < 9e18 ? round_half_away(units) : 0;
  add_decimal(result, mantissa, decimals, form >> kZerosShift);
  if (exponent_form != 0) add_exponent(result, exponent, exponent_form);
  return result;
}

}  // namespace armature::job
