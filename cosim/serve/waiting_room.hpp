// Clients that have connected and have not yet said who they are.
//
// They do not count: any of them may stay silent for as long as it likes without keeping another one out.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cosim/serve/client_channel.hpp"
#include "cosim/serve/listener.hpp"

namespace armature::cosim {

// To a client that connects while another one is served.
inline constexpr std::string_view kBusy = "error busy: another client is served, one at a time; closed\n";

class WaitingRoom {
 public:
  explicit WaitingRoom(Listener& listener) : listener_{listener} {}

  // Waits at most `timeout_ms` for bytes or clients. Returns a client that may be served: over a socket file the
  // next that connects; over TCP one whose first line was the token, which has got its answer. The first line of others
  // is refused, and they are closed. Throws std::system_error.
  [[nodiscard]] std::optional<ClientChannel> next(int timeout_ms);

 private:
  // The first line of a waiting client, if it has come. True: the client is admitted. Otherwise it may be lost now.
  bool admits(ClientChannel& client);
  std::optional<ClientChannel> take(std::size_t index);

  Listener& listener_;
  std::vector<ClientChannel> waiting_;
};

}  // namespace armature::cosim
