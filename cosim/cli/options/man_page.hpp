// The manual page of the program, from its options and their texts.
#pragma once

#include <string>
#include <vector>

#include "cosim/cli/options/option_table.hpp"

namespace armature::cosim {

// In the language of man(7), for section 1.
[[nodiscard]] std::string man_page(const CommandRow& program, const std::vector<CommandRow>& commands);

}  // namespace armature::cosim
