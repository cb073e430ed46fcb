// The bytes of a value, without the padding of its type, for a digest.
#pragma once

#include <array>
#include <bit>
#include <string>
#include <string_view>
#include <type_traits>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature::cosim {

template <class T>
void append_bytes(std::string& bytes, const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    const auto all = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(all.data(), all.size());
  } else if constexpr (std::is_same_v<T, Tag>) {
    append_bytes(bytes, value.word());
  } else if constexpr (Unit<T>) {
    append_bytes(bytes, value.value());
  } else if constexpr (HasMembers<T>) {
    for_each_member(value, [&](std::string_view, const auto& member) { append_bytes(bytes, member); });
  } else if constexpr (requires { value.has_value(); }) {
    append_bytes(bytes, value.has_value());
    if (value) append_bytes(bytes, *value);
  } else {
    for (const auto& element : value) append_bytes(bytes, element);
  }
}

}  // namespace armature::cosim
