// Serves gdb: the connection between its socket, the protocol and the run.
#pragma once

#include <cstdint>
#include <functional>

#include "cosim/iss/debug/remote_run.hpp"
#include "cosim/net/stream_socket.hpp"

namespace armature::cosim::iss {

enum class DebugEnd : std::uint8_t { kRunEnded, kKilled, kInterrupted };

struct DebugResult {
  DebugEnd end = DebugEnd::kRunEnded;
  Stop stop{};  // of kRunEnded
};

// Serves one gdb at a time; another one that connects meanwhile is closed. The run stands while none is connected, and
// stops when one goes away without detach or kill: the next one finds it there. Returns when the run has ended, gdb has
// killed it, or `stop` returns true (polled at least every 50 ms). Throws std::system_error when a system call fails.
[[nodiscard]] DebugResult serve_debugger(const LoopbackPort& port, RemoteRun& run, const std::function<bool()>& stop);

}  // namespace armature::cosim::iss
