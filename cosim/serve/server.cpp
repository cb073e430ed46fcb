#include "cosim/serve/server.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "cosim/net/stream_socket.hpp"
#include "cosim/serve/line_buffer.hpp"

namespace armature::cosim {
namespace {

// A signal may come between the look at the stop request and the wait; it is then seen this much later.
constexpr int kStopPollMs = 100;
constexpr std::size_t kReadBytes = 1 << 16;
constexpr std::size_t kMaxUnsent = kMaxInFlight * Interpreter::kMaxAnswer;
// Answers go out after this much simulated time, some milliseconds, even when there are more lines.
constexpr Cycles kBatch{50'000};

bool try_again() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

void wait_for(const FileDescriptor& descriptor, short events) {
  pollfd poll{descriptor.get(), events, 0};
  if (::poll(&poll, 1, kStopPollMs) < 0 && errno != EINTR) {
    throw std::system_error{errno, std::generic_category(), "cannot wait for a client"};
  }
}

class Connection {
 public:
  Connection(FileDescriptor socket, Interpreter& interpreter) : socket_{std::move(socket)}, interpreter_{interpreter} {}

  void serve(const std::function<bool()>& stop) {
    while (!lost_) {
      const bool all_answered = answer(stop);
      send();
      const bool sent = answers_.empty();
      if (stop() || interpreter_.broken() || (ended_ && all_answered && sent)) break;
      if (lost_ || (!all_answered && answers_.size() < kMaxUnsent)) continue;
      const bool read = all_answered && !ended_;
      wait_for(socket_, static_cast<short>((read ? POLLIN : 0) | (sent ? 0 : POLLOUT)));
      if (read) receive();
    }
  }

 private:
  // Answers the lines that have come; false when it may have left some.
  bool answer(const std::function<bool()>& stop) {
    const Cycles end = interpreter_.now() + kBatch;
    while (answers_.size() < kMaxUnsent && interpreter_.now() < end && !interpreter_.broken() && !stop()) {
      const std::optional<LineBuffer::Line> line = lines_.next();
      if (!line) return true;
      if (line->too_long) {
        interpreter_.answer_to_long_line(answers_);
      } else {
        interpreter_.answer(line->text, answers_);
      }
    }
    return false;
  }

  void receive() {
    const ssize_t bytes = ::recv(socket_.get(), chunk_.data(), chunk_.size(), 0);
    if (bytes > 0) {
      lines_.append({chunk_.data(), static_cast<std::size_t>(bytes)});
    } else if (bytes == 0) {
      ended_ = true;
    } else if (!try_again()) {
      lost_ = true;
    }
  }

  void send() {
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

  FileDescriptor socket_;
  Interpreter& interpreter_;
  LineBuffer lines_{Interpreter::kMaxLine};
  std::string answers_;
  std::array<char, kReadBytes> chunk_{};
  bool ended_ = false;  // the client sends no more
  bool lost_ = false;   // nor does it read
};

}  // namespace

std::int64_t serve(Listener& listener, Interpreter& interpreter, const std::function<bool()>& stop) {
  std::int64_t clients = 0;
  while (!stop() && !interpreter.broken()) {
    wait_for(listener.socket(), POLLIN);
    FileDescriptor socket = accept_client(listener.socket());
    if (!socket) {
      if (try_again() || errno == ECONNABORTED) continue;
      throw std::system_error{errno, std::generic_category(), "cannot accept a client"};
    }
    ++clients;
    Connection{std::move(socket), interpreter}.serve(stop);
  }
  return clients;
}

}  // namespace armature::cosim
