#include "cosim/net/client_channel.hpp"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstddef>

namespace armature::cosim {
namespace {

constexpr std::size_t kReadBytes = 1 << 16;

bool try_again() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

void ClientChannel::receive() {
  std::array<char, kReadBytes> chunk;  // not initialised: that would cost more than a short line
  const ssize_t bytes = ::recv(socket_.get(), chunk.data(), chunk.size(), 0);
  if (bytes > 0) {
    lines_.append({chunk.data(), static_cast<std::size_t>(bytes)});
  } else if (bytes == 0) {
    ended_ = true;
  } else if (!try_again()) {
    lost_ = true;
  }
}

void ClientChannel::send() {
  std::size_t done = 0;
  while (done < answers_.size()) {
    const ssize_t bytes = ::send(socket_.get(), answers_.data() + done, answers_.size() - done, MSG_NOSIGNAL);
    if (bytes < 0) {
      lost_ = !try_again();
      break;
    }
    done += static_cast<std::size_t>(bytes);
  }
  answers_.erase(0, done);
}

void ClientChannel::close_with(std::string_view line) {
  answers_ += line;
  send();
  ::shutdown(socket_.get(), SHUT_WR);
  // Unread bytes make the system reset the connection, and the client may then lose the line.
  constexpr int kMaxChunks = 16;
  for (int i = 0; i < kMaxChunks && !ended_ && !lost_; ++i) {
    std::array<char, kReadBytes> ignored;
    if (::recv(socket_.get(), ignored.data(), ignored.size(), 0) <= 0) break;
  }
  socket_.close();
  ended_ = lost_ = true;
}

}  // namespace armature::cosim
