#include "cosim/iss/debug/debugged_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/iss/arm_program.hpp"
#include "cosim/iss/debug/run_inspector.hpp"
#include "cosim/iss/debug/run_messages.hpp"
#include "cosim/iss/debug/stop_rules.hpp"
#include "cosim/iss/firmware.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/snapshot/point_pacing.hpp"
#include "cosim/snapshot/return_points.hpp"

namespace armature::cosim::iss {
namespace {

using Clock = std::chrono::steady_clock;

constexpr PointPacing::Rules kPacing{.between = std::chrono::milliseconds{50},
                                     .part_of_the_run = 60,
                                     .most = 256,
                                     .more = 32,
                                     .finest = 20'000};  // instructions

class DebuggedRun final : private CoreWatcher {
 public:
  DebuggedRun(const Scenario& scenario, const DebuggedRunOptions& options, MessageChannel& channel)
      : channel_{channel}, points_{channel.descriptor()} {
    CoreWatcher* const watcher = this;
    provide_a9([&, watcher](host_memory::HostMemory& memory, const CpuSpec& spec) -> std::unique_ptr<CoreProgram> {
      auto program = std::make_unique<ArmProgram>(firmware(), memory, spec.cpi, watcher);
      program_ = program.get();
      return program;
    });
    run_ = std::make_unique<Run>(scenario);
    inspector_.emplace(scenario, *run_, *program_, options.wave);
    if (options.compare_golden) run_->add(golden_.emplace(scenario, TraceFile{}));
  }

  [[noreturn]] void serve() {
    rules_.set({.how = Resume::How::kStep, .core = 0}, {});
    take_point();
    while (run_->advance(run_->now() + armature::kTickCycles)) {
      if (!goal_ && channel_.is_due()) take_interrupt();
      if (point_is_due()) take_point();
    }
    RunSummary summary = run_->finish();
    summary.host.wall_s = std::chrono::duration<double>(worked_ + (Clock::now() - since_)).count();
    end(summary_text(summary), {.why = Stop::Why::kEnded, .exit_code = summary.passed() ? kExitOk : kExitCheckFailed});
  }

  // Tells `text` and the last stop.
  [[noreturn]] void end(std::string_view text, const Stop& stop) {
    while (!text.empty()) {
      DebugAnswer part = text_answer(text);
      part.kind = DebugAnswer::Kind::kText;
      channel_.send(part);
      text.remove_prefix(part.size);
    }
    channel_.send(DebugAnswer{.kind = DebugAnswer::Kind::kStopped, .stop = stop});
    ::_exit(EXIT_SUCCESS);
  }

 private:
  void before_instruction(ArmCore& core, std::uint32_t address) noexcept override {
    const auto number = static_cast<std::size_t>(core.number());
    addresses_[number] = address;
    if (rules_.active() || pending_ || goal_ == position_) look(core, address);
    before_[number] = position_++;
  }

  void look(ArmCore& core, std::uint32_t address) noexcept {
    if (goal_ == position_) return reach_goal(core);
    if (searches_) {
      if (const auto stop = rules_.at_instruction(core.number(), address)) found_ = {*stop, position_};
      return;
    }
    std::optional<Stop> stop;
    if (pending_ && pending_->core == core.number()) {
      stop = pending_;
    } else if (rules_.active()) {
      stop = rules_.at_instruction(core.number(), address);
      // The engine begins again at the pc that gdb has set: nothing was executed.
      if (stop && stop->why == Stop::Why::kStep && position_ == jumped_to_) stop.reset();
    }
    if (stop) stand_at(core, *stop);
  }

  void on_data(ArmCore& core, const DataAccess& access) noexcept override {
    const std::optional<Stop> stop = rules_.at_data(core.number(), access);
    if (!stop) return;
    if (searches_) {
      found_ = {*stop, position_ - 1};
    } else if (!pending_) {
      pending_ = stop;
    }
  }

  void reach_goal(ArmCore& core) noexcept {
    goal_.reset();
    if (!std::exchange(searches_, false)) {
      Stop stop = goal_stop_;
      stop.core = core.number();
      return stand_at(core, stop);
    }
    DebugAnswer found{.kind = DebugAnswer::Kind::kFound, .done = found_.has_value(), .from = searched_from_};
    if (found_) found.stop = found_->stop, found.position = found_->position;
    stand(core, found);
  }

  void stand_at(ArmCore& core, const Stop& stop) noexcept { stand(core, stopped(stop)); }

  [[nodiscard]] DebugAnswer stopped(const Stop& stop) const {
    return {
        .kind = DebugAnswer::Kind::kStopped, .stop = stop, .position = position_, .from = position_, .before = before_};
  }

  // An exception must not pass through the engine.
  void stand(ArmCore& core, const DebugAnswer& told) noexcept try {
    pending_.reset();
    rules_.clear();
    standing_ = &core;
    worked_ += Clock::now() - since_;
    channel_.send(told);
    do {
      // A request to go back stays in the channel for the process that can fulfil it.
      const std::optional<DebugRequest> next = channel_.peek<DebugRequest>();
      if (!next) ::_exit(EXIT_SUCCESS);
      if (goes_back(*next) && points_.can_go_back(next->from)) go_back(*next);
      const DebugRequest request = channel_.receive<DebugRequest>().value();
      if (goes_back(request)) {  // the host has allowed no point so early: the history begins here
        channel_.send(stopped({.why = Stop::Why::kBeginning, .core = core.number()}));
        continue;
      }
      if (const std::optional<DebugAnswer> answer = fulfil(request)) channel_.send(*answer);
    } while (standing_ != nullptr);
    since_ = Clock::now();
    // The way from here on depends on what was written, which no earlier point knows.
    if (inspector_->take_jump()) jumped_to_ = position_ + 1;
    if (inspector_->take_written()) take_point();
    if (goal_ == position_) reach_goal(core);
  } catch (const std::exception& error) {
    end(fmt::format("{}\n", error.what()), {.why = Stop::Why::kFailed});
  }

  [[nodiscard]] static bool goes_back(const DebugRequest& request) {
    return request.kind == DebugRequest::Kind::kGoBack || request.kind == DebugRequest::Kind::kSearchBack;
  }

  [[noreturn]] void go_back(const DebugRequest& request) {
    inspector_->close_wave();
    points_.go_back(request.from);
  }

  [[nodiscard]] bool point_is_due() const {
    if (inspector_->wave_is_on() || point_ == position_) return false;
    return pacing_.is_due(worked_ + (Clock::now() - since_), points_.count(), gap());
  }

  // To the goal, if there is one.
  [[nodiscard]] std::optional<std::int64_t> gap() const {
    return goal_ ? std::optional{*goal_ - position_} : std::nullopt;
  }

  // Returns once more each time that the process is taken back here.
  void take_point() {
    const Clock::time_point begin = Clock::now();
    worked_ += begin - std::exchange(since_, begin);
    pacing_.begin_point(worked_, gap().value_or(0));
    point_ = position_;
    try {
      if (points_.mark(position_)) {
        take_order();
      } else {
        pacing_.end_point(Clock::now() - begin);
      }
    } catch (const std::runtime_error&) {
      pacing_.refused(points_.count());
    }
    since_ = Clock::now();
  }

  // Of the process that was taken back: what go_back() has left in the channel.
  void take_order() {
    const DebugRequest request = channel_.receive<DebugRequest>().value();
    rules_.clear();
    pending_.reset();
    found_.reset();
    goal_ = request.position;
    pacing_.begin_way(*gap());
    goal_stop_ = request.stop;
    searched_from_ = position_;
    searches_ = request.kind == DebugRequest::Kind::kSearchBack;
    if (searches_) rules_.set({}, std::span{request.go_on.points}.first(request.go_on.count));
  }

  // Of a run that continues: nothing else is asked of it.
  void take_interrupt() {
    if (!channel_.receive<DebugRequest>()) ::_exit(EXIT_SUCCESS);
    rules_.interrupt();
  }

  std::optional<DebugAnswer> fulfil(const DebugRequest& request) {
    switch (request.kind) {
      case DebugRequest::Kind::kResume:
        rules_.set(request.go_on.how, std::span{request.go_on.points}.first(request.go_on.count));
        standing_ = nullptr;
        break;
      case DebugRequest::Kind::kDetach:
        standing_ = nullptr;
        break;
      case DebugRequest::Kind::kInterrupt:  // it stands already
        break;
      default:
        return inspector_->answer(request, {.core = standing_, .addresses = addresses_});
    }
    return std::nullopt;
  }

  struct Found {
    Stop stop;
    std::int64_t position = 0;
  };

  MessageChannel& channel_;
  ArmProgram* program_ = nullptr;
  std::optional<GoldenListener> golden_;
  std::unique_ptr<Run> run_;
  std::optional<RunInspector> inspector_;

  // ---- forwards
  StopRules rules_;
  std::optional<Stop> pending_;                 // at the next instruction of its core
  std::array<std::uint32_t, 2> addresses_{};    // of the latest instruction of each core
  std::int64_t position_ = 0;                   // of the next instruction
  std::array<std::int64_t, 2> before_{-1, -1};  // positions of the latest instructions
  ArmCore* standing_ = nullptr;                 // before whose instruction the run stands
  std::int64_t jumped_to_ = -1;                 // the position at which a core has begun at a pc that gdb has set

  // ---- back
  ReturnPoints points_;
  PointPacing pacing_{kPacing};
  std::int64_t point_ = -1;           // position of the latest point
  std::optional<std::int64_t> goal_;  // a position to stand at, of a run that was taken back
  Stop goal_stop_;                    // that is told there
  bool searches_ = false;             // up to the goal
  std::optional<Found> found_;        // the latest one
  std::int64_t searched_from_ = 0;

  Clock::time_point since_ = Clock::now();  // the run continues
  Clock::duration worked_{};                // before that
};

}  // namespace

void serve_debugged_run(const Scenario& scenario, const DebuggedRunOptions& options, MessageChannel& channel) {
  std::optional<DebuggedRun> run;
  std::string error;
  try {
    run.emplace(scenario, options, channel).serve();
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  DebugAnswer text = text_answer(error + '\n');
  text.kind = DebugAnswer::Kind::kText;
  channel.send(text);
  channel.send(DebugAnswer{.kind = DebugAnswer::Kind::kStopped, .stop = {.why = Stop::Why::kFailed}});
  ::_exit(EXIT_FAILURE);
}

}  // namespace armature::cosim::iss
