// Lists of alternatives in messages and documents.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

// `1, 1.5 or 2`; empty for no words.
[[nodiscard]] inline std::string or_list(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " or ";
    text += words[i];
  }
  return text;
}

// The same with `quote` on both sides of each word.
[[nodiscard]] inline std::string or_list(const std::vector<std::string_view>& words, char quote) {
  std::vector<std::string> quoted;
  quoted.reserve(words.size());
  for (const std::string_view word : words) quoted.push_back(quote + std::string{word} + quote);
  return or_list(quoted);
}

}  // namespace armature::cosim
