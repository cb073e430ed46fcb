#include "cosim/flips/flip_sweep.hpp"

#include <unistd.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/campaign/judge/judge.hpp"
#include "cosim/campaign/judge/judge_limits.hpp"
#include "cosim/run/run.hpp"
#include "cosim/snapshot/copied_process.hpp"
#include "cosim/snapshot/message_channel.hpp"
#include "cosim/snapshot/text_message.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/time/mixed.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kSweepSlice{200 * armature::kTickCycles.value()};

// A digest of a state takes as long as some ticks where it includes the memory of cores.
constexpr std::size_t kMemoryTicks = 64;

// The states of a run at the triggers. Two runs with equal states at a tick go on equally.
class States : public RunListener {
 public:
  explicit States(Run& run) : run_{run}, cores_have_memory_{!run.core_memory().parts.empty()} {}

  void on_row(const TraceRow& row, const IntegerDigest&) override {
    rows_ = mixed(rows_, tick_hash(row));
    ++count_;
    on_tick(Cycles{row.cycle});
  }

 protected:
  [[nodiscard]] std::size_t count() const { return count_; }
  // None: not compared at this tick.
  [[nodiscard]] std::optional<std::uint64_t> state() const {
    const std::uint64_t logic = rows_ ^ run_.logic_digest();
    if (!cores_have_memory_) return logic;
    if (count_ % kMemoryTicks != 0) return std::nullopt;
    const std::optional<std::uint64_t> cores = run_.core_digest();
    return cores ? std::optional{mixed(logic, *cores)} : std::nullopt;
  }

 private:
  virtual void on_tick(Cycles at) = 0;

  Run& run_;
  bool cores_have_memory_;
  std::uint64_t rows_ = 0;
  std::size_t count_ = 0;
};

class KeptStates final : public States {
 public:
  using States::States;
  std::vector<std::optional<std::uint64_t>> states;

 private:
  void on_tick(Cycles) override { states.push_back(state()); }
};

struct StateAt {
  Cycles at{};
  std::uint64_t state = 0;
  friend bool operator==(const StateAt&, const StateAt&) = default;
};

// What is known of a flip after its run.
struct FlipEnd {
  Verdict verdict{};
  std::optional<Cycles> detected{};
  std::optional<StateAt> first{};  // at the first trigger after the flip at which states are compared
};

// Compares the states after a flip with those of the run without it, and with that of the same flip at a later instant.
class FlippedStates final : public States {
 public:
  FlippedStates(Run& run, const std::vector<std::optional<std::uint64_t>>& unflipped)
      : States{run}, unflipped_{unflipped} {}

  // The run goes on as this one.
  enum class Same : std::uint8_t { kUnflipped, kLater };

  void flipped(Cycles at, const FlipEnd* later) {
    flipped_at_ = at;
    later_ = later;
  }
  [[nodiscard]] const std::optional<StateAt>& first() const { return first_; }
  [[nodiscard]] const std::optional<Same>& same() const { return same_; }

 private:
  void on_tick(Cycles at) override {
    if (!flipped_at_ || at <= *flipped_at_ || same_) return;
    const std::optional<std::uint64_t> known = state();
    if (!known) return;
    const StateAt now{at, *known};
    if (!first_) first_ = now;
    if (count() <= unflipped_.size() && known == unflipped_[count() - 1]) {
      same_ = Same::kUnflipped;
    } else if (later_ != nullptr && later_->first == now) {
      same_ = Same::kLater;
    }
  }

  const std::vector<std::optional<std::uint64_t>>& unflipped_;
  std::optional<Cycles> flipped_at_;
  const FlipEnd* later_ = nullptr;
  std::optional<StateAt> first_;
  std::optional<Same> same_;
};

// The end of a run on its way from a copy. The reason of the verdict follows as a text.
struct EndMessage {
  Outcome outcome = Outcome::kFailed;
  std::int64_t detected = -1;  // negative: not
  std::int64_t first_at = -1;  // negative: not reached
  std::uint64_t first_state = 0;
};

bool send_end(MessageChannel& channel, const FlipEnd& end) {
  EndMessage message{.outcome = end.verdict.outcome};
  if (end.detected) message.detected = end.detected->value();
  if (end.first) {
    message.first_at = end.first->at.value();
    message.first_state = end.first->state;
  }
  return channel.send(message) && send_text(channel, end.verdict.reason);
}

FlipEnd receive_end(MessageChannel& channel, Cycles flipped_at) {
  const auto message = channel.receive<EndMessage>();
  auto reason = message ? receive_text(channel) : std::nullopt;
  if (!reason) return {.verdict = {.outcome = Outcome::kFailed, .reason = "the program has crashed"}};
  FlipEnd end{.verdict = {.outcome = message->outcome, .reason = std::move(*reason)}};
  if (message->detected >= 0) {
    end.detected = Cycles{message->detected};
    end.verdict.latency_ticks = ticks_between(flipped_at, *end.detected);
  }
  if (message->first_at >= 0) end.first = StateAt{Cycles{message->first_at}, message->first_state};
  return end;
}

