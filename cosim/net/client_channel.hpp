// The connection to one client: received lines, and answers to send. No call blocks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/net/file_descriptor.hpp"
#include "cosim/net/line_buffer.hpp"

namespace armature::cosim {

class ClientChannel {
 public:
  static constexpr std::size_t kMaxLine = 4096;  // a longer line is discarded; its end is not counted

  explicit ClientChannel(FileDescriptor socket) : socket_{std::move(socket)} {}

  // Longer lines are accepted from now on.
  void accept_lines_of(std::size_t bytes) { lines_.set_longest(bytes); }

  [[nodiscard]] const FileDescriptor& socket() const { return socket_; }

  // Receives the bytes that have arrived.
  void receive();
  // The next complete line, if there is one; valid until receive().
  std::optional<LineBuffer::Line> next_line() { return lines_.next(); }

  // The received bytes after the lines that were returned. next_line() returns none of them.
  [[nodiscard]] std::string take_rest() { return lines_.take_rest(); }

  // Answers that have not been sent yet.
  [[nodiscard]] std::string& answers() { return answers_; }
  // Sends as much of answers() as the socket accepts now.
  void send();

  // Sends `line` if the socket accepts it at once, and closes the connection.
  void close_with(std::string_view line);

  // The client has closed its sending side.
  [[nodiscard]] bool ended() const { return ended_; }
  // The connection is closed or has failed.
  [[nodiscard]] bool lost() const { return lost_; }

 private:
  FileDescriptor socket_;
  LineBuffer lines_{kMaxLine};
  std::string answers_;
  bool ended_ = false;
  bool lost_ = false;
};

}  // namespace armature::cosim
