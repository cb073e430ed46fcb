#include "cosim/live/web_server.hpp"

#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cerrno>
#include <functional>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/live/web_socket.hpp"
#include "cosim/net/web_admission.hpp"

namespace armature::cosim {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = boost::asio::ip::tcp;
using Request = WebSocket::Request;
using Response = http::response<http::string_body>;

constexpr std::chrono::seconds kRequestTime{30};
constexpr std::uint32_t kMaxHeader = 16'384;
constexpr std::string_view kSocketPlace = "socket";

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

WebRequest web_request(const Request& request) {
  WebRequest result{.method = view(request.method_string()),
                    .target = view(request.target()),
                    .host = view(request[http::field::host]),
                    .opens_socket = beast::websocket::is_upgrade(request)};
  if (const auto origin = request.find(http::field::origin); origin != request.end()) {
    result.origin = view(origin->value());
  }
  return result;
}

Response response(unsigned status, std::string_view kind, std::string body) {
  Response made{static_cast<http::status>(status), 11};
  made.set(http::field::content_type, beast::string_view{kind.data(), kind.size()});
  made.set(http::field::cache_control, "no-store");
  // No other page may show this one in a frame and have its buttons pressed, nor learn its address.
  made.set(http::field::x_frame_options, "DENY");
  made.set("Content-Security-Policy", "frame-ancestors 'none'");
  made.set("Referrer-Policy", "no-referrer");
  made.set("X-Content-Type-Options", "nosniff");
  made.set("Cross-Origin-Resource-Policy", "same-origin");
  made.set("Cross-Origin-Opener-Policy", "same-origin");
  made.body() = std::move(body);
  made.keep_alive(false);
  made.prepare_payload();
  return made;
}

Response text_response(unsigned status, std::string_view why) {
  return response(status, "text/plain; charset=utf-8", std::string{why} + "\n");
}

// A connection until its one request is answered, or becomes a WebSocket.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  // Returns the answer; none: it has taken the stream for a WebSocket.
  using Handler = std::function<std::optional<Response>(const Request&, beast::tcp_stream&)>;

  Connection(Tcp::socket&& socket, std::shared_ptr<int> count, const Handler& handler)
      : stream_{std::move(socket)}, count_{std::move(count)}, handler_{handler} {
    ++*count_;
    parser_.header_limit(kMaxHeader);
    parser_.body_limit(0);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { --*count_; }

  void read() {
    stream_.expires_after(kRequestTime);
    http::async_read(stream_, received_, parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) { self->on_read(error); });
  }

 private:
  void on_read(beast::error_code error) {
    if (error) {
      // A client that has gone gets no answer.
      if (error.category() == http::make_error_code(http::error::end_of_stream).category() &&
          error != http::error::end_of_stream) {
        respond(text_response(400, "this is no request that is served here"));
      }
      return;
    }
    if (std::optional<Response> answer = handler_(parser_.get(), stream_)) respond(std::move(*answer));
  }

  void respond(Response&& answer) {
    answer_ = std::move(answer);
    http::async_write(stream_, answer_, [self = shared_from_this()](beast::error_code, std::size_t) {
      beast::error_code ignored;
      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  std::shared_ptr<int> count_;
  const Handler& handler_;
  beast::flat_buffer received_;
  http::request_parser<http::empty_body> parser_;
  Response answer_;
};

}  // namespace

class WebServer::Implementation {
 public:
  Implementation(const Listener& listener, WebApplication& application)
      : port_{listener.tcp_port().value()},
        token_{listener.token().value()},
        application_{application},
        acceptor_{context_} {
    const int own = ::dup(listener.socket().get());
    if (own < 0) throw std::system_error{errno, std::generic_category(), "cannot use the port"};
    acceptor_.assign(Tcp::v4(), own);
    accept();
  }

  ~Implementation() {
    if (page_) page_->disconnect();
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void handle(std::chrono::steady_clock::duration time) {
    context_.restart();
    if (time <= std::chrono::steady_clock::duration::zero()) {
      context_.poll();
    } else {
      context_.run_for(time);
    }
  }

  void offer(std::string_view message) {
    if (page_) page_->offer(message);
  }
  [[nodiscard]] bool has_page() const { return page_ != nullptr; }

 private:
  void accept() {
    acceptor_.async_accept([this](beast::error_code error, Tcp::socket socket) {
      if (!error && *connections_ < static_cast<int>(kMaxConnections)) {
        socket.set_option(Tcp::no_delay{true}, error);
        std::make_shared<Connection>(std::move(socket), connections_, handler_)->read();
      }
      accept();
    });
  }

  std::optional<Response> answer(const Request& request, beast::tcp_stream& stream) {
    const WebRequest asked = web_request(request);
    const WebAdmission admission = admit_web_request(asked, port_, token_);
    if (admission.status != 200) return text_response(admission.status, admission.why);
    if (admission.place == kSocketPlace && asked.opens_socket) {
      open_socket(request, std::move(stream));
      return std::nullopt;
    }
    if (!admission.place.empty()) return text_response(404, "there is nothing at this address");
    return response(200, "text/html; charset=utf-8", application_.page());
  }

  void open_socket(const Request& request, beast::tcp_stream&& stream) {
    const bool busy = page_ != nullptr;
    const auto socket = std::make_shared<WebSocket>(std::move(stream));
    socket->listen(busy ? refusing(*socket) : serving(*socket));
    if (!busy) page_ = socket;
    ++*connections_;
    socket->accept(request);
  }

  WebSocket::Events refusing(WebSocket& socket) {
    return {.opened = [&socket] { socket.refuse(R"({"busy":")" + std::string{kBusyPage} + "\"}", kBusyPage); },
            .closed = [count = connections_] { --*count; }};
  }

  WebSocket::Events serving(WebSocket& socket) {
    return {.opened = [this, &socket] { socket.send(application_.on_opened()); },
            .message =
                [this, &socket](std::string_view text) {
                  if (std::string answer = application_.on_message(text); !answer.empty()) {
                    socket.send(std::move(answer));
                  }
                },
            .closed =
                [this] {
                  --*connections_;
                  page_.reset();
                  application_.on_closed();
                }};
  }

  std::uint16_t port_;
  std::string token_;
  WebApplication& application_;
  Connection::Handler handler_{
      [this](const Request& request, beast::tcp_stream& stream) { return answer(request, stream); }};
  std::shared_ptr<int> connections_ = std::make_shared<int>(0);
  std::shared_ptr<WebSocket> page_;
  boost::asio::io_context context_{1};
  Tcp::acceptor acceptor_;
};

WebServer::WebServer(const Listener& listener, WebApplication& application)
    : implementation_{std::make_unique<Implementation>(listener, application)} {}
WebServer::~WebServer() = default;

void WebServer::handle(std::chrono::steady_clock::duration time) {
  implementation_->handle(time);
}
void WebServer::offer(std::string_view message) {
  implementation_->offer(message);
}
bool WebServer::has_page() const {
  return implementation_->has_page();
}

}  // namespace armature::cosim
