// Serves one page and its WebSocket on 127.0.0.1, in the thread of its caller.
//
// Nothing happens outside of handle(): it accepts connections, answers requests and delivers messages. Who may connect
// is decided by cosim/net/web_admission.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "cosim/net/listener.hpp"

namespace armature::cosim {

// What the page is and does.
class WebApplication {
 public:
  virtual ~WebApplication() = default;
  // The HTML of the page.
  [[nodiscard]] virtual std::string page() = 0;
  // The one page has opened its WebSocket. Returns its first message.
  [[nodiscard]] virtual std::string on_opened() = 0;
  // It has closed the socket, or the connection is lost.
  virtual void on_closed() = 0;
  // A text message. Returns the answer; empty: none.
  [[nodiscard]] virtual std::string on_message(std::string_view text) = 0;
};

class WebServer {
 public:
  // A page must be able to send a program: 262144 characters, some of them written as two.
  static constexpr std::size_t kMaxMessage = 1 << 20;
  static constexpr std::size_t kMaxConnections = 32;  // further ones are closed at once
  static constexpr std::size_t kMaxWaiting = 64;      // answers to a page that does not read; then it is disconnected

  // `listener` listens on a port. The references must outlive the server. Throws std::system_error.
  WebServer(const Listener& listener, WebApplication& application);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  // Handles what comes during this time; 0: what has come. Throws what the application throws.
  void handle(std::chrono::steady_clock::duration time);
  // Sends a message to the page. It is dropped when the page has not taken the one before: a slow page gets fewer.
  void offer(std::string_view message);
  [[nodiscard]] bool has_page() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace armature::cosim
