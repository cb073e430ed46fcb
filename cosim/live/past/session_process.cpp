#include "cosim/live/past/session_process.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "controller/base/timebase.hpp"
#include "cosim/live/live_session.hpp"
#include "cosim/live/past/session_messages.hpp"
#include "cosim/live/past/session_record.hpp"
#include "cosim/snapshot/point_pacing.hpp"
#include "cosim/snapshot/return_points.hpp"
#include "cosim/snapshot/text_message.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = SessionRequest::Kind;

// A way back takes at most a twentieth of the time for which the simulation has worked. All points together are enough
// for an hour of such work, which is many hours of a session on the model.
constexpr PointPacing::Rules kPacing{.between = std::chrono::milliseconds{100},
                                     .part_of_the_run = 20,
                                     .most = 160,
                                     .more = 40,
                                     .finest = kClkFreqHz / 50};  // 20 ms

class SessionProcess {
 public:
  SessionProcess(const Scenario& scenario, MessageChannel& channel)
      : channel_{channel}, points_{channel.descriptor()}, session_{scenario}, record_{scenario, session_.run()} {}

  [[noreturn]] void serve() {
    static_cast<void>(points_.mark(session_.now().value()));
    while (const std::optional<SessionRequest> next = channel_.peek<SessionRequest>()) {
      // The request stays in the channel for the process that can fulfil it.
      if (next->kind == Kind::kGoBack && next->to < session_.now()) points_.go_back(next->to.value());
      const SessionRequest request = channel_.receive<SessionRequest>().value();
      if (const std::optional<std::string> text = fulfil(request)) answer(*text);
    }
    ::_exit(EXIT_SUCCESS);
  }

 private:
  // The text of the answer. Nothing: the process was taken back. Then the next request waits in the channel.
  std::optional<std::string> fulfil(const SessionRequest& request) {
    switch (request.kind) {
      case Kind::kAdvance:
        return advance(request) ? std::optional<std::string>{""} : std::nullopt;
      case Kind::kTell:
        ++told_;
        return session_.on_message(received_text());
      case Kind::kAsk:
        return session_.on_question(received_text());
      case Kind::kLeave:
        ++told_;
        session_.on_closed();
        return "";
      case Kind::kState:
        return session_.state(request.factor);
      case Kind::kGoBack:
        target_ = request.to;
        pacing_.begin_way(gap());
        return "";
      case Kind::kFinish:
        return finish();
    }
    return "";
  }

  // Returns whether it came there; not when the process was taken back.
  bool advance(const SessionRequest& request) {
    constexpr Cycles kStep{kClkFreqHz / 500};  // 2 ms
    while (!over_ && session_.now() < request.to) {
      const Clock::time_point begin = Clock::now();
      over_ = !session_.advance(std::min(session_.now() + kStep, request.to));
      worked_ += Clock::now() - begin;
      const auto way = request.on_the_way ? std::optional{gap()} : std::nullopt;
      if (!over_ && pacing_.is_due(worked_, points_.count(), way) && take_point()) return false;
    }
    return true;
  }

  // Returns whether the process was taken back here.
  bool take_point() {
    pacing_.begin_point(worked_, gap());
    const Clock::time_point begin = Clock::now();
    try {
      if (points_.mark(session_.now().value())) return true;
      pacing_.end_point(Clock::now() - begin);
    } catch (const std::runtime_error&) {
      pacing_.refused(points_.count());
    }
    return false;
  }

  [[nodiscard]] std::int64_t gap() const { return (target_ - session_.now()).value(); }

  std::string finish() {
    const RunSummary summary = session_.run().finish();
    over_ = true;
    return compact_text({{"cycles", summary.facts.cycles.value()},
                         {"ticks", summary.facts.ticks},
                         {"sha256", summary.facts.sha256},
                         {"failure", summary.failure.value_or("")},
                         {"interrupted", summary.interrupted},
                         {"overrides", session_.cell().overrides()}});
  }

  std::string received_text() {
    std::optional<std::string> text = receive_text(channel_);
    if (!text) ::_exit(EXIT_FAILURE);
    return *std::move(text);
  }

  void answer(std::string_view text) {
    channel_.send(SessionAnswer{.now = session_.now(), .over = over_, .told = told_, .written = record_.taken()});
    send_text(channel_, text);
    send_text(channel_, record_.take_serial());
    send_text(channel_, record_.take_log());
  }

  MessageChannel& channel_;
  ReturnPoints points_;
  LiveSession session_;
  SessionRecord record_;
  PointPacing pacing_{kPacing};
  Clock::duration worked_{};
  Cycles target_{};  // of the way
  std::int64_t told_ = 0;
  bool over_ = false;
};

}  // namespace

void serve_session(const Scenario& scenario, MessageChannel& channel) {
  try {
    SessionProcess{scenario, channel}.serve();
  } catch (const std::exception& error) {
    SessionAnswer answer;
    const std::string_view text{error.what()};
    text.copy(answer.error.data(), answer.error.size() - 1);
    channel.send(answer);
    ::_exit(EXIT_FAILURE);
  }
}

}  // namespace armature::cosim
