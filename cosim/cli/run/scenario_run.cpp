#include "cosim/cli/run/scenario_run.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

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

struct Listeners {
  std::vector<std::unique_ptr<RunListener>> all;
  const GoldenListener* golden = nullptr;  // one of them
};

Listeners listeners_for(const Scenario& scenario, const ScenarioRunOptions& options) {
  Listeners listeners;
  auto& all = listeners.all;
  // The first one, so that its lines are complete when another file cannot be written.
  if (options.log) all.push_back(std::make_unique<LogListener>(scenario, *options.log));
  for (const TraceFile& trace : options.traces) all.push_back(std::make_unique<TraceListener>(scenario, trace));
  const auto counts = scenario.cpu.cpi ? CountsInstructions::kYes : CountsInstructions::kNo;
  if (options.load) all.push_back(std::make_unique<LoadListener>(*options.load, counts));
  if (options.compare_golden) {
    auto golden = std::make_unique<GoldenListener>(scenario, *options.compare_golden);
    listeners.golden = golden.get();
    all.push_back(std::move(golden));
  }
  if (scenario.serial && options.serial_log) all.push_back(std::make_unique<SerialListener>(*options.serial_log));
  if (options.show_progress && stderr_is_terminal()) {
    all.push_back(std::make_unique<ProgressListener>(scenario, std::cerr));
  }
  return listeners;
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

// Half a millisecond of simulated time. It takes a millisecond of host time at most, a tenth of a second while a
// waveform is written or the controller plans.
constexpr Cycles kSlice{10 * armature::kTickCycles.value()};
// Opens a waveform, which waits for its reader if it is a pipe. Then an interrupt is looked for, before the first tick.
constexpr Cycles kFirstSlice{1};

// Whether snapshots of the run can write its waveforms: the engine has the signals, and nobody outside talks to it.
bool can_show_again(const Scenario& scenario, const ScenarioRunOptions& options) {
  return scenario.engine != Engine::kModel && options.serial_peer == nullptr;
}

}  // namespace

RunSummary run_scenario(const Scenario& scenario, const ScenarioRunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Listeners listeners = listeners_for(scenario, options);
  std::optional<Pace> pace;
  if (options.pace) pace.emplace(*options.pace, Pace::Clock::now());
  const auto stop_requested = [&] { return interrupted() || (options.stop_requested && options.stop_requested()); };
  Run run{scenario, {.wave = options.wave, .serial_peer = options.serial_peer}};
  for (const auto& listener : listeners.all) run.add(*listener);
  std::optional<WaveSnapshots> snapshots;
  if (options.moment_wave && can_show_again(scenario, options)) {
    snapshots.emplace(WaveSnapshots::Parts{scenario, run, listeners.golden, stop_requested}, *options.moment_wave);
  }
  Cycles slice = kFirstSlice;
  do {
    if (stop_requested()) run.interrupt();
    if (pace) keep_pace(*pace, to_seconds(run.now()));
    if (snapshots) snapshots->after_step();
  } while (run.advance(run.now() + std::exchange(slice, kSlice)));
  RunSummary summary = run.finish();
  summary.host.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.moment_wave) {
    EndedRun ended{scenario, summary, stop_requested};
    ended.snapshots = snapshots ? &*snapshots : nullptr;
    if (options.serial_peer != nullptr) ended.heard = options.serial_log;
    ended.show_progress = options.show_progress;
    summary.moment_wave = write_moment_wave(*options.moment_wave, ended);
  }
  return summary;
}

}  // namespace armature::cosim
