// The name of a type or an enumerator, from what a compiler writes for __PRETTY_FUNCTION__.
#pragma once

#include <string_view>

namespace armature {

// `JogEnded` of "... [T = armature::JogEnded]", or with a `;` behind, for the mark "T = ". Empty for a value without
// an enumerator, which compilers write as a number: "(armature::JogEnd)7".
[[nodiscard]] constexpr std::string_view name_behind(std::string_view signature, std::string_view mark) noexcept {
  std::string_view text = signature.substr(signature.find(mark) + mark.size());
  text = text.substr(0, text.find_first_of(";]"));
  if (text.find('(') != std::string_view::npos) return {};
  return text.substr(text.rfind(':') + 1);
}

}  // namespace armature
