#include "cosim/cli/scenario_run.hpp"

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/null_sink.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

#include "controller/base/timebase.hpp"
#include "cosim/cli/event_log.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/cli/pace.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/program_note_text.hpp"
#include "cosim/report/judge/expect.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/move_text.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/soc/make_soc.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/trace/load_writer.hpp"

namespace armature::cosim {
namespace {

// Log lines have simulated time. With wall time, two logs of the same run would differ.
spdlog::logger make_log(const std::optional<std::filesystem::path>& file) {
  if (!file) return spdlog::logger{"events", std::make_shared<spdlog::sinks::null_sink_st>()};
  spdlog::logger log{"events", std::make_shared<spdlog::sinks::basic_file_sink_st>(file->string(), true)};
  log.set_pattern("%l: %v");
  return log;
}

class Recorder final : public SimulationListener {
 public:
  Recorder(const Scenario& scenario, const ScenarioRunOptions& options)
      : scenario_{scenario},
        names_{scenario},
        facts_{scenario.robot, scenario.expect.settled_counts, scenario.conveyor, names_},
        log_{make_log(options.log)},
        progress_{std::cerr, scenario.duration_s, options.show_progress && stderr_is_terminal()} {
    const ToolColumns columns = has_tool_columns(scenario) ? ToolColumns::kYes : ToolColumns::kNo;
    for (const TraceRequest& trace : options.traces) traces_.emplace_back(trace.file, trace.every_ticks, columns);
    if (options.load) load_.emplace(options.load->file, options.load->every_ticks);
    if (options.compare_golden) golden_.emplace(scenario, columns, *options.compare_golden);
    if (scenario.serial && options.serial_log) serial_log_.emplace(*options.serial_log);
    if (scenario.robot.kinematics) tool_.emplace(scenario);
    needs_tool_point_ = needs_tool_point(scenario);
    log_.info("{}: {}", printable(scenario.name), printable(scenario.description));
  }

  void on_row(const TraceRow& seen) override {
    TraceRow row = seen;
    if (needs_tool_point_) row.tool_point = tool_->measure(row.telemetry);
    digest_.add(row);
    for (CsvWriter& trace : traces_) trace.write(row, digest_);
    if (load_) load_->write(row);
    if (golden_) golden_->add(row, digest_);
    facts_.add(row);
    if (tool_) facts_.add_tool(row, row.tool_point ? row.tool_point->reference_mm : tool_->set_point_mm(row.telemetry));
    if (row.telemetry.state != state_) {
      state_ = row.telemetry.state;
      log_.info("{} state {}", stamp(Cycles{row.cycle}), word_of(state_));
    }
    if (row.tick % kWriteTicks == 0) write_through();
    if (row.tick % kProgressTicks == 0) progress_.update(to_seconds(Cycles{row.cycle}));
  }

  void on_event(const Event& event, Cycles now) override {
    facts_.on_event(event, now);
    event_log_.write(event, now);
  }

  void on_action(const ScriptAction& action, Cycles now) override {
    std::visit([&](const auto& what) { act(what, now); }, action);
  }
  void on_signal(const Signal& signal, Cycles now) override {
    std::visit([&](const auto& what) { see(what, now); }, signal);
  }

  void finish(const SimulationEnd& end) {
    if (!end.failure.empty()) log_.critical("{} {}", stamp(end.cycles), printable(end.failure, kShowAll));
    const RunFacts facts = facts_.facts();
    for (std::size_t i = 0; i < facts.moves.size(); ++i) {
      if (facts.blended_with_next(i) == false)
        log_.warn("{} was not blended with the next one: the tool stopped at its end", names_.of(facts.moves[i].tag));
    }
    for (const InjectedFault& fault : facts.injected_faults) {
      log_.info("injected fault at {}: {}: {}", moment_text(fault.when), fault_text(fault.spec), answer_text(fault));
    }
    for (const GivenInput& input : facts.inputs) {
      log_.info("input at {}: {}: {}", moment_text(input.when), input_text(input.spec), answer_text(input, names_));
    }
    if (facts.moves_waiting != 0 || facts.moves_under_way != 0) {
      log_.warn("{} moves waiting, {} under way at the end", facts.moves_waiting, facts.moves_under_way);
    }
    if (end.serial_unsent != 0) {
      log_.warn("{} characters or breaks to the controller were not sent before the end", end.serial_unsent);
    }
    if (!end.program_end.empty()) log_.warn("{} {}", stamp(end.cycles), early_end_text(end.program_end));
    log_.info("{} end", stamp(end.cycles));
    for (CsvWriter& trace : traces_) trace.close();
    if (load_) load_->close();
    if (serial_log_) serial_log_->close();
  }

