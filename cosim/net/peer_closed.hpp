// Whether the program at the other end of a connection is still there.
#pragma once

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

// True when the other end has closed the connection, was killed, or has reset it; false when it only shut down its
// sending side and still takes answers. TCP sends the same for both, but here both ends are on this machine: the
// kernel says whether a program still holds the other end. Takes some 10 us.
// False, too, when this kernel does not tell (no INET_DIAG).
[[nodiscard]] bool peer_closed(const FileDescriptor& socket);

}  // namespace armature::cosim
