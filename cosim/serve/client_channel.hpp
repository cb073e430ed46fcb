// The bytes of one client, both ways: lines that come, answers that go. No call waits.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/net/file_descriptor.hpp"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/line_buffer.hpp"

namespace armature::cosim {

class ClientChannel {
 public:
  explicit ClientChannel(FileDescriptor socket) : socket_{std::move(socket)} {}

  [[nodiscard]] const FileDescriptor& socket() const { return socket_; }

  // Takes bytes that have come.
  void receive();
  // The next line that has come; valid until receive().
  std::optional<LineBuffer::Line> next_line() { return lines_.next(); }

  // What the client has not taken yet.
  [[nodiscard]] std::string& answers() { return answers_; }
  // Gives it what it takes now.
  void send();

  // Says this last line, if the client takes it at once, and closes.
  void dismiss(std::string_view line);

  // The client sends no more.
  [[nodiscard]] bool ended() const { return ended_; }
  // Nor does it read.
  [[nodiscard]] bool lost() const { return lost_; }

 private:
  FileDescriptor socket_;
  LineBuffer lines_{Interpreter::kMaxLine};
  std::string answers_;
  bool ended_ = false;
  bool lost_ = false;
};

}  // namespace armature::cosim