  // After finish().
  GoldenCheck judge_golden(EndReason end) {
    if (!golden_) return {};
    if (end == EndReason::kFinished) return golden_->finish(digest_);
    return {GoldenVerdict::kNotCompared,
            end == EndReason::kInterrupted ? "the run was interrupted" : "the run failed before its end",
            {}};
  }

  void log_verdicts(const RunSummary& summary) {
    const GoldenCheck& golden = summary.golden;
    if (golden.verdict == GoldenVerdict::kDiffers) {
      log_.error("golden differs: {}", golden.text);
      std::istringstream details{golden.details + golden.columns};
      for (std::string line; std::getline(details, line);) log_.error("{}", line);
    }
    for (const ExpectFailure& failure : summary.expect_failures) log_.error("not met: {}", failure.text());
    log_.flush();
  }

  [[nodiscard]] RunFacts facts() const { return facts_.facts(); }
  [[nodiscard]] std::string sha256() { return digest_.hex(); }

 private:
  static constexpr std::int64_t kProgressTicks = 200;
  static constexpr std::int64_t kWriteTicks = 2'000;  // 0.1 s of simulated time: the most that a killed run loses

  void act(const CommandSpec& command, Cycles now) {
    facts_.add(command);
    if (is_queued(command.kind)) return;  // on_event() logs it
    log_.info("{} move[{}] {}", stamp(now), command.index, move_text(command.kind));
  }

  void act(const FaultSpec& fault, Cycles now) {
    log_.warn("{} injected fault: {}, at {}", stamp(now), fault_text(fault), moment_text(facts_.add(fault, now)));
  }

  void act(const FaultEnd& end, Cycles now) {
    facts_.end(end.fault, now);
    log_.info("{} injected fault ends: {}", stamp(now), fault_text(end.fault));
  }

  void act(const InputSpec& input, Cycles now) {
    log_.info("{} input: {}, at {}", stamp(now), input_text(input), moment_text(facts_.add(input, now)));
  }

  void act(const StreamStep& step, Cycles now) {
    if (step.point != 0) return;
    const StreamSpec& stream = scenario_.streams[step.stream];
    log_.info("{} stream[{}] begins: {} set-points of {}", stamp(now), stream.index, stream.points.size(),
              printable(stream.file_name));
  }

  void act(const PartStep&, Cycles) {}

  void see(const OutputLevel& output, Cycles now) {
    facts_.add(OutputChange{.pin = output.pin, .level = output.level, .at = now});
    log_.info("{} output: pin {} = {}", stamp(now), output.pin, output.level ? 1 : 0);
  }

  void see(const ServoEnables& enables, Cycles now) {
    facts_.add_servo_enables(enables.levels, now);
    log_.info("{} servo enables of axes 6..1: {:06b}", stamp(now), enables.levels);
  }

  void see(const BusAbort& abort, Cycles now) {
    const BusRequest& request = abort.access.request;
    const BusAbortEvent event{
        .core = abort.access.core, .write = request.write, .address = request.addr, .error = abort.error};
    facts_.add(event, now);
    log_.error("{} bus error: {}", stamp(now), abort_text(event));
  }

  void see(const SerialEvent& event, Cycles) {
    if (serial_log_) serial_log_->write(event);
    if (event.direction == SerialDirection::kTx) facts_.add_serial(event.byte, event.has_error(), event.is_break);
  }

