// A browser of one connection, made of bytes: it shares no code with the server. It lets the server work while it
// waits.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/live/web_server.hpp"
#include "cosim/net/file_descriptor.hpp"
#include "cosim/net/generic_address.hpp"

namespace armature::cosim::test {

class WebClient {
 public:
  WebClient(WebServer& server, std::uint16_t port) : server_{server}, socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    name.sin_port = htons(port);
    EXPECT_EQ(::connect(socket_.get(), generic_address(name), sizeof name), 0);
    ::fcntl(socket_.get(), F_SETFL, O_NONBLOCK);
    server_.handle({});  // a port keeps few that it has not accepted
  }

  void send(std::string_view bytes) const {
    EXPECT_EQ(::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  void close() { socket_.close(); }

  // Lets the server work until the condition is true; fails after a long time.
  bool wait_until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      server_.handle(std::chrono::milliseconds{1});
      receive();
    }
    return true;
  }
  // Everything until the server closes the connection.
  std::string read_all() {
    EXPECT_TRUE(wait_until([this] { return ended_; }));
    return std::exchange(received_, {});
  }

  // A masked text frame, as a browser sends it.
  static std::string frame(std::string_view text, char opcode = 1) {
    std::string bytes{static_cast<char>(0x80 | opcode)};
    const std::size_t size = text.size();
    if (size < 126) {
      bytes += static_cast<char>(0x80 | size);
    } else {
      bytes += static_cast<char>(0x80 | 127);
      for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(size >> shift & 0xFF);
    }
    const std::string mask = "\x12\x34\x56\x78";
    bytes += mask;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(text[i] ^ mask[i % 4]);
    return bytes;
  }

  // The text of the next frame from the server; none when it closes the connection.
  std::optional<std::string> next_message() {
    std::optional<std::string> message;
    EXPECT_TRUE(wait_until([&] { return ended_ || (message = take_frame()).has_value(); }));
    return message;
  }

  // The headers of the answer, up to the empty line.
  std::string read_head() {
    EXPECT_TRUE(wait_until([this] { return ended_ || received_.find("\r\n\r\n") != std::string::npos; }));
    const std::size_t end = received_.find("\r\n\r\n");
    if (end == std::string::npos) return {};
    std::string head = received_.substr(0, end);
    received_.erase(0, end + 4);
    return head;
  }

 private:
  void receive() {
    std::array<char, 4096> part{};
    for (;;) {
      const ssize_t count = socket_ ? ::recv(socket_.get(), part.data(), part.size(), 0) : 0;
      if (count > 0) received_.append(part.data(), static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno == ECONNRESET)) ended_ = true;
      if (count <= 0) return;
    }
  }

  std::optional<std::string> take_frame() {
    const auto byte = [this](std::size_t i) { return static_cast<std::uint8_t>(received_[i]); };
    if (received_.size() < 2) return std::nullopt;
    std::size_t size = byte(1), begin = 2;
    if (size == 126) {
      if (received_.size() < 4) return std::nullopt;
      size = byte(2) * 256u + byte(3);
      begin = 4;
    }
    if (received_.size() < begin + size) return std::nullopt;
    std::string text = received_.substr(begin, size);
    const bool closes = (byte(0) & 0x0F) == 8;
    received_.erase(0, begin + size);
    return closes ? "close " + text.substr(2) : text;
  }

  WebServer& server_;
  FileDescriptor socket_;
  std::string received_;
  bool ended_ = false;
};

}  // namespace armature::cosim::test
