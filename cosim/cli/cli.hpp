// The command line: parses, delegates to commands.hpp, turns exceptions into messages and exit codes.
#pragma once

namespace armature::cosim {

int cli_main(int argc, char** argv);

}  // namespace armature::cosim
