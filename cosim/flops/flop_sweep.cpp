#include "cosim/flops/flop_sweep.hpp"

#include <unistd.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <memory>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/campaign/judge.hpp"
#include "cosim/campaign/judge_limits.hpp"
#include "cosim/run/run.hpp"
#include "cosim/snapshot/copied_process.hpp"
#include "cosim/snapshot/message_channel.hpp"
#include "cosim/snapshot/text_message.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kSweepSlice{200 * armature::kTickCycles.value()};

// The states of a run at the triggers. Two runs with equal states at a tick go on equally.
class States : public RunListener {
 public:
  explicit States(Run& run) : run_{run} {}

  void on_row(const TraceRow& row, const IntegerDigest&) override {
    constexpr std::uint64_t kOddFactor = 0x9E37'79B9'7F4A'7C15;
    rows_ = (rows_ ^ tick_hash(row)) * kOddFactor;
    ++count_;
    on_tick(Cycles{row.cycle});
  }

 protected:
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::uint64_t state() const { return rows_ ^ run_.logic_digest(); }

 private:
  virtual void on_tick(Cycles at) = 0;

  Run& run_;
  std::uint64_t rows_ = 0;
  std::size_t count_ = 0;
};

class KeptStates final : public States {
 public:
  using States::States;
  std::vector<std::uint64_t> states;

 private:
  void on_tick(Cycles) override { states.push_back(state()); }
};

// Compares them with those of the run without a flip, after a flip.
class ComparedStates final : public States {
 public:
  ComparedStates(Run& run, const std::vector<std::uint64_t>& unflipped) : States{run}, unflipped_{unflipped} {}

  void flipped(Cycles at) { flipped_at_ = at; }
  [[nodiscard]] bool equal() const { return equal_; }

 private:
  void on_tick(Cycles at) override {
    if (!flipped_at_ || at <= *flipped_at_ || equal_ || count() > unflipped_.size()) return;
    equal_ = state() == unflipped_[count() - 1];
  }

  const std::vector<std::uint64_t>& unflipped_;
  std::optional<Cycles> flipped_at_;
  bool equal_ = false;
};

// A verdict on its way from a copy. The reason follows as a text.
struct VerdictMessage {
  Outcome outcome = Outcome::kFailed;
  std::int64_t latency_ticks = -1;  // negative: none
};

bool send(MessageChannel& channel, const Verdict& verdict) {
  const VerdictMessage message{.outcome = verdict.outcome, .latency_ticks = verdict.latency_ticks.value_or(-1)};
  return channel.send(message) && send_text(channel, verdict.reason);
}

Verdict receive(MessageChannel& channel) {
  const auto message = channel.receive<VerdictMessage>();
  auto reason = message ? receive_text(channel) : std::nullopt;
  if (!reason) return {.outcome = Outcome::kFailed, .reason = "the program has crashed"};
  Verdict verdict{.outcome = message->outcome, .reason = std::move(*reason)};
  if (message->latency_ticks >= 0) verdict.latency_ticks = message->latency_ticks;
  return verdict;
}

// A run with its judge, up to an instant.
class RunToInstant {
 public:
  RunToInstant(const Scenario& scenario, const UnflippedRun& unflipped)
      : limits_{judge_limits(scenario.robot)},
        judge_{limits_, unflipped.path, Cycles{}},
        run_{scenario},
        states_{run_, unflipped.states},
        may_end_early_{!scenario.serial} {
    run_.add(judge_);
    run_.add(states_);
  }

  [[nodiscard]] bool advance(Cycles until, const std::function<bool()>& stop) {
    while (run_.now() < until) {
      if (stop() || !run_.advance(std::min(run_.now() + kSweepSlice, until))) return false;
    }
    return true;
  }

