// Bytes to and from another program of this machine: a pseudo-terminal or a TCP connection. No call blocks.
//
// A client may go and come back. What it has not fetched when it goes: a pseudo-terminal keeps it for the next client,
// a TCP connection that was closed takes it along.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace armature::cosim {

class HostChannel {
 public:
  virtual ~HostChannel() = default;

  // Where a client finds it: `/dev/pts/4`, `/dev/pts/4 (link uart)`, `127.0.0.1:4001`.
  [[nodiscard]] virtual std::string place() const = 0;

  // Bytes moved; 0 when there are none, no room, or no client.
  virtual std::size_t read(std::span<std::uint8_t> bytes) = 0;
  virtual std::size_t write(std::span<const std::uint8_t> bytes) = 0;

  // Bytes written that wait in this machine for the client, as far as it tells.
  [[nodiscard]] virtual std::size_t unread() const = 0;
};

// A pseudo-terminal in raw mode. `link` becomes a symbolic link to it and is removed at the end; one that is left over
// from a pseudo-terminal is replaced, anything else of that name is refused. Throws InputError.
[[nodiscard]] std::unique_ptr<HostChannel> open_pty(const std::optional<std::filesystem::path>& link);

// A listener on 127.0.0.1, one client at a time, further ones wait; port 0: any free one. Throws InputError.
[[nodiscard]] std::unique_ptr<HostChannel> open_tcp(std::uint16_t port);

// `pty`, `pty:LINK`, `tcp:PORT`. Throws InputError, also for any other word.
[[nodiscard]] std::unique_ptr<HostChannel> open_host_channel(std::string_view where);

}  // namespace armature::cosim
