// The place of every scalar of a message, and a number that changes with any of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <variant>

#include "controller/core/words.hpp"
#include "controller/mailbox/wire.hpp"

namespace armature::mailbox {

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
  const NamePart* name = nullptr;
  std::span<const std::string_view> words{};  // of an enumeration, from 0 on
};

template <Scalar T>
[[nodiscard]] constexpr std::string_view type_name() noexcept {
  using Number = NumberOf<T>;
  if constexpr (std::is_same_v<Number, char>) return "char";
  if constexpr (std::is_same_v<Number, double>) return "f64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "i64";
  if constexpr (std::is_same_v<Number, std::int8_t>) return "i8";
  if constexpr (std::is_same_v<Number, std::uint32_t>) return "u32";
  if constexpr (std::is_same_v<Number, std::uint16_t>) return "u16";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return std::is_same_v<T, bool> ? "flag" : "u8";
}

// Calls emit(Field) for each scalar of a value that begins at the first free byte `at`, and once for an array or a
// matrix of numbers. Returns its end.
template <class T, class Emit>
constexpr std::size_t describe(std::size_t at, const NamePart& name, Emit& emit, std::size_t count = 1) {
  if constexpr (Scalar<T>) {
    std::span<const std::string_view> words;
    if constexpr (std::is_enum_v<T>) words = kWordsOf<T>;
    emit(Field{aligned<T>(at), type_name<T>(), count, &name, words});
    return aligned<T>(at) + count * sizeof(NumberOf<T>);
  } else if constexpr (kIsMatrix<T>) {
    return describe<typename T::Scalar>(at, name, emit, count * T::SizeAtCompileTime);
  } else if constexpr (Optional<T>) {
    at = describe<bool>(at, NamePart{&name, "has_value"}, emit);
    return describe<typename T::value_type>(at, name, emit);
  } else if constexpr (HasMembers<T>) {
    const auto describe_member = [&]<class M>(const M& member) {
      const NamePart part{&name, member.name};
      at = describe<typename M::Type>(at, part, emit);
    };
    std::apply([&](const auto&... member) { (describe_member(member), ...); }, T::members());
    return at;
  } else if constexpr (HasMembers<typename T::value_type>) {
    for (std::size_t i = 0; i < std::tuple_size_v<T>; ++i) {
      at = describe<typename T::value_type>(at, NamePart{&name, {}, i}, emit);
    }
    return at;
  } else {
    return describe<typename T::value_type>(at, name, emit, count * std::tuple_size_v<T>);
  }
}

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

}  // namespace armature::mailbox
