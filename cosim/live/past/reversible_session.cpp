#include "cosim/live/past/reversible_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/live/live_page.hpp"
#include "cosim/live/live_state.hpp"
#include "cosim/live/page_message.hpp"
#include "cosim/live/past/session_process.hpp"
#include "cosim/snapshot/copied_process.hpp"
#include "cosim/snapshot/text_message.hpp"
#include "cosim/text/json.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using Kind = SessionRequest::Kind;

constexpr std::string_view kBeat = R"({"do":"beat"})";

// They change nothing, so that nothing has to be repeated.
bool is_question(const PageMessage& message) {
  return message.what() == "forward" || message.what() == "inverse";
}

}  // namespace

ReversibleSession::ReversibleSession(const Scenario& scenario, const SessionFiles& files,
                                     std::function<Clock::time_point()> clock)
    : scenario_{scenario}, clock_{std::move(clock)}, serial_{files.serial}, log_{files.log} {
  auto [ours, of_session] = MessageChannel::pair();
  process_ = copy_this_process(of_session.descriptor());
  if (process_ == 0) serve_session(scenario, of_session);
  channel_ = std::move(ours);
  of_session.close();
}

ReversibleSession::~ReversibleSession() {
  channel_.close();
  wait_for_end(process_);
}

std::string ReversibleSession::ask(const SessionRequest& request, std::string_view text) {
  const auto received = []<class T>(std::optional<T> value) {
    if (!value) throw std::runtime_error{"the process of the session has ended"};
    return *std::move(value);
  };
  bool sent = channel_.send(request);
  if (request.kind == Kind::kTell || request.kind == Kind::kAsk) sent = sent && send_text(channel_, text);
  const auto answer = received(sent ? channel_.receive<SessionAnswer>() : std::nullopt);
  if (answer.error[0] != '\0') throw std::runtime_error{answer.error.data()};
  std::string answered = received(receive_text(channel_));
  serial_.write(answer.written[0], received(receive_text(channel_)));
  log_.write(answer.written[1], received(receive_text(channel_)));
  now_ = answer.now;
  next_ = static_cast<std::size_t>(answer.told);
  over_ = answer.over;
  return answered;
}

bool ReversibleSession::advance(Cycles until) {
  if (way_) follow_way();
  if (looking_) return true;
  if (has_operator() && clock_() - last_message_ > kPatience) leave();
  ask({.kind = Kind::kAdvance, .to = until});
  end_ = now_;
  constexpr Cycles kWriteThrough{kClkFreqHz / 10};  // 0.1 s, as Run
  if (now_ >= written_ + kWriteThrough) {
    serial_.write_through();
    log_.write_through();
    written_ = now_;
  }
  return !over_;
}

std::string ReversibleSession::state(double factor) {
  const Json bar = {
      {"end_s", to_seconds(end_)}, {"looking", looking_}, {"on_the_way", way_.has_value()}, {"jumps", jumps_}};
  const std::string state = ask({.kind = Kind::kState, .factor = factor});
  return fmt::format("{{\"bar\":{},{}", bar.dump(), std::string_view{state}.substr(1));
}

SessionResult ReversibleSession::finish() {
  const Json result = Json::parse(ask({.kind = Kind::kFinish}));
  serial_.write_through();
  log_.write_through();
  return {.cycles = Cycles{result["cycles"].get<std::int64_t>()},
          .ticks = result["ticks"].get<std::int64_t>(),
          .sha256 = result["sha256"].get<std::string>(),
          .failure = result["failure"].get<std::string>(),
          .interrupted = result["interrupted"].get<bool>(),
          .overrides = result["overrides"].get<std::vector<std::string>>()};
}

std::string ReversibleSession::page() {
  return live_page(scenario_.name);
}

std::string ReversibleSession::on_opened() {
  return compact_text({{"hello", live_scenario(scenario_)}});
}

void ReversibleSession::on_closed() {
  if (!looking_) leave();
}

std::string ReversibleSession::on_message(std::string_view text) try {
  last_message_ = clock_();
  return act(text);
} catch (const MessageError& error) {
  return compact_text({{"error", error.what()}});
}

std::string ReversibleSession::act(std::string_view text) {
  const PageMessage message{text};
  if (message.what() == "look") return look(message.number("t_s", 0, to_seconds(end_))), std::string{};
  if (message.what() == "live") return go_live(), std::string{};
  if (is_question(message)) return ask({.kind = Kind::kAsk}, text);
  if (message.what() == "beat" && (looking_ || has_operator())) return {};
  if (message.what() == "release" && looking_) return {};
  if (looking_) throw MessageError{"the past is shown: go on from here, or from the end, first"};
  return tell(std::string{text});
}

std::string ReversibleSession::tell(std::string message) {
  told_.resize(next_);
  told_.push_back({.at = now_, .message = std::move(message)});
  return repeat(told_.back());
}

std::string ReversibleSession::repeat(const Told& told) {
  return ask({.kind = told.message.empty() ? Kind::kLeave : Kind::kTell}, told.message);
}

void ReversibleSession::leave() {
  tell({});
}

void ReversibleSession::look(double t_s) {
  looking_ = true;
  then_live_ = false;
  ++jumps_;
  way_ = std::min(to_cycles(t_s), end_);
  if (*way_ < now_) ask({.kind = Kind::kGoBack, .to = *way_});
}

void ReversibleSession::go_live() {
  if (!looking_) return;
  then_live_ = way_.has_value();
  if (then_live_) return;
  looking_ = false;
  ++jumps_;
  told_.resize(next_);
  end_ = now_;
  if (!has_operator()) tell(std::string{kBeat});
}

// All that was told at the end itself belongs to it.
void ReversibleSession::follow_way() {
  constexpr Cycles kPart{kClkFreqHz / 25};  // 40 ms: the page is served between two parts
  const Cycles to = std::min(now_ + kPart, *way_);
  const bool to_the_end = to == end_;
  const auto advance_to = [this](Cycles cycle) {
    if (cycle > now_) ask({.kind = Kind::kAdvance, .to = cycle, .on_the_way = true});
  };
  while (next_ < told_.size() && (told_[next_].at < to || to_the_end)) {
    advance_to(told_[next_].at);
    repeat(told_[next_]);
  }
  advance_to(to);
  if (to != *way_) return;
  way_.reset();
  if (then_live_) go_live();
}

}  // namespace armature::cosim
