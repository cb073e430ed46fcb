// Non-blocking stream sockets for servers on this machine.
#pragma once

#include <cstdint>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

// AF_INET or AF_UNIX. Throws std::system_error.
[[nodiscard]] FileDescriptor stream_socket(int family);

// A TCP port that only this machine can reach.
struct LoopbackPort {
  FileDescriptor socket;
  std::uint16_t port = 0;  // the actual one
};
// Port 0: any free port. Throws std::system_error when the port is not available. The port of a program that has just
// ended is available. `backlog`: clients that may wait for accept_client().
[[nodiscard]] LoopbackPort listen_on_loopback(std::uint16_t port, int backlog);

// Accepts the client that has waited longest. Returns an empty descriptor when there is none or an error occurred;
// errno has the reason. Data to the client is sent without delay (TCP_NODELAY).
[[nodiscard]] FileDescriptor accept_client(const FileDescriptor& listener);

}  // namespace armature::cosim
