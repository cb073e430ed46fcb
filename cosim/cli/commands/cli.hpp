// The command line: parses it, runs the chosen command, turns exceptions into messages and exit codes.
#pragma once

namespace armature::cosim {

// Returns the exit code of the program.
int cli_main(int argc, const char* const* argv);

}  // namespace armature::cosim
