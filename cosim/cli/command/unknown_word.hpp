// "Did you mean" for the words of the command line that the parser does not know.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"

namespace armature::cosim {

// The message about the first word that the parser did not accept, if it is an option, should be a command, or its
// command has advice for it (Subcommand::stray, of the command that is given). Otherwise nothing: the message of the
// parser is better then.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app, const std::vector<Subcommand>& commands);

}  // namespace armature::cosim
