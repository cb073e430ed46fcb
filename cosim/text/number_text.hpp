// Numbers as messages and files show them, and back, without a locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace armature::cosim {

// The shortest decimal that reads back as the same double. Whole numbers are written out (`1000000000`, not `1e+09`).
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

// Nothing if not all of the text is a number. `base`: nothing, or that of an integer.
template <class T, class... Base>
[[nodiscard]] std::optional<T> parsed_number(std::string_view text, Base... base) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace armature::cosim
