// Ctrl-C ends a run in an orderly way: the program closes the files, prints the summary and exits with 130.
#pragma once

namespace armature::cosim {

// From now on the first SIGINT, SIGTERM or SIGHUP only sets the flag below. A further one ends the program at once,
// except within a second of the first: timeout(1) and terminals send the same request twice. Only a command that checks
// the flag calls this; without the call these signals end the program as usual.
void catch_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace armature::cosim
