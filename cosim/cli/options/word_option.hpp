// An option whose value is the word of an enumerator.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/words.hpp"

namespace armature::cosim {

// `chosen` must outlive the parsing.
template <class Enum>
void add_word_option(CLI::App& command, const std::string& option, std::optional<Enum>& chosen,
                     const std::string& help) {
  constexpr auto& kNames = kWordsOf<Enum>;
  command
      .add_option_function<std::string>(
          option, [&chosen](const std::string& name) { chosen = enumerator_of<Enum>(name); }, help)
      ->check(CLI::IsMember(std::vector<std::string>(kNames.begin(), kNames.end())));
}

// A help of a key, which is Markdown, as help of an option.
[[nodiscard]] inline std::string without_markdown(std::string_view help) {
  std::string text{help};
  std::ranges::replace(text, '`', '\'');
  return text;
}

}  // namespace armature::cosim
