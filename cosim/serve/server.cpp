#include "cosim/serve/server.hpp"

#include <poll.h>

#include <array>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/net/client_channel.hpp"
#include "cosim/net/peer_closed.hpp"
#include "cosim/net/token.hpp"
#include "cosim/net/waiting_clients.hpp"

namespace armature::cosim {
namespace {

// A signal ends the wait. A signal between the check of the stop request and the wait is noticed this much later.
constexpr int kStopPollMs = 50;
constexpr std::size_t kMaxUnsent =
    kMaxInFlight * Interpreter::kMaxAnswer + kMaxBatchesInFlight * Interpreter::kMaxBatchAnswer;
// Answers are sent after this much simulated time, even when there are more lines. It takes some milliseconds of host
// time.
constexpr Cycles kBatch{50'000};

// The one client that is served.
class Session {
 public:
  Session(ClientChannel client, Listener& listener, WaitingClients& others, Interpreter& interpreter,
          const StopRequest& stop)
      : client_{std::move(client)},
        listener_{listener},
        others_{others},
        interpreter_{interpreter},
        stop_{stop},
        first_line_checked_{listener.token().has_value()} {
    client_.accept_lines_of(Interpreter::kMaxBatchLine);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void serve() {
    while (!client_.lost() && !gone_) {
      const bool all_answered = answer();
      client_.send();
      const bool sent = client_.answers().empty();
      if (stop_() || interpreter_.broken() || (client_.ended() && all_answered && sent)) break;
      const bool more_work = !all_answered && client_.answers().size() < kMaxUnsent;
      wait(more_work ? 0 : kStopPollMs, all_answered && !client_.ended(), !sent);
    }
  }

 private:
  // Answers the lines that have arrived. Returns false when more lines may be waiting.
  bool answer() {
    const Cycles end = interpreter_.now() + kBatch;
    std::string& answers = client_.answers();
    while (answers.size() < kMaxUnsent && interpreter_.now() < end && !interpreter_.broken() && !stop_() && !gone_) {
      const std::optional<LineBuffer::Line> line = client_.next_line();
      if (!line) return true;
      if (!std::exchange(first_line_checked_, true)) {
        const Admission admission = check_first_line(line->text, std::nullopt);
        answers += admission.answer;
        if (!admission.answer.empty()) continue;
      }
      if (line->too_long) {
        interpreter_.answer_to_long_line(answers);
      } else {
        interpreter_.answer(line->text, answers, stop_run_);
      }
    }
    return false;
  }

  // Waits until the client can be read or written as requested, or another one connects.
  void wait(int timeout_ms, bool read, bool write) {
    const auto events = static_cast<short>((read ? POLLIN : 0) | (write ? POLLOUT : 0));
    // The order matters: if a client closed before another one connected, the close is then detected.
    std::array<pollfd, 2> polls{{{listener_.socket().get(), POLLIN, 0}, {client_.socket().get(), events, 0}}};
    if (::poll(polls.data(), polls.size(), timeout_ms) < 0 && errno != EINTR) {
      throw std::system_error{errno, std::generic_category(), "cannot wait for a client"};
    }
    const bool was_open = !client_.ended();
    if (read && polls[1].revents != 0) client_.receive();
    const bool ends = was_open && client_.ended();
    if (polls[0].revents != 0 && !ends) others_.turn_away(client_.socket());
  }

  // Polled during a run. True when the run must end, because the server ends or the client has gone.
  bool stop_run() {
    if (stop_()) return true;
    std::array<pollfd, 2> polls{{{listener_.socket().get(), POLLIN, 0}, {client_.socket().get(), POLLRDHUP, 0}}};
    if (::poll(polls.data(), polls.size(), 0) <= 0) return false;
    gone_ = polls[0].revents != 0 ? others_.turn_away(client_.socket()) : peer_closed(client_.socket());
    return gone_;
  }

  ClientChannel client_;
  Listener& listener_;
  WaitingClients& others_;
  Interpreter& interpreter_;
  const StopRequest& stop_;
  const StopRequest stop_run_{[this] { return stop_run(); }};
  bool first_line_checked_;  // the first line was checked for a token
  bool gone_ = false;
};

}  // namespace

std::int64_t serve(Listener& listener, Interpreter& interpreter, const StopRequest& stop) {
  std::int64_t clients = 0;
  WaitingClients waiting{listener};
  while (!stop() && !interpreter.broken()) {
    std::optional<ClientChannel> client = waiting.next(kStopPollMs);
    if (!client) continue;
    ++clients;
    Session{std::move(*client), listener, waiting, interpreter, stop}.serve();
  }
  return clients;
}

}  // namespace armature::cosim
