// Stream sockets that never block, for what listens on this machine.
#pragma once

#include <cstdint>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

// AF_INET or AF_UNIX. Throws std::system_error.
[[nodiscard]] FileDescriptor stream_socket(int family);

// A TCP port that only this machine can reach.
struct LoopbackPort {
  FileDescriptor socket;
  std::uint16_t port = 0;  // that was given
};
// 0: any free port. Throws std::system_error when it cannot be had. The port of a program that has just ended can.
[[nodiscard]] LoopbackPort listen_on_loopback(std::uint16_t port, int most_waiting);

// The client that waits longest; nothing when there is none, or errno says why not. What is sent to it goes out at
// once.
[[nodiscard]] FileDescriptor accept_client(const FileDescriptor& listener);

}  // namespace armature::cosim
