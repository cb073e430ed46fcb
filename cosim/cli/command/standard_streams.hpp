// The standard streams, which a caller may have closed.
#pragma once

namespace armature::cosim {

// Opens a substitute for each standard stream that the caller has closed. Without it the next file that is opened would
// get the number of the stream, and the text for the stream. Reading and writing the substitute fails.
void fill_standard_streams();

// Flushes standard output. Returns false, with a message on standard error, when not all of it could be written. When
// the reader has closed the pipe, as `head` does after some lines, SIGPIPE ends the program here without a message.
[[nodiscard]] bool flush_standard_output();

}  // namespace armature::cosim
