// A copy of this process by fork(): all its memory, which is shared until one of the two writes a page of it.
//
// The copy disturbs nobody. It ends when this process ends, or the thread that made it. It has no output: what it
// writes is thrown away, except to files that it opens itself. It reads on in the files that this process reads, each
// from the place at the time of the copy. All other descriptors, such as sockets, are of this process alone. The copy
// must end with _exit(), because the buffers of its files have what this process writes, too.
#pragma once

#include <sys/types.h>

namespace armature::cosim {

// As fork(): returns the process of the copy, and 0 in the copy. The copy keeps the descriptor `kept`. Only the thread
// that calls exists in the copy. Throws std::runtime_error when the copy cannot be made: this process has other
// threads, the open files cannot be listed, or the host refuses.
[[nodiscard]] pid_t copy_this_process(int kept);

// Waits for the end of a copy. Returns its exit code, or -1 when it did not exit by itself.
int wait_for_end(pid_t copy);

}  // namespace armature::cosim
