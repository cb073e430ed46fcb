// What can stand at the place of a word of a command line. Every shell asks for it, so no shell knows the commands.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/cli/options/option_table.hpp"

namespace armature::cosim {

struct OfferedWord {
  std::string word;
  std::string description{};  // may be empty
};

struct Offer {
  enum class Paths { kNone, kFiles, kFolders };
  std::vector<OfferedWord> words{};
  Paths paths = Paths::kNone;  // what the shell adds by itself
};

// The names of scenarios or robots (a word of value_kinds.hpp), with the folders of --path.
using NamesOf = std::function<std::vector<std::string>(std::string_view kind, const std::vector<std::string>& path)>;

// For the last of `words`, which has begun or is empty. They are the words after the name of the program, at least one.
// Bash makes three words of `--jobs=2`; other shells leave it one. `program`: with the options that every command has.
[[nodiscard]] Offer complete_word(const CommandRow& program, const std::vector<CommandRow>& commands,
                                  std::span<const std::string> words, const NamesOf& names_of);

}  // namespace armature::cosim
