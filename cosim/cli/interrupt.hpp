// Ctrl-C ends a run in an orderly way: files are closed, the summary is printed, the exit code is 130.
#pragma once

namespace armature::cosim {

// From now on SIGINT and SIGTERM only set the flag below; a second one ends the program at once.
void catch_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace armature::cosim
