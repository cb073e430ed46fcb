// The streams that every program is given, or not.
#pragma once

namespace armature::cosim {

// Puts something in the place of a standard stream that the caller closed, so that no file that is opened later gets
// its number and the text that was meant for it. Reading and writing what is there fails, as with a closed one.
void fill_standard_streams();

// Writes out what is left for standard output. False, with a message on standard error, when not all of it could be
// written. When its reader is gone, as `head` is after some lines, the program ends here by SIGPIPE, without a word.
[[nodiscard]] bool flush_standard_output();

}  // namespace armature::cosim
