#include "cosim/rewind/reversible_run.hpp"

#include <stdexcept>
#include <utility>

#include "cosim/rewind/run_server.hpp"
#include "cosim/snapshot/copied_process.hpp"
#include "cosim/snapshot/text_message.hpp"
#include "cosim/time/never.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kProcessEnded = "the process of the run has ended";

}  // namespace

ReversibleRun::ReversibleRun(const Scenario& scenario, const std::vector<StopCondition*>& conditions,
                             KeepTrace keep_trace) {
  auto [ours, of_run] = MessageChannel::pair();
  process_ = copy_this_process(of_run.descriptor());
  if (process_ == 0) serve_run(scenario, conditions, keep_trace, of_run);
  channel_ = std::move(ours);
  of_run.close();
  go_to(Cycles{0});
}

ReversibleRun::~ReversibleRun() {
  channel_.close();
  wait_for_end(process_);
}

const RunState& ReversibleRun::go_to(Cycles cycle) {
  return state_ = ask({.kind = RunRequest::Kind::kGoTo, .to = cycle}).state;
}

bool ReversibleRun::go_to_tick(std::int64_t tick) {
  return go_behind(ask({.kind = RunRequest::Kind::kFindTick, .to = kNever, .what = tick}));
}

bool ReversibleRun::advance_to(std::size_t condition, Cycles limit) {
  return go_behind(
      ask({.kind = RunRequest::Kind::kFindCondition, .to = limit, .what = static_cast<std::int64_t>(condition)}));
}

// The search stops some cycles behind what it finds.
bool ReversibleRun::go_behind(const RunAnswer& answer) {
  if (answer.found) {
    go_to(*answer.found + Cycles{1});
  } else {
    state_ = answer.state;
  }
  return answer.found.has_value();
}

ReversibleRun::Results ReversibleRun::finish() {
  state_ = ask({.kind = RunRequest::Kind::kFinish, .to = kNever}).state;
  Results results;
  results.summary = receive_text();
  results.trace = receive_text();
  return results;
}

std::string ReversibleRun::receive_text() {
  std::optional<std::string> text = armature::cosim::receive_text(channel_);
  if (!text) throw std::runtime_error{kProcessEnded};
  return *std::move(text);
}

RunAnswer ReversibleRun::ask(const RunRequest& request) {
  std::optional<RunAnswer> answer;
  if (channel_.send(request)) answer = channel_.receive<RunAnswer>();
  if (!answer) throw std::runtime_error{kProcessEnded};
  if (answer->error[0] != '\0') throw std::runtime_error{answer->error.data()};
  return *answer;
}

}  // namespace armature::cosim
