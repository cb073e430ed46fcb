// Serves the clients of the interpreter, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cosim/net/listener.hpp"
#include "cosim/serve/interpreter.hpp"

namespace armature::cosim {

// A client may send this many lines before it reads the first answer. With more unread answers the server stops
// reading. Within this limit client and server never wait for each other.
inline constexpr std::size_t kMaxInFlight = 4096;
inline constexpr std::size_t kMaxBatchesInFlight = 16;  // of these lines

// Serves until `stop` returns true (polled at least every 50 ms) or a check inside the logic has failed.
//
// One client is served at a time. The state of the logic stays as the client before left it. Over TCP a client must
// send the listener's token in its first line; after any other first line it is closed. A client that connects while
// another is served gets one error line and is closed. Answers are sent in the order of the commands, in batches. The
// lines of a client that closed its sending side are answered. Text after its last end of line is ignored, because it
// may be part of a command. When a client closes the connection or is killed, its run ends. Returns the number of
// clients served. Throws std::system_error when a system call fails.
std::int64_t serve(Listener& listener, Interpreter& interpreter, const StopRequest& stop);

}  // namespace armature::cosim
