#include "cosim/net/waiting_clients.hpp"

#include <poll.h>

#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>

#include "cosim/net/peer_closed.hpp"
#include "cosim/net/stream_socket.hpp"
#include "cosim/net/token.hpp"

namespace armature::cosim {
namespace {

// When one more connects, the client that has waited longest is closed.
constexpr std::size_t kMaxWaiting = 16;

}  // namespace

std::optional<ClientChannel> WaitingClients::next(int timeout_ms) {
  std::vector<pollfd> polls{{listener_.socket().get(), POLLIN, 0}};
  for (const ClientChannel& client : waiting_) polls.push_back({client.socket().get(), POLLIN, 0});
  if (::poll(polls.data(), polls.size(), timeout_ms) < 0 && errno != EINTR) {
    throw std::system_error{errno, std::generic_category(), "cannot wait for a client"};
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (polls[i + 1].revents != 0 && admit(waiting_[i])) return pop(i);
  }
  std::erase_if(waiting_, [](const ClientChannel& client) { return client.lost(); });
  if (polls[0].revents == 0) return std::nullopt;
  FileDescriptor socket = accept_client(listener_.socket());
  if (!socket) {
    if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR || errno == ECONNABORTED) return std::nullopt;
    throw std::system_error{errno, std::generic_category(), "cannot accept a client"};
  }
  if (!listener_.token()) return ClientChannel{std::move(socket)};
  if (waiting_.size() == kMaxWaiting) {
    waiting_.front().close_with(check_first_line("", listener_.token()).answer);
    waiting_.erase(waiting_.begin());
  }
  waiting_.emplace_back(std::move(socket));
  return std::nullopt;
}

bool WaitingClients::turn_away(const FileDescriptor& served) {
  pollfd arrival{listener_.socket().get(), POLLIN, 0};
  if (::poll(&arrival, 1, 0) <= 0) return false;
  if (peer_closed(served)) return true;
  FileDescriptor other = accept_client(listener_.socket());
  if (other) ClientChannel{std::move(other)}.close_with(kBusy);
  return false;
}

bool WaitingClients::admit(ClientChannel& client) {
  client.receive();
  const std::optional<LineBuffer::Line> first = client.next_line();
  if (!first) {
    if (client.ended()) client.close_with("");
    return false;
  }
  const Admission admission = check_first_line(first->text, listener_.token());
  if (!admission.admitted) {
    client.close_with(admission.answer);
    return false;
  }
  client.answers() += admission.answer;
  return true;
}

std::optional<ClientChannel> WaitingClients::pop(std::size_t index) {
  ClientChannel client = std::move(waiting_[index]);
  waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(index));
  for (ClientChannel& other : waiting_) other.close_with(kBusy);
  waiting_.clear();
  return client;
}

}  // namespace armature::cosim
