#include "cosim/live/web_socket.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <utility>

#include "cosim/live/web_server.hpp"

namespace armature::cosim {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

void WebSocket::accept(const Request& request) {
  beast::get_lowest_layer(stream_).expires_never();
  stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  stream_.read_message_max(WebServer::kMaxMessage);
  stream_.auto_fragment(false);
  stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error || self->ended_) return self->end();
    self->open_ = true;
    if (self->events_.opened) self->events_.opened();
    self->read();
  });
}

void WebSocket::read() {
  stream_.async_read(received_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) { self->on_read(error); });
}

void WebSocket::on_read(beast::error_code error) {
  if (error || ended_) return end();
  const std::string text = beast::buffers_to_string(received_.data());
  received_.consume(received_.size());
  if (close_with_.empty() && events_.message) events_.message(text);
  if (!ended_) read();
}

void WebSocket::send(std::string message) {
  if (!open_ || ended_) return;
  if (to_send_.size() >= WebServer::kMaxWaiting) return disconnect();
  to_send_.push_back(std::move(message));
  if (to_send_.size() == 1) write();
}

void WebSocket::offer(std::string_view message) {
  if (to_send_.empty() && close_with_.empty()) send(std::string{message});
}

void WebSocket::refuse(std::string message, std::string_view reason) {
  close_with_ = reason;
  send(std::move(message));
}

void WebSocket::write() {
  stream_.text(true);
  stream_.async_write(boost::asio::buffer(to_send_.front()),
                      [self = shared_from_this()](beast::error_code error, std::size_t) { self->on_written(error); });
}

void WebSocket::on_written(beast::error_code error) {
  if (error || ended_) return end();
  to_send_.pop_front();
  if (!to_send_.empty()) return write();
  if (close_with_.empty()) return;
  stream_.async_close({websocket::close_code::policy_error, close_with_},
                      [self = shared_from_this()](beast::error_code) { self->end(); });
}

void WebSocket::disconnect() {
  beast::get_lowest_layer(stream_).close();
  end();
}

void WebSocket::end() {
  open_ = false;
  if (std::exchange(ended_, true)) return;
  if (const auto closed = std::exchange(events_.closed, nullptr)) closed();
}

}  // namespace armature::cosim
