// The completion of shells: a script for each shell, which asks the program what it can offer, and the answer.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cosim/cli/options/word_completion.hpp"

namespace armature::cosim {

struct ShellKind {
  std::string_view name;
  std::string_view script;                            // calls `armature completion NAME -- WORDS`
  std::string (*line)(const OfferedWord& word) = {};  // of the answer, without its end
};

[[nodiscard]] const std::array<ShellKind, 3>& shell_kinds();

// The answer: a line `files`, `folders` or `none`, which says what the shell adds, and a line for each word.
[[nodiscard]] std::string answer_text(const ShellKind& shell, const Offer& offer);

}  // namespace armature::cosim
