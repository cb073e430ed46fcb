// Whether the program at the other end of a connection still has it open.
#pragma once

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

// True when the other end has closed the connection, was killed, or has reset it. False when it only shut down its
// sending side and still reads answers. TCP sends the same segment in both cases. Here both ends are on this machine,
// so the kernel reports whether a program still has the other end open. A call takes about 10 us. Also false when the
// kernel does not support the query (no INET_DIAG).
[[nodiscard]] bool peer_closed(const FileDescriptor& socket);

}  // namespace armature::cosim
