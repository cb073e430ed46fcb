// A value as TOML writes it, for the defaults of keys.
#pragma once

#include <concepts>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {

[[nodiscard]] inline std::string toml_text(bool value) {
  return value ? "true" : "false";
}
template <std::integral T>
requires(!std::same_as<T, bool>) [[nodiscard]] std::string toml_text(T value) {
  return std::to_string(value);
}
[[nodiscard]] inline std::string toml_text(double value) {
  return number_text(value);
}
// For strings without quotes and control characters.
[[nodiscard]] inline std::string toml_text(const std::string& value) {
  return "\"" + value + "\"";
}
template <std::ranges::range T>
requires(!std::convertible_to<T, std::string_view>) [[nodiscard]] std::string toml_text(const T& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + toml_text(value);
  return "[" + text + "]";
}
// No text when there is no value.
template <class T>
[[nodiscard]] std::string toml_text(const std::optional<T>& value) {
  return value ? toml_text(*value) : std::string{};
}

}  // namespace armature::cosim
