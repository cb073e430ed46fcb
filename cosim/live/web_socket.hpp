// The WebSocket of one page. Only web_server.cpp and web_socket.cpp include Boost.Beast.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace armature::cosim {

class WebSocket : public std::enable_shared_from_this<WebSocket> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;
  struct Events {
    std::function<void()> opened{};
    std::function<void(std::string_view)> message{};
    std::function<void()> closed{};  // once, also when it was never opened
  };

  explicit WebSocket(boost::beast::tcp_stream&& stream) : stream_{std::move(stream)} {}

  // Before accept(). The events may use this object.
  void listen(Events events) { events_ = std::move(events); }
  void accept(const Request& request);
  // Queued; a page that lets too many wait is disconnected.
  void send(std::string message);
  // Sent if nothing waits.
  void offer(std::string_view message);
  // Sends `message`, then closes with `reason`.
  void refuse(std::string message, std::string_view reason);
  // At once.
  void disconnect();

 private:
  void read();
  void on_read(boost::beast::error_code error);
  void write();
  void on_written(boost::beast::error_code error);
  void end();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  Events events_;
  boost::beast::flat_buffer received_;
  std::deque<std::string> to_send_;  // the first one is being sent
  bool open_ = false;
  bool ended_ = false;
  std::string close_with_;  // after to_send_; empty: stays open
};

}  // namespace armature::cosim
