// Writes and reads the bytes of a message, at the places that layout.hpp computes. Little endian; what no scalar fills
// is 0, as is the value of an empty std::optional.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/base/words.hpp"
#include "controller/host_memory/layout.hpp"

namespace armature::host_memory {

static_assert(std::endian::native == std::endian::little);
static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

// False for a byte that is no flag or no enumerator.
template <Scalar T>
[[nodiscard]] constexpr bool assign(NumberOf<T> number, T& value) noexcept {
  if constexpr (std::is_same_v<T, Tag>) {
    value = Tag::from_word(number);
  } else if constexpr (std::is_same_v<T, Bits>) {
    value = Bits{number};
  } else if constexpr (Unit<T>) {
    value = T{number};
  } else if constexpr (std::is_same_v<T, bool>) {
    value = number == 1;
    return number <= 1;
  } else if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(number);
    return number < kWordsOf<T>.size();
  } else {
    value = number;
  }
  return true;
}

// Writes a value to bytes that are 0, from the first free one on. Returns its end.
template <class T>
std::size_t put(std::uint8_t* bytes, std::size_t at, const T& value) noexcept {
  if constexpr (Scalar<T>) {
    const auto number = number_of(value);
    at = aligned<T>(at);
    std::memcpy(bytes + at, &number, sizeof(number));
    return at + sizeof(number);
  } else if constexpr (kIsMatrix<T>) {
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      for (Eigen::Index column = 0; column < value.cols(); ++column) at = put(bytes, at, value(row, column));
    }
    return at;
  } else if constexpr (Optional<T>) {
    at = put(bytes, at, value.has_value());
    if (value) put(bytes, at, *value);
    return end_of<typename T::value_type>(at);
  } else if constexpr (HasMembers<T>) {
    for_each_member(value, [&](const char*, const auto& member) { at = put(bytes, at, member); });
    return at;
  } else {
    for (const auto& element : value) at = put(bytes, at, element);
    return at;
  }
}

// The first free byte before a member of a value that begins at the first free byte `at`.
template <HasMembers T>
[[nodiscard]] std::size_t begin_of_member(std::size_t at, const T& value, const void* wanted) noexcept {
  bool found = false;
  for_each_member(value, [&]<class M>(const char*, const M& member) {
    found = found || &member == wanted;
    if (!found) at = end_of<M>(at);
  });
  return at;
}

// Reads what put() wrote; `at` becomes its end. False if a byte is no flag or no enumerator, or if a member has a value
// that its type does not allow (base/misfit.hpp): `at` is then the first free byte before that member.
template <class T>
[[nodiscard]] bool take(const std::uint8_t* bytes, std::size_t& at, T& value) noexcept;

template <Optional T>
[[nodiscard]] bool take_optional(const std::uint8_t* bytes, std::size_t& at, T& value) noexcept {
  bool has_value = false;
  value.reset();
  if (!take(bytes, at, has_value)) return false;
  const std::size_t end = end_of<typename T::value_type>(at);
  if (has_value && !take(bytes, at, value.emplace())) return false;
  at = end;
  return true;
}

template <HasMembers T>
[[nodiscard]] bool take_members(const std::uint8_t* bytes, std::size_t& at, T& value) noexcept {
  const std::size_t begin = at;
  bool good = true;
  for_each_member(value, [&](const char*, auto& member) { good = good && take(bytes, at, member); });
  if constexpr (requires { value.misfit(); }) {
    if (!good || value.misfit() == nullptr) return good;
    at = begin_of_member(begin, value, value.misfit());
    return false;
  }
  return good;
}

template <class T>
[[nodiscard]] bool take(const std::uint8_t* bytes, std::size_t& at, T& value) noexcept {
  if constexpr (Scalar<T>) {
    NumberOf<T> number{};
    at = aligned<T>(at);
    std::memcpy(&number, bytes + at, sizeof(number));
    if (!assign(number, value)) return false;
    at += sizeof(number);
    return true;
  } else if constexpr (kIsMatrix<T>) {
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      for (Eigen::Index column = 0; column < value.cols(); ++column) {
        if (!take(bytes, at, value(row, column))) return false;
      }
    }
    return true;
  } else if constexpr (Optional<T>) {
    return take_optional(bytes, at, value);
  } else if constexpr (HasMembers<T>) {
    return take_members(bytes, at, value);
  } else {
    for (auto& element : value) {
      if (!take(bytes, at, element)) return false;
    }
    return true;
  }
}

}  // namespace armature::host_memory
