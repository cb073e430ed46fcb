// Scripts with which a shell completes the command line of the program.
#pragma once

#include <string>
#include <vector>

#include "cosim/cli/option_table.hpp"

namespace armature::cosim {

// For bash. `program`: with the options that every command has.
[[nodiscard]] std::string bash_completion(const CommandRow& program, const std::vector<CommandRow>& commands);

}  // namespace armature::cosim
