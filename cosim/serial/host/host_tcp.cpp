#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <string>
#include <utility>

#include "cosim/net/listener.hpp"
#include "cosim/net/waiting_clients.hpp"
#include "cosim/serial/host/host_channel.hpp"

namespace armature::cosim {
namespace {

class TcpChannel final : public HostChannel {
 public:
  explicit TcpChannel(std::uint16_t port) : listener_{ListenAddress{.tcp_port = port, .path = {}}} {}

  TcpChannel(const TcpChannel&) = delete;
  TcpChannel& operator=(const TcpChannel&) = delete;

  // Reads the rest: unread bytes would make the host discard those that the client has not read yet.
  ~TcpChannel() override {
    if (!client_) return;
    shutdown(socket(), SHUT_WR);
    std::array<std::uint8_t, 4096> ignored{};
    while (recv(socket(), ignored.data(), ignored.size(), MSG_DONTWAIT) > 0) {
    }
  }

  [[nodiscard]] std::string address() const override { return "127.0.0.1:" + std::to_string(*listener_.tcp_port()); }
  [[nodiscard]] std::string token() const override { return listener_.token().value_or(""); }

  std::size_t read(std::span<std::uint8_t> bytes) override {
    if (!connected()) return 0;
    if (after_token_.empty()) return moved(recv(socket(), bytes.data(), bytes.size(), MSG_DONTWAIT), true);
    const std::size_t count = std::min(bytes.size(), after_token_.size());
    std::copy_n(after_token_.begin(), count, bytes.begin());
    after_token_.erase(0, count);
    return count;
  }

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    if (!connected()) return 0;
    return moved(send(socket(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL), false);
  }

  [[nodiscard]] std::size_t unread() const override { return 0; }

 private:
  [[nodiscard]] int socket() const { return client_->socket().get(); }

  bool connected() {
    if (client_ && waiting_.turn_away(client_->socket())) client_.reset();
    if (client_) return true;
    client_ = waiting_.next(0);
    if (!client_) return false;
    client_->send();  // the answer to the token
    after_token_ = client_->take_rest();
    return true;
  }

  std::size_t moved(ssize_t count, bool zero_is_the_end) {
    const bool later = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if ((count < 0 && !later) || (count == 0 && zero_is_the_end)) client_.reset();
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

  Listener listener_;
  WaitingClients waiting_{listener_};
  std::optional<ClientChannel> client_;
  std::string after_token_;  // bytes that came in one piece with the token
};

}  // namespace

std::unique_ptr<HostChannel> open_tcp(std::uint16_t port) {
  return std::make_unique<TcpChannel>(port);
}

}  // namespace armature::cosim
