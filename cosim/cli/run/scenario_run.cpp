#include "cosim/cli/run/scenario_run.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

#include "controller/base/timebase.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/pace.hpp"
#include "cosim/report/format/progress_bar.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/load_listener.hpp"
#include "cosim/run/log_listener.hpp"
#include "cosim/run/progress_listener.hpp"
#include "cosim/run/serial_listener.hpp"
#include "cosim/run/trace_listener.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using Listeners = std::vector<std::unique_ptr<RunListener>>;

Listeners listeners_for(const Scenario& scenario, const ScenarioRunOptions& options) {
  Listeners all;
  // The first one, so that its lines are complete when another file cannot be written.
  if (options.log) all.push_back(std::make_unique<LogListener>(scenario, *options.log));
  for (const TraceFile& trace : options.traces) all.push_back(std::make_unique<TraceListener>(scenario, trace));
  if (options.load) all.push_back(std::make_unique<LoadListener>(*options.load));
  if (options.compare_golden) all.push_back(std::make_unique<GoldenListener>(scenario, *options.compare_golden));
  if (scenario.serial && options.serial_log) all.push_back(std::make_unique<SerialListener>(*options.serial_log));
  if (options.show_progress && stderr_is_terminal()) {
    all.push_back(std::make_unique<ProgressListener>(scenario, std::cerr));
  }
  return all;
}

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

RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Listeners listeners = listeners_for(scenario, options);
  std::optional<Pace> pace;
  if (options.pace) pace.emplace(*options.pace, Pace::Clock::now());
  Run run{scenario, {.wave = options.wave, .serial_peer = options.serial_peer}};
  for (const auto& listener : listeners) run.add(*listener);
  do {
    if (interrupted() || (options.stop_requested && options.stop_requested())) run.interrupt();
    if (pace) keep_pace(*pace, to_seconds(run.now()));
  } while (run.advance(run.now() + kSlice));
  RunSummary summary = run.finish();
  summary.host.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return summary;
}

}  // namespace armature::cosim
