// Parts of a text, without the calls that std::string_view makes for them: it throws, and uses the C library.
#pragma once

#include <cstddef>
#include <string_view>

namespace armature {

inline constexpr std::size_t kToEnd = static_cast<std::size_t>(-1);

// From a place on, at most `size` characters; nothing behind the end.
[[nodiscard]] constexpr std::string_view part(std::string_view text, std::size_t from,
                                              std::size_t size = kToEnd) noexcept {
  if (from > text.size()) from = text.size();
  if (size > text.size() - from) size = text.size() - from;
  return {text.data() + from, size};
}

// The place of the first character for which `holds`, from a place on; the size of the text if there is none.
template <class Holds>
[[nodiscard]] constexpr std::size_t place_where(std::string_view text, Holds holds, std::size_t from = 0) noexcept {
  while (from < text.size() && !holds(text[from])) ++from;
  return from < text.size() ? from : text.size();
}

[[nodiscard]] constexpr bool is_blank(char character) noexcept {
  return character == ' ' || character == '\t';
}

}  // namespace armature
