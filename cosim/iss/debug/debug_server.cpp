#include "cosim/iss/debug/debug_server.hpp"

#include <poll.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/iss/debug/protocol/packet.hpp"
#include "cosim/iss/debug/protocol/stub.hpp"
#include "cosim/net/client_channel.hpp"
#include "cosim/net/peer_closed.hpp"

namespace armature::cosim::iss {
namespace {

constexpr int kStopPollMs = 50;

class Server {
 public:
  Server(const LoopbackPort& port, RemoteRun& run, const Stop& first, const std::function<bool()>& stop)
      : port_{port}, run_{run}, stop_{stop}, stub_{run, first} {}

  DebugResult serve() {
    while (!stop_()) {
      wait();
      if (client_) take_bytes();
      if (stub_.end() == Stub::End::kKilled) {
        say_last();
        return {.end = DebugEnd::kKilled};
      }
      if (stub_.end() == Stub::End::kDetached && !detached_) detach();
      if (const std::optional<Stop> end = hear()) return {.stop = *end};
      if (client_) client_->send();
      if (has_gone()) lose_client();
    }
    return {.end = DebugEnd::kInterrupted};
  }

 private:
  // Until there is something to do. A run that stands says nothing, unless its process has ended.
  void wait() {
    std::array<pollfd, 3> polls{{{port_.socket.get(), POLLIN, 0}, {run_.descriptor(), POLLIN, 0}, {-1, POLLIN, 0}}};
    if (client_) polls[2].fd = client_->socket().get();
    if (client_ && !client_->answers().empty()) polls[2].events |= POLLOUT;
    // A gdb that connects while the run continues waits for its stop.
    if (!client_ && (stub_.runs() || detached_)) polls[0].fd = -1;
    if (::poll(polls.data(), polls.size(), kStopPollMs) < 0) {
      if (errno != EINTR) throw std::system_error{errno, std::generic_category(), "cannot wait for gdb"};
      return;
    }
    run_is_due_ = polls[1].revents != 0;
    if (polls[2].revents != 0) client_->receive();
    if (polls[0].revents != 0) accept();
  }

  [[nodiscard]] bool has_gone() const { return client_ && (client_->lost() || client_->ended()); }

  void accept() {
    // One that goes away makes room for the next one, which waits.
    if (has_gone() || (client_ && peer_closed(client_->socket()))) return;
    FileDescriptor socket = accept_client(port_.socket);
    if (!socket || client_) return;  // one at a time: the other one is closed
    client_.emplace(std::move(socket));
    reader_ = {};
    stub_.begin_session();
  }

  void take_bytes() {
    reader_.append(client_->take_rest());
    while (const std::optional<PacketReader::Item> item = reader_.next()) {
      switch (item->kind) {
        case PacketReader::Item::Kind::kInterrupt:
          stub_.interrupt();
          break;
        case PacketReader::Item::Kind::kBad:
          client_->answers() += '-';
          break;
        case PacketReader::Item::Kind::kForeign:  // such as a web page that sends a request to this port
          lose_client();
          return;
        case PacketReader::Item::Kind::kPacket:
          if (stub_.acknowledges()) client_->answers() += '+';
          if (const auto answer = stub_.answer(item->payload)) say(*answer);
          if (stub_.end() != Stub::End::kNone) return;
          break;
      }
    }
  }

  // What the run says, if it does. Returns its last stop.
  std::optional<Stop> hear() {
    if (!run_is_due_) return std::nullopt;
    const std::optional<Stop> stop = run_.hear();
    if (!stop) return std::nullopt;
    say(stub_.stopped(*stop));
    if (!stop->is_last()) return std::nullopt;
    say_last();
    return stop;
  }

  void say(std::string_view payload) {
    if (client_) client_->answers() += packet_of(payload);
  }

  // Sends the rest and closes the connection.
  void say_last() {
    constexpr auto kLongest = std::chrono::seconds{1};
    const auto end = std::chrono::steady_clock::now() + kLongest;
    while (client_ && !client_->answers().empty() && !client_->lost() && std::chrono::steady_clock::now() < end) {
      client_->send();
    }
    client_.reset();
  }

  void detach() {
    say_last();
    detached_ = true;
    run_.detach();
  }

  void lose_client() {
    client_.reset();
    stub_.interrupt();
  }

  const LoopbackPort& port_;
  RemoteRun& run_;
  const std::function<bool()>& stop_;
  Stub stub_;
  std::optional<ClientChannel> client_;
  PacketReader reader_;
  bool run_is_due_ = false;
  bool detached_ = false;
};

}  // namespace

DebugResult serve_debugger(const LoopbackPort& port, RemoteRun& run, const std::function<bool()>& stop) {
  std::optional<Stop> first;
  while (!first) first = run.hear();
  if (first->is_last()) return {.stop = *first};
  return Server{port, run, *first, stop}.serve();
}

}  // namespace armature::cosim::iss
