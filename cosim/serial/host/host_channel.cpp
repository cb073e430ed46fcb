#include "cosim/serial/host/host_channel.hpp"

#include "cosim/net/listener.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

std::unique_ptr<HostChannel> open_host_channel(std::string_view where) {
  constexpr std::string_view kPtyPrefix = "pty:", kTcpPrefix = "tcp:";
  if (where == "pty") return open_pty(std::nullopt);
  if (where.starts_with(kPtyPrefix) && where.size() > kPtyPrefix.size())
    return open_pty(where.substr(kPtyPrefix.size()));
  if (where.starts_with(kTcpPrefix)) {
    if (const auto port = parse_port(where.substr(kTcpPrefix.size()))) return open_tcp(*port);
  }
  throw InputError{std::string{where}, "expected pty, pty:LINK or tcp:PORT with a port from 0 (any) to 65535"};
}

}  // namespace armature::cosim