// A run with its judge, up to an instant.
class RunToInstant {
 public:
  RunToInstant(const Scenario& scenario, const UnflippedRun& unflipped)
      : limits_{judge_limits(scenario.robot)},
        judge_{limits_, unflipped.path, Cycles{}},
        run_{scenario},
        states_{run_, unflipped.states} {
    run_.add(judge_);
    run_.add(states_);
    (void)run_.flops();  // the run looks for them once, and each copy has the list
  }

  [[nodiscard]] bool advance(Cycles until, const std::function<bool()>& stop) {
    while (run_.now() < until) {
      if (stop() || !run_.advance(std::min(run_.now() + kSweepSlice, until))) return false;
    }
    return true;
  }

  // `later`: of the same flip at the next instant; null: there is none.
  [[nodiscard]] FlipEnd judge_flip(const Flip& flip, const FlipEnd* later) {
    constexpr Cycles kSoon{2 * armature::kTickCycles.value()};
    run_.add_action(FaultSpec{.at_s = to_seconds(run_.now()), .kind = fault_of(flip)});
    states_.flipped(run_.now(), later);
    // Most flips are over soon.
    for (Cycles slice = kSoon; !states_.same() && run_.advance(run_.now() + slice) && !judge_.may_end();
         slice = std::min(slice + slice, kSweepSlice)) {
    }
    if (states_.same() == FlippedStates::Same::kUnflipped) {
      return {.verdict = {.outcome = Outcome::kMasked}, .first = states_.first()};
    }
    if (states_.same() == FlippedStates::Same::kLater) {
      return {.verdict = later->verdict, .detected = later->detected, .first = states_.first()};
    }
    return {.verdict = judge_.verdict(run_.finish().failure), .detected = judge_.detected(), .first = states_.first()};
  }

 private:
  JudgeLimits limits_;
  CampaignJudge judge_;
  Run run_;
  FlippedStates states_;
};

struct Copy {
  pid_t process = 0;
  MessageChannel channel;
};

Copy copy_with_flip(RunToInstant& run, const Flip& flip, const FlipEnd* later) {
  auto [mine, other] = MessageChannel::pair();
  const pid_t process = copy_this_process(other.descriptor());
  if (process == 0) {
    FlipEnd end;
    try {
      end = run.judge_flip(flip, later);
    } catch (const std::exception& error) {
      end.verdict = {.outcome = Outcome::kFailed, .reason = error.what()};
    }
    ::_exit(send_end(other, end) ? 0 : 1);
  }
  return {process, std::move(mine)};
}

// The flips of an instant, some of them at the same time. `later`: those of the next one, of each bit or of none.
std::vector<FlipEnd> flip_all(RunToInstant& run, const FlipSweep& sweep, Cycles at, const std::vector<FlipEnd>& later,
                              const std::function<void()>& on_end) {
  std::vector<FlipEnd> ends;
  std::deque<Copy> copies;
  const auto take_end = [&] {
    Copy copy = std::move(copies.front());
    copies.pop_front();
    ends.push_back(receive_end(copy.channel, at));
    wait_for_end(copy.process);
    on_end();
  };
  for (std::size_t i = 0; i < sweep.flips.size() && !sweep.stop(); ++i) {
    if (copies.size() == static_cast<std::size_t>(sweep.jobs)) take_end();
    copies.push_back(copy_with_flip(run, sweep.flips[i], later.empty() ? nullptr : &later[i]));
  }
  while (!copies.empty()) take_end();
  return ends;
}

}  // namespace

std::vector<Flop> flops_of(const Scenario& scenario) {
  Run run{scenario};
  return run.flops();
}

CoreMemory memory_of(const Scenario& scenario) {
  return Run{scenario}.core_memory();
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

std::vector<FlipResult> sweep_flips(const Scenario& scenario, const UnflippedRun& unflipped, const FlipSweep& sweep) {
  std::vector<std::vector<FlipEnd>> ends(sweep.instants.size());
  std::size_t done = 0;
  const auto on_end = [&] {
    ++done;
    if (sweep.progress) sweep.progress(done);
  };
  const std::vector<FlipEnd> none;
  for (std::size_t i = ends.size(); i-- > 0;) {
    RunToInstant run{scenario, unflipped};
    if (!run.advance(sweep.instants[i], sweep.stop)) break;
    ends[i] = flip_all(run, sweep, sweep.instants[i], i + 1 < ends.size() ? ends[i + 1] : none, on_end);
    if (ends[i].size() < sweep.flips.size()) break;
  }
  std::vector<FlipResult> results;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t flip = 0; flip < ends[i].size(); ++flip) {
      results.push_back({sweep.flips[flip], sweep.instants[i], std::move(ends[i][flip].verdict)});
    }
  }
  return results;
}

}  // namespace armature::cosim
