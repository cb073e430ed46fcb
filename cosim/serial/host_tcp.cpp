#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "cosim/net/stream_socket.hpp"
#include "cosim/serial/host_channel.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr int kTcpBacklog = 4;

LoopbackPort listen_for_clients(std::uint16_t port) try {
  return listen_on_loopback(port, kTcpBacklog);
} catch (const std::system_error& error) {
  throw InputError{"tcp:" + std::to_string(port), error.what()};
}

class TcpChannel final : public HostChannel {
 public:
  explicit TcpChannel(std::uint16_t port) : listener_{listen_for_clients(port)} {}

  TcpChannel(const TcpChannel&) = delete;
  TcpChannel& operator=(const TcpChannel&) = delete;

  // Reads the rest: unread bytes would make the host discard those that the client has not read yet.
  ~TcpChannel() override {
    if (!client_) return;
    shutdown(client_.get(), SHUT_WR);
    std::array<std::uint8_t, 4096> ignored{};
    while (recv(client_.get(), ignored.data(), ignored.size(), MSG_DONTWAIT) > 0) {
    }
  }

  [[nodiscard]] std::string address() const override { return "127.0.0.1:" + std::to_string(listener_.port); }

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
    if (!client_) client_ = accept_client(listener_.socket);
    return static_cast<bool>(client_);
  }

  std::size_t moved(ssize_t count, bool zero_is_the_end) {
    const bool later = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if ((count < 0 && !later) || (count == 0 && zero_is_the_end)) client_.close();
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

  LoopbackPort listener_;
  FileDescriptor client_;
};

}  // namespace

std::unique_ptr<HostChannel> open_tcp(std::uint16_t port) {
  return std::make_unique<TcpChannel>(port);
}

}  // namespace armature::cosim
