// "Did you mean" for the words of the command line that the parser does not know.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace armature::cosim {

// The message about the first word that parsing left over, when that is an option or stands for a command; otherwise
// nothing, and the parser's own message is the better one.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace armature::cosim
