#include "controller/language/job/memory/number_text.hpp"

#include <bit>
#include <cmath>

#include "controller/base/rounding.hpp"

namespace armature::job {
namespace {

constexpr int kMaxDigits = 15;  // all numbers of so many digits differ as double
constexpr int kMaxExponent = 99;
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

}  // namespace

std::optional<NumberText> read_number(std::string_view text) noexcept {
  NumberText number;
  std::size_t at = 0;
  const auto more = [&] { return at < text.size() && is_digit(text[at]); };
  const bool negative = at < text.size() && text[at] == '-';
  const bool plus = at < text.size() && text[at] == '+';
  if (negative || plus) ++at;

  std::int64_t mantissa = 0;
  int digits = 0, whole = 0, zeros = 0, decimals = 0;
  for (; more(); ++at, ++whole) {
    if (mantissa == 0 && text[at] == '0') ++zeros;
    if (mantissa > 0 || text[at] != '0') ++digits;
    if (digits > kMaxDigits) return std::nullopt;
    mantissa = 10 * mantissa + (text[at] - '0');
  }
  if (whole == zeros && zeros > 0) --zeros;  // the zero of 0.5 does not lead
  if (at < text.size() && text[at] == '.') {
    for (++at; more(); ++at, ++decimals) {
      if (mantissa > 0 || text[at] != '0') ++digits;
      if (digits > kMaxDigits || decimals == kMaxDigits) return std::nullopt;
      mantissa = 10 * mantissa + (text[at] - '0');
    }
    if (decimals == 0) return std::nullopt;
  }
  if (whole == 0) {
    if (decimals == 0) return std::nullopt;
    zeros = kNoWholeDigits;
  } else if (zeros >= kNoWholeDigits) {
    return std::nullopt;
  }
  if (at < text.size() && (text[at] == 'E' || text[at] == 'e')) {
    std::size_t from = at + 1;
    const bool minus = from < text.size() && text[from] == '-';
    const bool exponent_plus = from < text.size() && text[from] == '+';
    if (minus || exponent_plus) ++from;
    int exponent = 0, count = 0;
    for (; from < text.size() && is_digit(text[from]) && count < 3; ++from, ++count) {
      exponent = 10 * exponent + (text[from] - '0');
    }
    if (count == 0 || exponent > kMaxExponent) return std::nullopt;
    number.exponent = static_cast<std::int16_t>(minus ? -exponent : exponent);
    number.exponent_form =
        static_cast<std::uint8_t>(count | (exponent_plus ? kPlusForm : 0) | (text[at] == 'e' ? kSmallForm : 0));
    // A negative zero would lose its sign.
    if (minus && exponent == 0) return std::nullopt;
    at = from;
  }
  const double magnitude = scaled(static_cast<double>(mantissa) / power_of_ten(decimals), number.exponent);
  number.value = negative ? -magnitude : magnitude;
  number.form = static_cast<NumberForm>(decimals | (plus ? kPlusForm : 0) | zeros << kZerosShift);
  number.size = at;
  return number;
}

NumberDigits number_digits(double value, NumberForm form, std::int16_t exponent, std::uint8_t exponent_form) noexcept {
  NumberDigits result;
  const auto add = [&](char character) {
    if (result.size < kNumberSize) result.text[result.size++] = character;
  };
  const int decimals = decimals_of(form);
  const int zeros = form >> kZerosShift;
  if (std::bit_cast<std::uint64_t>(value) >> 63U != 0) {
    add('-');
  } else if ((form & kPlusForm) != 0) {
    add('+');
  }
  const double units = scaled(std::fabs(value), -exponent) * power_of_ten(decimals);
  std::int64_t mantissa = units < 9e18 ? round_half_away(units) : 0;
  char reversed[24];
  int count = 0;
  for (; (mantissa > 0 || count <= decimals) && count < 24; mantissa /= 10) {
    reversed[count++] = static_cast<char>('0' + mantissa % 10);
  }
  if (zeros == kNoWholeDigits && count == decimals + 1 && reversed[decimals] == '0') --count;
  for (int i = 0; zeros != kNoWholeDigits && i < zeros; ++i) add('0');
  while (count > 0) {
    if (count == decimals && decimals > 0) add('.');
    add(reversed[--count]);
  }
  if (exponent_form != 0) {
    add((exponent_form & kSmallForm) != 0 ? 'e' : 'E');
    if (exponent < 0) add('-');
    if ((exponent_form & kPlusForm) != 0) add('+');
    const int size = exponent < 0 ? -exponent : exponent;
    for (int digits = (exponent_form & 0x0F), power = digits == 3 ? 100 : digits == 2 ? 10 : 1; digits > 0; --digits) {
      add(static_cast<char>('0' + size / power % 10));
      power /= 10;
      if (power == 0) power = 1;
    }
  }
  return result;
}

}  // namespace armature::job
