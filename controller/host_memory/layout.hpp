// The place of every scalar of a message, computed from its list of members (base/members.hpp), so that it is the same
// on every processor; and a number that changes with any of them.
//
// The scalars of the members follow each other in the order of the lists, each at the next multiple of its size. A
// std::optional is a flag and its value. A matrix is written row by row.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/base/words.hpp"

namespace armature::host_memory {

template <class T>
concept Number = std::is_same_v<T, char> || std::is_same_v<T, double> || std::is_same_v<T, std::uint8_t> ||
    std::is_same_v<T, std::uint16_t> || std::is_same_v<T, std::uint32_t> || std::is_same_v<T, std::uint64_t> ||
    std::is_same_v<T, std::int8_t> || std::is_same_v<T, std::int32_t> || std::is_same_v<T, std::int64_t>;
using Bits = std::bitset<64>;
// What is written as one number: an enumerator as one byte, a flag as 0 or 1.
template <class T>
concept Scalar = Number<T> || Unit<T> || std::is_enum_v<T> || std::is_same_v<T, bool> || std::is_same_v<T, Tag> ||
    std::is_same_v<T, Bits>;
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
  } else if constexpr (std::is_same_v<T, Bits>) {
    return static_cast<std::uint64_t>(value.to_ullong());
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

template <Scalar T>
[[nodiscard]] constexpr std::size_t aligned(std::size_t at) noexcept {
  constexpr std::size_t kSize = sizeof(NumberOf<T>);
  return (at + kSize - 1) / kSize * kSize;
}

// One part of `target.position_mm`, `list[2].pin`.
struct NamePart {
  const NamePart* outer = nullptr;
  std::string_view name{};  // empty: an element of an array
  std::size_t index = 0;
};

struct Field {
  std::size_t offset = 0;
  std::string_view type{};  // of one number: `f64`
  std::size_t count = 1;    // of numbers
  std::size_t bytes = 0;    // of all of them
  const NamePart* name = nullptr;
  std::span<const std::string_view> words{};  // of an enumeration, from 0 on
};

template <Scalar T>
[[nodiscard]] constexpr std::string_view type_name() noexcept {
  using Number = NumberOf<T>;
  if constexpr (std::is_same_v<Number, char>) return "char";
  if constexpr (std::is_same_v<Number, double>) return "f64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "i64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "i32";
  if constexpr (std::is_same_v<Number, std::int8_t>) return "i8";
  if constexpr (std::is_same_v<Number, std::uint64_t>) return "u64";
  if constexpr (std::is_same_v<Number, std::uint32_t>) return "u32";
  if constexpr (std::is_same_v<Number, std::uint16_t>) return "u16";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return std::is_same_v<T, bool> ? "flag" : "u8";
}

// For a walk that asks for the end only: the words of enumerations cost the compiler most of its time.
struct NoFields {
  constexpr void operator()(const Field&) const {}
};

// Calls emit(Field) for each scalar of a value that begins at the first free byte `at`, and once for an array or a
// matrix of numbers. Returns its end.
template <class T, class Emit>
constexpr std::size_t describe(std::size_t at, const NamePart& name, Emit& emit, std::size_t count = 1) {
  if constexpr (Scalar<T>) {
    std::span<const std::string_view> words;
    if constexpr (std::is_enum_v<T> && !std::is_same_v<Emit, NoFields>) words = kWordsOf<T>;
    const std::size_t bytes = count * sizeof(NumberOf<T>);
    emit(Field{aligned<T>(at), type_name<T>(), count, bytes, &name, words});
    return aligned<T>(at) + bytes;
  } else if constexpr (kIsMatrix<T>) {
    return describe<typename T::Scalar>(at, name, emit, count * T::SizeAtCompileTime);
  } else if constexpr (Optional<T>) {
    at = describe<bool>(at, NamePart{&name, "has_value"}, emit);
    return describe<typename T::value_type>(at, name, emit);
  } else if constexpr (HasMembers<T>) {
    for_each_member_type<T>([&]<class M>(const M& member) {
      const NamePart part{&name, member.name};
      at = describe<typename M::Type>(at, part, emit);
    });
    return at;
  } else if constexpr (HasMembers<typename T::value_type> || Optional<typename T::value_type>) {
    for (std::size_t i = 0; i < std::tuple_size_v<T>; ++i) {
      at = describe<typename T::value_type>(at, NamePart{&name, {}, i}, emit);
    }
    return at;
  } else {
    return describe<typename T::value_type>(at, name, emit, count * std::tuple_size_v<T>);
  }
}

// The end of a value that begins at the first free byte `at`.
template <class T>
[[nodiscard]] constexpr std::size_t end_of(std::size_t at) noexcept {
  NoFields ignore;
  return describe<T>(at, NamePart{}, ignore);
}

// A multiple of 8, so that messages can follow each other.
template <class T>
inline constexpr std::size_t kWireSize = aligned<double>(end_of<T>(0));

// FNV-1a.
class LayoutHash {
 public:
  constexpr void operator()(const Field& field) {
    add(field.offset);
    add(field.count);
    add(field.type);
    for (const NamePart* part = field.name; part != nullptr; part = part->outer) {
      add(part->name);
      add(part->index);
    }
    for (const std::string_view word : field.words) add(word);
  }
  constexpr void add(std::size_t number) {
    for (int shift = 0; shift < 32; shift += 8) add(static_cast<char>(number >> shift));
  }
  constexpr void add(std::string_view text) {
    for (const char letter : text) add(letter);
    add('\0');
  }
  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

 private:
  constexpr void add(char letter) { value_ = (value_ ^ static_cast<std::uint8_t>(letter)) * 0x100'0000'01B3; }
  std::uint64_t value_ = 0xCBF2'9CE4'8422'2325;
};

// Of all types of a variant.
template <class... Messages>
constexpr void add_layout(LayoutHash& hash, std::type_identity<std::variant<Messages...>>) {
  (describe<Messages>(0, NamePart{}, hash), ...);
}

}  // namespace armature::host_memory
