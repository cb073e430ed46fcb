// What the two engines take, in one process, with everything that `armature run` records. Times are processor time, the
// smallest of alternating rounds. tests/bench/engine_table.py prints it beside the goals.
//
//   engine_bench ratio SCENARIO ROUNDS   `ratio`, and the seconds of a run with the RTL and with the model
//   engine_bench steps SCENARIO ROUNDS   steps of 1 ms a second in which a client advances a run on the model
//   engine_bench long SECONDS            time of SECONDS of moves on the model over that of 1 s, and what the peak of
//   the
//                                        memory grows by meanwhile [MB]
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "cosim/cli/run/folder_run.hpp"
#include "cosim/cli/run/temporary_folder.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"

namespace {

using namespace armature;
using namespace armature::cosim;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

Scenario load(const std::string& name) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  return load_scenario(scenarios / name, {.search_path = scenarios, .overrides = {}});
}

void require_success(const Scenario& scenario, const RunSummary& summary) {
  if (summary.failure) throw std::runtime_error{scenario.name + ": " + *summary.failure};
  if (summary.interrupted) throw std::runtime_error{scenario.name + " was interrupted"};
  if (!summary.expect_failures.empty()) {
    const ExpectFailure& failure = summary.expect_failures.front();
    throw std::runtime_error{scenario.name + ": expected " + failure.key + " " + failure.expected + ", got " +
                             failure.got};
  }
}

// Of a whole run into a folder.
double seconds_of(Scenario scenario, Engine engine) {
  const TemporaryFolder out;
  scenario.engine = engine;
  const double start = processor_seconds();
  const RunSummary summary = run_into_folder(scenario, {.out = out.path(), .show_progress = false});
  const double seconds = processor_seconds() - start;
  require_success(scenario, summary);
  if (!summary.passed()) throw std::runtime_error{scenario.name + " differs from its golden"};
  return seconds;
}

void compare_engines(const Scenario& scenario, int rounds) {
  double rtl = std::numeric_limits<double>::infinity(), model = rtl;
  for (int round = 0; round < rounds; ++round) {
    model = std::min(model, seconds_of(scenario, Engine::kModel));
    rtl = std::min(rtl, seconds_of(scenario, Engine::kRtl));
    model = std::min(model, seconds_of(scenario, Engine::kModel));
  }
  fmt::print("ratio {:.2f} rtl {:.3f} model {:.4f} simulated {:.4f}\n", rtl / model, rtl, model, scenario.duration_s);
}

void count_steps(Scenario scenario, int rounds) {
  constexpr Cycles kMillisecond{50'000};
  scenario.engine = Engine::kModel;
  double seconds = std::numeric_limits<double>::infinity();
  std::int64_t steps = 0;
  for (int round = 0; round < rounds; ++round) {
    Run run{scenario};
    steps = 1;
    const double start = processor_seconds();
    while (run.advance(run.now() + kMillisecond)) ++steps;
    seconds = std::min(seconds, processor_seconds() - start);
    require_success(scenario, run.finish());
  }
  fmt::print("steps {:.0f}\n", static_cast<double>(steps) / seconds);
}

// Moves there and back, one a second.
double seconds_of_moves(Scenario scenario, int seconds) {
  const CommandSpec there = scenario.moves.at(0);
  CommandSpec back = there;
  std::get<JointSpec>(back.kind).target_deg = PerAxis<double>{};
  scenario.moves.clear();
  for (int second = 0; second < seconds; ++second) {
    scenario.moves.push_back(second % 2 == 0 ? there : back);
    scenario.moves.back().at_s = there.at_s + second;
  }
  scenario.duration_s = seconds;
  scenario.expect = {};
  scenario.engine = Engine::kModel;
  const TemporaryFolder out;
  const double start = processor_seconds();
  const RunSummary summary = run_into_folder(
      scenario, {.out = out.path(), .show_progress = false, .why_not_compared = "another program of moves"});
  const double time = processor_seconds() - start;
  require_success(scenario, summary);
  if (summary.facts.moves_finished != seconds) throw std::runtime_error{"a move did not reach its end"};
  return time;
}

void compare_lengths(int seconds) {
  const Scenario scenario = load("fig9_joint_move");
  constexpr int kRounds = 5;
  double one = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) one = std::min(one, seconds_of_moves(scenario, 1));
  const double before = peak_megabytes();
  const double all = seconds_of_moves(scenario, seconds);
  fmt::print("long {:.1f} memory {:.2f}\n", all / one, peak_megabytes() - before);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  try {
    if (what == "ratio" && argc == 4) {
      compare_engines(load(argv[2]), std::atoi(argv[3]));
    } else if (what == "steps" && argc == 4) {
      count_steps(load(argv[2]), std::atoi(argv[3]));
    } else if (what == "long" && argc == 3) {
      compare_lengths(std::atoi(argv[2]));
    } else {
      fmt::print(stderr, "usage: engine_bench ratio|steps SCENARIO ROUNDS | long SECONDS\n");
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "engine_bench: {}\n", error.what());
    return 1;
  }
  return 0;
}
