// Numbers in programs: their value, and their form, so that they are printed as they were read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/job/memory/operand.hpp"

namespace armature::job {

struct NumberText {
  double value = 0.0;
  NumberForm form = 0;
  // Of 1.0E-02: -2; its digits, the sign plus (bit 4) and a small `e` (bit 5), which is 0 without an exponent.
  std::int16_t exponent = 0;
  std::uint8_t exponent_form = 0;
  std::size_t size = 0;  // characters
};

// The number at the start of a text: an optional sign, digits, decimals and an exponent. Nothing if there is none, if
// it has more than 15 digits, or if the point has no digits behind it.
[[nodiscard]] std::optional<NumberText> read_number(std::string_view text) noexcept;

// A text in a buffer of this size holds every number that read_number() accepts.
inline constexpr std::size_t kNumberSize = 48;
struct NumberDigits {
  char text[kNumberSize]{};
  std::size_t size = 0;
  [[nodiscard]] std::string_view view() const noexcept { return {text, size}; }
};
// The same characters that were read.
[[nodiscard]] NumberDigits number_digits(double value, NumberForm form, std::int16_t exponent = 0,
                                         std::uint8_t exponent_form = 0) noexcept;

[[nodiscard]] constexpr int decimals_of(NumberForm form) noexcept {
  return form & 0x0F;
}
[[nodiscard]] constexpr bool is_digit(char character) noexcept {
  return character >= '0' && character <= '9';
}

}  // namespace armature::job
