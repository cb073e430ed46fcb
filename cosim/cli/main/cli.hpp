// The command line: parses it, runs the chosen command, turns exceptions into messages and exit codes.
#pragma once

#include <vector>

#include "cosim/cli/command/command.hpp"

namespace armature::cosim {

// Returns the exit code of the program. `more`: commands that not every program has.
int cli_main(int argc, const char* const* argv, const std::vector<Subcommand>& more = {});

}  // namespace armature::cosim
