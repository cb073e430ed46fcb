#pragma once

#include <algorithm>
#include <string_view>

namespace armature::cosim {

// What may stand between words and values in a line.
inline constexpr std::string_view kBlanks = " \t";

// `text` without the blanks at both ends. Of nothing but blanks it is the empty text at their end.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

}  // namespace armature::cosim
