// "Did you mean" for the words of the command line that the parser does not know.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace armature::cosim {

// The message about the first word that the parser did not accept, if it is an option or should be a command. Otherwise
// nothing: the message of the parser is better then.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace armature::cosim