  [[nodiscard]] Verdict judge_flip(const FlopFlipAt& flip) {
    constexpr Cycles kSoon{2 * armature::kTickCycles.value()};
    const FaultKind kind = FlopFlip{.flop = flip.flop, .bit = flip.bit};
    run_.add_action(FaultSpec{.at_s = to_seconds(run_.now()), .kind = kind});
    states_.flipped(run_.now());
    const auto is_over = [&] { return may_end_early_ && states_.equal(); };
    // Most flips are over soon.
    for (Cycles slice = kSoon; run_.advance(run_.now() + slice) && !judge_.may_end();
         slice = std::min(slice + slice, kSweepSlice)) {
      if (is_over()) return {.outcome = Outcome::kMasked};
    }
    if (is_over()) return {.outcome = Outcome::kMasked};
    return judge_.verdict(run_.finish().failure);
  }

 private:
  JudgeLimits limits_;
  CampaignJudge judge_;
  Run run_;
  ComparedStates states_;
  bool may_end_early_;  // the far end of a serial line may have seen what the states do not show any more
};

struct Copy {
  pid_t process = 0;
  MessageChannel channel;
};

Copy copy_with_flip(RunToInstant& run, const FlopFlipAt& flip) {
  auto [mine, other] = MessageChannel::pair();
  const pid_t process = copy_this_process(other.descriptor());
  if (process == 0) {
    Verdict verdict;
    try {
      verdict = run.judge_flip(flip);
    } catch (const std::exception& error) {
      verdict = {.outcome = Outcome::kFailed, .reason = error.what()};
    }
    ::_exit(send(other, verdict) ? 0 : 1);
  }
  return {process, std::move(mine)};
}

// The flips of an instant, some of them at the same time.
bool flip_all(RunToInstant& run, const FlopSweep& sweep, std::size_t begin, std::size_t end,
              std::vector<FlopResult>& results) {
  std::deque<Copy> copies;
  const auto take_result = [&] {
    Copy copy = std::move(copies.front());
    copies.pop_front();
    const Verdict verdict = receive(copy.channel);
    wait_for_end(copy.process);
    results.push_back({sweep.flips[results.size()], verdict});
    if (sweep.progress) sweep.progress(results.size());
  };
  for (std::size_t i = begin; i < end && !sweep.stop(); ++i) {
    if (copies.size() == static_cast<std::size_t>(sweep.jobs)) take_result();
    copies.push_back(copy_with_flip(run, sweep.flips[i]));
  }
  while (!copies.empty()) take_result();
  return results.size() == end;
}

}  // namespace

std::vector<Flop> flops_of(const Scenario& scenario) {
  Run run{scenario};
  return run.flops();
}

std::optional<UnflippedRun> run_unflipped(const Scenario& scenario, const std::function<bool()>& stop) {
  const JudgeLimits limits = judge_limits(scenario.robot);
  const TruePath nothing;
  CampaignJudge judge{limits, nothing, Cycles{}};
  TruePathRecorder recorder;
  Run run{scenario};
  KeptStates states{run};
  run.add(recorder);
  run.add(judge);
  run.add(states);
  while (run.advance(run.now() + kSweepSlice)) {
    if (stop()) return std::nullopt;
  }
  const RunSummary summary = run.finish();
  return UnflippedRun{
      .path = recorder.path(), .states = std::move(states.states), .verdict = judge.verdict(summary.failure)};
}

std::vector<FlopResult> sweep_flops(const Scenario& scenario, const UnflippedRun& unflipped, const FlopSweep& sweep) {
  std::vector<FlopResult> results;
  const auto run = std::make_unique<RunToInstant>(scenario, unflipped);
  for (std::size_t begin = 0; begin < sweep.flips.size();) {
    const Cycles at = sweep.flips[begin].at;
    std::size_t end = begin;
    while (end < sweep.flips.size() && sweep.flips[end].at == at) ++end;
    if (!run->advance(at, sweep.stop)) break;
    if (!flip_all(*run, sweep, begin, end, results)) break;
    begin = end;
  }
  return results;
}

}  // namespace armature::cosim
