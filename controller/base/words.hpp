// The words of enumerators, as files and messages use them: `time_out` for JogEnd::kTimeOut. The word is the name of
// the enumerator itself, so there is no second list. An enumeration with words has the values 0, 1, 2 ....
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "controller/base/pretty_name.hpp"

namespace armature {
namespace words_detail {

// `kTimeOut`; empty if no enumerator has the value.
template <auto kValue>
[[nodiscard]] consteval std::string_view enumerator() {
  return name_behind(__PRETTY_FUNCTION__, "kValue = ");
}

[[nodiscard]] constexpr bool is_upper(char letter) {
  return letter >= 'A' && letter <= 'Z';
}

struct Word {
  std::array<char, 40> letters{};
  std::size_t size = 0;
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {letters.data(), size}; }
};

// `time_out` of `kTimeOut`, `scurve` of `kSCurve`.
[[nodiscard]] constexpr Word to_word(std::string_view enumerator) {
  Word word;
  for (std::size_t i = 1; i < enumerator.size(); ++i) {
    const bool upper = is_upper(enumerator[i]);
    if (upper && i > 1 && !is_upper(enumerator[i - 1])) word.letters[word.size++] = '_';
    word.letters[word.size++] = upper ? static_cast<char>(enumerator[i] - 'A' + 'a') : enumerator[i];
  }
  return word;
}

template <auto kValue>
inline constexpr Word kWord = to_word(enumerator<kValue>());

template <class Enum, std::size_t kFrom = 0>
[[nodiscard]] consteval std::size_t count() {
  if constexpr (enumerator<static_cast<Enum>(kFrom)>().empty()) {
    return kFrom;
  } else {
    return count<Enum, kFrom + 1>();
  }
}

}  // namespace words_detail

// All words of an enumeration, in the order of its enumerators.
template <class Enum>
requires std::is_enum_v<Enum>
inline constexpr auto kWordsOf = []<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
  return std::array{words_detail::kWord<static_cast<Enum>(kIndex)>.view()...};
}
(std::make_index_sequence<words_detail::count<Enum>()>{});

// Empty for a value without an enumerator.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::string_view word_of(Enum value) noexcept {
  const auto index = static_cast<std::size_t>(value);
  return index < kWordsOf<Enum>.size() ? kWordsOf<Enum>[index] : std::string_view{};
}

// The enumerator of a word.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::optional<Enum> enumerator_of(std::string_view word) noexcept {
  for (std::size_t i = 0; i < kWordsOf<Enum>.size(); ++i) {
    if (kWordsOf<Enum>[i] == word) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace armature
