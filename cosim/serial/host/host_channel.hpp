// Bytes to and from another program of this machine: a pseudo-terminal or a TCP connection. No call blocks.
//
// A client may disconnect and connect again. A pseudo-terminal keeps the bytes that the client has not read for the
// next client. With a TCP connection they are lost.
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

  // Address for the client: `/dev/pts/4`, `/dev/pts/4 (link uart)`, `127.0.0.1:4001`.
  [[nodiscard]] virtual std::string address() const = 0;

  // What a client must send first, as `token TOKEN`. Empty: nothing.
  [[nodiscard]] virtual std::string token() const { return {}; }

  // Return the number of bytes moved; 0 when there are no bytes, no space, or no client.
  virtual std::size_t read(std::span<std::uint8_t> bytes) = 0;
  virtual std::size_t write(std::span<const std::uint8_t> bytes) = 0;

  // Written bytes that the client has not read yet, as far as the host reports them.
  [[nodiscard]] virtual std::size_t unread() const = 0;
};

// A pseudo-terminal in raw mode. `link` becomes a symbolic link to it and is removed at the end. A link that is left
// over from another pseudo-terminal is replaced. Any other file of that name is an error. Throws InputError.
[[nodiscard]] std::unique_ptr<HostChannel> open_pty(const std::optional<std::filesystem::path>& link);

// A listener on 127.0.0.1 for one client at a time. A client must send the line `token TOKEN` first, and reads `ok`;
// after any other first line it is closed. A second client is told that the line is busy, and is closed. Port 0: any
// free port. Throws InputError.
[[nodiscard]] std::unique_ptr<HostChannel> open_tcp(std::uint16_t port);

// `pty`, `pty:LINK`, `tcp:PORT`. Throws InputError, also for any other word.
[[nodiscard]] std::unique_ptr<HostChannel> open_host_channel(std::string_view where);

}  // namespace armature::cosim
