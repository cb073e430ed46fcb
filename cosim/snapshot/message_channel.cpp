#include "cosim/snapshot/message_channel.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace armature::cosim {
namespace {

// Waits again when a signal ends the call.
template <class Call>
ssize_t despite_signals(Call call) {
  ssize_t result = -1;
  do {
    result = call();
  } while (result < 0 && errno == EINTR);
  return result;
}

}  // namespace

std::pair<MessageChannel, MessageChannel> MessageChannel::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error{errno, std::generic_category(), "cannot create a channel between processes"};
  }
  return {MessageChannel{ends[0]}, MessageChannel{ends[1]}};
}

bool MessageChannel::wait() {
  char byte = 0;
  return despite_signals([&] { return ::recv(end_.get(), &byte, sizeof(byte), MSG_PEEK); }) > 0;
}

bool MessageChannel::is_due() const {
  pollfd state{end_.get(), POLLIN, 0};
  return ::poll(&state, 1, 0) > 0;
}

bool MessageChannel::send(const void* message, std::size_t size) {
  const ssize_t sent = despite_signals([&] { return ::send(end_.get(), message, size, MSG_NOSIGNAL); });
  return sent == static_cast<ssize_t>(size);
}

bool MessageChannel::get(void* message, std::size_t size, Keep keep) {
  const int flags = keep == Keep::kYes ? MSG_PEEK : 0;
  return despite_signals([&] { return ::recv(end_.get(), message, size, flags); }) == static_cast<ssize_t>(size);
}

}  // namespace armature::cosim
