// The bytes of a message, computed from its list of members (core/members.hpp), so that they are the same on every
// processor.
//
// The scalars of the members follow each other in the order of the lists, each at the next multiple of its size, little
// endian. A std::optional is a flag and its value, which is 0 without one. A matrix is written row by row. What no
// scalar fills is 0. layout.hpp lists the bytes of all messages.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>

#include "controller/core/members.hpp"
#include "controller/core/tag.hpp"
#include "controller/core/words.hpp"

namespace armature::mailbox {

static_assert(std::endian::native == std::endian::little);
static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

template <class T>
concept Unit = requires(const T& value) {
  typename T::rep;
  value.value();
};
template <class T>
concept Number = std::is_same_v<T, char> || std::is_same_v<T, double> || std::is_same_v<T, std::uint8_t> ||
    std::is_same_v<T, std::uint16_t> || std::is_same_v<T, std::uint32_t> || std::is_same_v<T, std::int8_t> ||
    std::is_same_v<T, std::int64_t>;
// What is written as one number: an enumerator as one byte, a flag as 0 or 1.
template <class T>
concept Scalar = Number<T> || Unit<T> || std::is_enum_v<T> || std::is_same_v<T, bool> || std::is_same_v<T, Tag>;
template <class T>
concept Optional = requires(const T& value) {
  value.has_value();
};
template <class T>
inline constexpr bool kIsMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

template <Scalar T>
[[nodiscard]] constexpr auto number_of(const T& value) noexcept {
  if constexpr (std::is_same_v<T, Tag>) {
    return value.word();
  } else if constexpr (Unit<T>) {
    return value.value();
  } else if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
    return static_cast<std::uint8_t>(value);
  } else {
    return value;
  }
}
template <Scalar T>
using NumberOf = decltype(number_of(std::declval<T>()));

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

template <Scalar T>
[[nodiscard]] constexpr std::size_t aligned(std::size_t at) noexcept {
  constexpr std::size_t kSize = sizeof(NumberOf<T>);
  return (at + kSize - 1) / kSize * kSize;
}

// The end of a value that begins at the first free byte `at`.
template <class T>
[[nodiscard]] constexpr std::size_t end_of(std::size_t at) noexcept {
  if constexpr (Scalar<T>) {
    return aligned<T>(at) + sizeof(NumberOf<T>);
  } else if constexpr (kIsMatrix<T>) {
    return aligned<typename T::Scalar>(at) + sizeof(typename T::Scalar) * T::SizeAtCompileTime;
  } else if constexpr (Optional<T>) {
    return end_of<typename T::value_type>(end_of<bool>(at));
  } else if constexpr (HasMembers<T>) {
    std::apply([&](const auto&... member) { ((at = end_of<typename std::decay_t<decltype(member)>::Type>(at)), ...); },
               T::members());
    return at;
  } else {
    for (std::size_t i = 0; i < std::tuple_size_v<T>; ++i) at = end_of<typename T::value_type>(at);
    return at;
  }
}

// A multiple of 8, so that messages can follow each other.
template <class T>
inline constexpr std::size_t kWireSize = aligned<double>(end_of<T>(0));

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

}  // namespace armature::mailbox
