// The value of a key, for reports that show it as the user wrote it.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace armature::cosim {

// std::monostate: the key is not written and has no default.
using KeyValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct NamedValue {
  std::string_view key;
  KeyValue value;
};

template <class T>
concept ScalarKey = std::integral<T> || std::same_as<T, double> || std::same_as<T, std::string>;

template <ScalarKey T>
[[nodiscard]] KeyValue key_value(const T& value) {
  if constexpr (std::integral<T> && !std::same_as<T, bool>) {
    return static_cast<std::int64_t>(value);
  } else {
    return value;
  }
}
template <ScalarKey T>
[[nodiscard]] KeyValue key_value(const std::optional<T>& value) {
  return value ? key_value(*value) : KeyValue{};
}

}  // namespace armature::cosim