  void see(const PendantStepDone& step, Cycles now) { log_.info("{} {}", stamp(now), step.text); }

  void write_through() {
    for (CsvWriter& trace : traces_) trace.write_through();
    if (load_) load_->write_through();
    if (serial_log_) serial_log_->write_through();
    log_.flush();
  }

  const Scenario& scenario_;
  CommandNames names_;
  RunFactsCollector facts_;
  std::optional<ToolPointMeter> tool_;  // nullopt: the robot has no kinematics
  bool needs_tool_point_ = false;
  IntegerDigest digest_;
  std::vector<CsvWriter> traces_;
  std::optional<LoadWriter> load_;
  std::optional<GoldenComparer> golden_;
  std::optional<SerialLog> serial_log_;
  spdlog::logger log_;
  EventLog event_log_{log_, names_};
  ProgressBar progress_;
  MotionState state_ = MotionState::kIdle;
};

// Waits until the simulation may pass `simulated_s`, or until an interrupt.
void keep_pace(Pace& pace, double simulated_s) {
  constexpr Pace::Clock::duration kLongestSleep = std::chrono::milliseconds{50};  // then Ctrl-C is looked for
  while (!interrupted()) {
    const Pace::Clock::duration wait = pace.wait(simulated_s, Pace::Clock::now());
    if (wait == Pace::Clock::duration::zero()) break;
    std::this_thread::sleep_for(std::min(wait, kLongestSleep));
  }
}

// A tick of simulated time. It takes less than a millisecond of host time, some milliseconds while a waveform is
// written or the controller plans.
constexpr Cycles kSlice = armature::kTickCycles;

}  // namespace

RunSummary summary_before_run(const Scenario& scenario) {
  RunSummary summary;
  summary.scenario = scenario.name;
  summary.description = scenario.description;
  summary.robot = scenario.robot_name;
  summary.tool_version = ARMATURE_VERSION;
  summary.arm = scenario.robot;
  summary.tool = scenario.tool;
  summary.sources = scenario.sources;
  summary.overrides = scenario.overrides;
  summary.seed = scenario.seed;
  summary.variant = scenario.variant;
  summary.engine = scenario.engine;
  const CommandNames names{scenario};
  summary.facts = RunFactsCollector{scenario.robot, scenario.expect.settled_counts, scenario.conveyor, names}.facts();
  summary.interrupted = true;
  return summary;
}

RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Recorder recorder{scenario, options};
  std::optional<Pace> pace;
  if (options.pace) pace.emplace(*options.pace, Pace::Clock::now());
  Simulation simulation{scenario, make_soc(scenario), recorder, options.wave, options.serial_peer};
  do {
    if (interrupted() || (options.stop_requested && options.stop_requested())) simulation.interrupt();
    if (pace) keep_pace(*pace, to_seconds(simulation.now()));
  } while (simulation.advance(simulation.now() + kSlice));
  const SimulationEnd end = simulation.finish();
  recorder.finish(end);

  RunSummary summary = summary_before_run(scenario);
  summary.facts = recorder.facts();
  summary.facts.cycles = end.cycles;
  summary.facts.bus_reads = end.bus_reads;
  summary.facts.bus_writes = end.bus_writes;
  summary.facts.worst_tick = end.worst_tick;
  summary.facts.sha256 = recorder.sha256();
  summary.wave_written = end.wave_written;
  summary.serial_unsent = end.serial_unsent;
  summary.interrupted = end.reason == EndReason::kInterrupted;
  if (end.reason == EndReason::kFailed) summary.failure = end.failure;
  summary.program_end = end.program_end;
  if (end.reason == EndReason::kFinished) {
    summary.expect_results = expect_results(scenario.expect, summary.facts);
    summary.expect_failures = check(scenario.expect, summary.facts);
  }
  summary.golden = recorder.judge_golden(end.reason);
  recorder.log_verdicts(summary);
  summary.host.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return summary;
}

}  // namespace armature::cosim
