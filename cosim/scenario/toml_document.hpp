// TOML text to a ConfigValue tree.
#pragma once

#include <string>
#include <string_view>

#include "cosim/scenario/config_value.hpp"

namespace armature::cosim {

// The root table. `file` is for messages. Throws InputError with line and column on a syntax error or duplicate key
// (TOML stops at the first of these).
[[nodiscard]] ConfigValue parse_toml(std::string_view text, const std::string& file);

}  // namespace armature::cosim
