// The socket to which clients connect: a Unix socket, or a TCP port that only this machine can reach.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

struct ListenAddress {
  std::optional<std::uint16_t> tcp_port;  // on 127.0.0.1; 0: any free port
  std::filesystem::path path;             // of a Unix socket, when there is no port
};

// A decimal number 0..65535.
[[nodiscard]] std::optional<std::uint16_t> parse_port(std::string_view digits);

// `tcp:PORT`, or a path. A path with a colon needs a slash before the colon, as in `./a:b`. Throws InputError.
[[nodiscard]] ListenAddress parse_listen_address(std::string_view text);

class Listener {
 public:
  // Throws InputError when the address is not available: the port is in use, the path exists and is not a socket, or
  // another server listens there. A socket file that a killed server left behind is replaced. Only the user who runs
  // the program may connect to a path, because clients write waveform files with the rights of this user.
  explicit Listener(const ListenAddress& address);
  // Removes the socket file, if it is still the one that this object created.
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  [[nodiscard]] const FileDescriptor& socket() const { return socket_; }

  // `tcp:PORT` with the actual port, or the path.
  [[nodiscard]] std::string name() const;

  [[nodiscard]] const std::optional<std::uint16_t>& tcp_port() const { return address_.tcp_port; }

  // The token that a client must send first. Every listener on a port has a new one; none for a path.
  [[nodiscard]] const std::optional<std::string>& token() const { return token_; }

 private:
  void listen_on_port(std::uint16_t port);
  void listen_on_path(const std::filesystem::path& path);

  FileDescriptor socket_;
  ListenAddress address_;
  std::optional<std::string> token_;
  dev_t device_ = 0;  // of the socket file
  ino_t inode_ = 0;
};

}  // namespace armature::cosim
