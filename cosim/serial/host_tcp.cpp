#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "cosim/serial/file_descriptor.hpp"
#include "cosim/serial/host_channel.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr int kWaitingClients = 4;

class TcpChannel final : public HostChannel {
 public:
  explicit TcpChannel(std::uint16_t port) {
    const std::string name = "tcp:" + std::to_string(port);
    listener_ = FileDescriptor{socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    const int on = 1;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    if (!listener_.valid() || setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        bind(listener_.get(), generic, length) != 0 || listen(listener_.get(), kWaitingClients) != 0 ||
        getsockname(listener_.get(), generic, &length) != 0) {
      throw InputError{name, std::string{"cannot listen on this port: "} + std::strerror(errno)};
    }
    port_ = ntohs(address.sin_port);
  }

  TcpChannel(const TcpChannel&) = delete;
  TcpChannel& operator=(const TcpChannel&) = delete;

  // Bytes that we leave unread would make the host drop those that the client has not read yet.
  ~TcpChannel() override {
    if (!client_.valid()) return;
    shutdown(client_.get(), SHUT_WR);
    std::array<std::uint8_t, 4096> ignored{};
    while (recv(client_.get(), ignored.data(), ignored.size(), MSG_DONTWAIT) > 0) {
    }
  }

  [[nodiscard]] std::string place() const override { return "127.0.0.1:" + std::to_string(port_); }

  std::size_t read(std::span<std::uint8_t> bytes) override {
    if (!connected()) return 0;
    return moved(recv(client_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT), true);
  }

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    if (!connected()) return 0;
    return moved(send(client_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL), false);
  }

  [[nodiscard]] std::size_t unread() const override { return 0; }

 private:
  bool connected() {
    if (client_.valid()) return true;
    client_ = FileDescriptor{accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (!client_.valid()) return false;
    const int on = 1;
    setsockopt(client_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return true;
  }

  std::size_t moved(ssize_t count, bool zero_is_the_end) {
    const bool later = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if ((count < 0 && !later) || (count == 0 && zero_is_the_end)) client_.close();
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

  FileDescriptor listener_;
  FileDescriptor client_;
  std::uint16_t port_ = 0;
};

}  // namespace

std::unique_ptr<HostChannel> open_tcp(std::uint16_t port) {
  return std::make_unique<TcpChannel>(port);
}

}  // namespace armature::cosim
