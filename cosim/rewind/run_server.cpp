#include "cosim/rewind/run_server.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "controller/base/timebase.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/rewind/run_digest.hpp"
#include "cosim/rewind/run_messages.hpp"
#include "cosim/rewind/trace_text.hpp"
#include "cosim/run/run.hpp"
#include "cosim/snapshot/point_pacing.hpp"
#include "cosim/snapshot/return_points.hpp"
#include "cosim/snapshot/text_message.hpp"

namespace armature::cosim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr PointPacing::Rules kPacing{
    .between = std::chrono::milliseconds{20}, .part_of_the_run = 50, .most = 128, .finest = kClkFreqHz / 1000};  // 1 ms

class RunServer final : private RunListener {
 public:
  RunServer(const Scenario& scenario, const std::vector<StopCondition*>& conditions, KeepTrace keep_trace,
            MessageChannel& channel)
      : conditions_{conditions}, channel_{channel}, points_{channel.descriptor()}, run_{scenario} {
    run_.add(digest_);
    if (keep_trace == KeepTrace::kYes) run_.add(trace_.emplace(scenario));
    run_.add(*this);
    for (StopCondition* condition : conditions) run_.add(*condition);
  }

  [[noreturn]] void serve() {
    went_back_ = points_.mark(run_.now().value());
    while (const std::optional<RunRequest> next = channel_.peek<RunRequest>()) {
      // The request stays in the channel for the process that can fulfil it.
      if (next->kind == RunRequest::Kind::kGoTo && next->to < run_.now()) points_.go_back(next->to.value());
      const RunRequest request = channel_.receive<RunRequest>().value();
      if (const std::optional<RunAnswer> answer = fulfil(request)) {
        channel_.send(*answer);
        if (request.kind == RunRequest::Kind::kFinish) {
          send_text(channel_, *summary_);
          send_text(channel_, trace_ ? std::string_view{trace_->text()} : std::string_view{});
        }
        went_back_ = false;
      }
    }
    ::_exit(EXIT_SUCCESS);
  }

 private:
  void on_row(const TraceRow& row, const IntegerDigest&) override { triggers_.push_back(Cycles{row.cycle}); }

  // Nothing: the process was taken back. Then the next request waits in the channel.
  std::optional<RunAnswer> fulfil(const RunRequest& request) {
    if (request.kind == RunRequest::Kind::kFindCondition) condition(request).begin();
    work_begins_ = Clock::now();
    pacing_.begin_way(gap(request));
    std::optional<Cycles> found;
    while (!(found = find(request)) && run_.now() < request.to) {
      const bool continues = run_.advance(std::min(run_.now() + armature::kTickCycles, request.to));
      count_work();
      if (!continues) break;
      if (point_is_due(request) && take_point(request)) return std::nullopt;
    }
    if (!found) found = find(request);
    if (request.kind == RunRequest::Kind::kFinish && !summary_) summary_ = summary_json(run_.finish());
    return RunAnswer{.state = digest_.state(run_.look()), .found = found};
  }

  [[nodiscard]] std::int64_t gap(const RunRequest& request) const { return (request.to - run_.now()).value(); }

  [[nodiscard]] std::optional<Cycles> find(const RunRequest& request) const {
    switch (request.kind) {
      case RunRequest::Kind::kGoTo:
      case RunRequest::Kind::kFinish:
        break;
      case RunRequest::Kind::kFindTick: {
        const auto tick = static_cast<std::size_t>(request.what);
        if (tick < triggers_.size()) return triggers_[tick];
        break;
      }
      case RunRequest::Kind::kFindCondition:
        return condition(request).met();
    }
    return std::nullopt;
  }

  [[nodiscard]] StopCondition& condition(const RunRequest& request) const {
    return *conditions_.at(static_cast<std::size_t>(request.what));
  }

  void count_work() {
    const Clock::time_point now = Clock::now();
    worked_ += now - work_begins_;
    work_begins_ = now;
  }

  [[nodiscard]] bool point_is_due(const RunRequest& request) const {
    const bool goes_back = went_back_ && request.kind == RunRequest::Kind::kGoTo;
    return pacing_.is_due(worked_, points_.count(), goes_back ? std::optional{gap(request)} : std::nullopt);
  }

  // Returns whether the process was taken back here.
  bool take_point(const RunRequest& request) {
    pacing_.begin_point(worked_, gap(request));
    const Clock::time_point begin = Clock::now();
    try {
      if (!points_.mark(run_.now().value())) {
        work_begins_ = Clock::now();
        pacing_.end_point(work_begins_ - begin);
        return false;
      }
    } catch (const std::runtime_error&) {
      pacing_.refused(points_.count());
      return false;
    }
    return went_back_ = true;
  }

  const std::vector<StopCondition*>& conditions_;
  MessageChannel& channel_;
  ReturnPoints points_;
  RunDigest digest_;
  std::optional<TraceText> trace_;
  std::vector<Cycles> triggers_;  // of each tick
  Run run_;
  std::optional<std::string> summary_;  // of the run, which has ended
  PointPacing pacing_{kPacing};
  Clock::duration worked_{};
  Clock::time_point work_begins_{};
  bool went_back_ = false;  // for the present request
};

}  // namespace

void serve_run(const Scenario& scenario, const std::vector<StopCondition*>& conditions, KeepTrace keep_trace,
               MessageChannel& channel) {
  try {
    RunServer{scenario, conditions, keep_trace, channel}.serve();
  } catch (const std::exception& error) {
    RunAnswer answer;
    const std::string_view text{error.what()};
    text.copy(answer.error.data(), answer.error.size() - 1);
    channel.send(answer);
    ::_exit(EXIT_FAILURE);
  }
}

}  // namespace armature::cosim
