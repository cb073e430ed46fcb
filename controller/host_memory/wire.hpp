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

// Reads what put() wrote; `at` becomes its end. False if a byte is no flag or no enumerator, or if a type does not fit
// its own limits: T::fits(), where it has one.
template <class T>
[[nodiscard]] bool take(const std::uint8_t* bytes, std::size_t& at, T& value) noexcept {
  if constexpr (Scalar<T>) {
    NumberOf<T> number{};
    at = aligned<T>(at);
    std::memcpy(&number, bytes + at, sizeof(number));
    at += sizeof(number);
    return assign(number, value);
  } else if constexpr (kIsMatrix<T>) {
    bool good = true;
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      for (Eigen::Index column = 0; column < value.cols(); ++column) good &= take(bytes, at, value(row, column));
    }
    return good;
  } else if constexpr (Optional<T>) {
    bool has_value = false;
    bool good = take(bytes, at, has_value);
    value.reset();
    std::size_t end = at;
    if (has_value) good &= take(bytes, end, value.emplace());
    at = end_of<typename T::value_type>(at);
    return good;
  } else if constexpr (HasMembers<T>) {
    bool good = true;
    for_each_member(value, [&](const char*, auto& member) { good &= take(bytes, at, member); });
    if constexpr (requires { value.fits(); }) good = good && value.fits();
    return good;
  } else {
    bool good = true;
    for (auto& element : value) good &= take(bytes, at, element);
    return good;
  }
}

}  // namespace armature::host_memory
