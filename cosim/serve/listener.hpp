// Where clients connect: a Unix socket, or a TCP port that only this machine can reach.
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
  std::optional<std::uint16_t> tcp_port;  // on 127.0.0.1; 0: any free one
  std::filesystem::path path;             // of a Unix socket, when there is no port
};

// `tcp:PORT`, or a path; one with a colon has a slash before it, as in `./a:b`. Throws InputError.
[[nodiscard]] ListenAddress parse_listen_address(std::string_view text);

class Listener {
 public:
  // Throws InputError when the address cannot be had: a port in use, a path of something that is no socket or of a
  // socket at which another server answers. A socket file that a killed server left behind is replaced. Only the user
  // who runs the program may connect to a path: clients write waveform files in the user's name.
  explicit Listener(const ListenAddress& address);
  // Removes the socket file, if it is still the one that was made.
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  [[nodiscard]] const FileDescriptor& socket() const { return socket_; }

  // As after --listen, with the port that was given.
  [[nodiscard]] std::string name() const;

  // What a client has to say first; drawn anew by every listener on a port, and nothing for a path.
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
