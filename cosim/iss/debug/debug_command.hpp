// `armature-iss debug`.
#pragma once

#include "cosim/cli/command/command.hpp"

namespace armature::cosim::iss {

[[nodiscard]] Subcommand debug_command();

}  // namespace armature::cosim::iss
