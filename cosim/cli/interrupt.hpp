// Ctrl-C ends a run in an orderly way: files are closed, the summary is printed, the exit code is 130.
#pragma once

namespace armature::cosim {

// From now on SIGINT, SIGTERM and SIGHUP only set the flag below; another one ends the program at once, but not within
// a second of the first: timeout(1) and terminals send the same request twice. To be called by whoever then looks at
// the flag; until then these signals end the program as they do any other.
void catch_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace armature::cosim
