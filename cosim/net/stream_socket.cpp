#include "cosim/net/stream_socket.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <system_error>

#include "cosim/net/generic_address.hpp"

namespace armature::cosim {

FileDescriptor stream_socket(int family) {
  FileDescriptor socket{::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  if (!socket) throw std::system_error{errno, std::generic_category(), "cannot create a socket"};
  return socket;
}

LoopbackPort listen_on_loopback(std::uint16_t port, int backlog) {
  FileDescriptor socket = stream_socket(AF_INET);
  const int on = 1;
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  name.sin_port = htons(port);
  socklen_t size = sizeof name;
  sockaddr* const generic = generic_address(name);
  if (::bind(socket.get(), generic, size) != 0 || ::listen(socket.get(), backlog) != 0 ||
      ::getsockname(socket.get(), generic, &size) != 0) {
    throw std::system_error{errno, std::generic_category(), "cannot listen"};
  }
  return {.socket = std::move(socket), .port = ntohs(name.sin_port)};
}

FileDescriptor accept_client(const FileDescriptor& listener) {
  FileDescriptor client{::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  const int error = errno;
  const int on = 1;
  if (client) ::setsockopt(client.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);  // a Unix socket has no delay
  errno = error;
  return client;
}

}  // namespace armature::cosim
