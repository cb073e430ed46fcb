// A number as messages and files show it: the shortest decimal that reads back as the same double, no locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace armature::cosim {

// Whole numbers are written out (`1000000000`, not `1e+09`).
[[nodiscard]] inline std::string number_text(double value) {
  constexpr double kWrittenOut = 1e15;
  if (std::trunc(value) == value && std::fabs(value) < kWrittenOut) {
    return std::to_string(static_cast<std::int64_t>(value));
  }
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

// A fixed number of digits after the point.
[[nodiscard]] inline std::string fixed_text(double value, int digits) {
  std::array<char, 512> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  return {text.data(), result.ptr};
}

}  // namespace armature::cosim
