// Clients of the interpreter, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/listener.hpp"

namespace armature::cosim {

// So many lines may be sent before the first answer is read; with more unread answers the server stops reading. A
// client that keeps to it never waits for a server that waits for the client.
inline constexpr std::size_t kMaxInFlight = 4096;

// Serves until `stop` returns true (looked at every 50 ms at least) or a check inside the logic has failed.
//
// One client at a time; it finds the logic as the one before has left it. Over TCP a client is served once its first
// line has given the listener's token, and is closed after any other first line. Who connects while another is served
// gets one line that says so and is closed. Answers go out in the order of the commands, as many at a time as there
// are. The lines of a client that closed its sending side are answered; what it sent after its last end of line is no
// command, because it may be half of one. A client that has gone, or was killed, ends a run that it has begun.
// Returns the number of clients served. Throws std::system_error when the system refuses to go on.
std::int64_t serve(Listener& listener, Interpreter& interpreter, const StopRequest& stop);

}  // namespace armature::cosim
