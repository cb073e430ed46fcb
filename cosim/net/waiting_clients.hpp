// Clients that have connected but have not sent the token yet.
//
// They do not block other clients, however long they send nothing.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cosim/net/client_channel.hpp"
#include "cosim/net/listener.hpp"

namespace armature::cosim {

// Answer to a client that connects while another one is served.
inline constexpr std::string_view kBusy = "error busy: another client is served, one at a time; closed\n";

class WaitingClients {
 public:
  explicit WaitingClients(Listener& listener) : listener_{listener} {}

  // Waits at most `timeout_ms` for bytes or clients. Returns a client that may be served, if there is one. Over a
  // socket file this is the next client that connects. Over TCP it is a client whose first line was the token; its
  // answers() contain the answer. Clients with another first line get an error and are closed. Throws
  // std::system_error.
  [[nodiscard]] std::optional<ClientChannel> next(int timeout_ms);

  // Sends kBusy to a client that has connected while `served` is served, and closes it. If the program at the other end
  // of `served` has gone, the new client waits instead, to be the next() one, and the result is true. Does nothing if
  // no client has connected.
  bool turn_away(const FileDescriptor& served);

 private:
  // Checks the first line of a waiting client, if it has arrived. Returns whether the client is admitted. A rejected
  // client is closed.
  bool admit(ClientChannel& client);
  // Removes and returns this client. All others get kBusy and are closed.
  std::optional<ClientChannel> pop(std::size_t index);

  Listener& listener_;
  std::vector<ClientChannel> waiting_;
};

}  // namespace armature::cosim
