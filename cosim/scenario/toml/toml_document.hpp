// TOML text to a ConfigValue tree.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

// The root table. `file` is for messages. A byte order mark of UTF-8 is skipped. Throws InputError with line and column
// on a syntax error or duplicate key (TOML stops at the first of these), and for a text beyond toml_limits.hpp.
[[nodiscard]] ConfigValue parse_toml(std::string_view text, const std::string& file);

// The text of a regular file. Throws InputError when it cannot be read, or is too large.
[[nodiscard]] std::string read_toml(const std::filesystem::path& file);

}  // namespace armature::cosim
