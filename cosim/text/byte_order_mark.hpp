// The mark that some editors and spreadsheets put at the beginning of a text.
#pragma once

#include <string_view>

namespace armature::cosim {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

// The text without the mark of UTF-8, if it begins with one.
[[nodiscard]] constexpr std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

// The encoding that the first bytes of a text show, other than UTF-8: "UTF-16" or "UTF-32". Empty for none.
[[nodiscard]] constexpr std::string_view foreign_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
  return {};
}

}  // namespace armature::cosim
