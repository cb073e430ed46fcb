// What the simulation costs per clock, against the verilated model alone, in one process. For the first 0.25 s of
// fig9_joint_move and max_rate_4mpps:
//
//   bare      the model alone, with the levels that the run has on pins and bus (bare_model.hpp): the limit
//   run       nothing recorded
//   recorded  the same with facts, full-rate hash and the 1 kHz trace file, as `armature run` does
//
// The three alternate, and each figure is the smallest processor time of all rounds, so that other load on the machine
// hardly matters.
//
// Then, without the second argument, Cartesian scenarios, complete as `armature run` makes them (planning, tool point,
// path error, trace file), each beside its joint twin (joint_twin.hpp), in rounds that alternate in their order: the
// median of the rounds' ratios.
// usage: cycle_loop_bench [ROUNDS [bare]]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "cosim/cli/run/scenario_run.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "tests/bench/bare_model.hpp"
#include "tests/bench/joint_twin.hpp"
#include "tests/support/silent_listener.hpp"

namespace {

using namespace armature;
using namespace armature::cosim;

constexpr double kMeasured_s = 0.25;  // simulated time of the comparison with the bare model

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

struct Figure {
  double seconds = std::numeric_limits<double>::infinity();
  void measure(const std::function<void()>& work) { seconds = std::min(seconds, seconds_of(work)); }
};

class Recording final : public cosim::test::SilentListener {
 public:
  explicit Recording(const Scenario& scenario) : facts_{scenario.robot, 1} {}
  void on_row(TraceRow& row) override {
    digest_.add(row);
    trace_.write(row, digest_);
    facts_.add(row);
  }

 private:
  RunFactsCollector facts_;
  IntegerDigest digest_;
  CsvWriter trace_{std::filesystem::temp_directory_path() / "armature_bench.csv", 20};
};

double recorded_seconds(const Scenario& scenario) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "armature_bench.csv";
  ScenarioRunOptions options;
  options.traces = {{file, scenario.trace.every_ticks}};
  RunSummary summary;
  const double seconds = seconds_of([&] { summary = run_scenario(scenario, options); });
  std::filesystem::remove(file);
  const auto moves = static_cast<std::int64_t>(scenario.moves.size());
  if (summary.failure || !summary.expect_failures.empty() || summary.facts.moves_finished != moves) {
    throw std::runtime_error{scenario.name + " did not go as planned"};
  }
  return seconds;
}

void compare_with_joint_twin(const Scenario& scenario, int rounds) {
  const Scenario twin = bench::joint_twin(scenario);
  std::vector<double> ratios;
  double cartesian = 0.0, joint = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const bool cartesian_first = round % 2 == 0;
    if (cartesian_first) cartesian = recorded_seconds(scenario);
    joint = recorded_seconds(twin);
    if (!cartesian_first) cartesian = recorded_seconds(scenario);
    ratios.push_back(cartesian / joint);
  }
  std::sort(ratios.begin(), ratios.end());
  fmt::print("{} / joint twin  {:.3f}   ({:.3f} .. {:.3f} in {} rounds; at most 1.05)\n", scenario.name,
             ratios[ratios.size() / 2], ratios.front(), ratios.back(), rounds);
}

void compare_with_bare_model(const Scenario& scenario, int rounds) {
  const bench::BareModel model{scenario};
  const Cycles cycles{model.clocks()};
  Figure bare, run, recorded;
  for (int round = 0; round < rounds; ++round) {
    bare.measure([&] { model.replay(); });
    run.measure([&] {
      cosim::test::SilentListener silent;
      cosim::test::run_to_end(Simulation{scenario, make_soc(scenario), silent});
    });
    recorded.measure([&] {
      Recording recording{scenario};
      cosim::test::run_to_end(Simulation{scenario, make_soc(scenario), recording});
    });
  }
  std::filesystem::remove(std::filesystem::temp_directory_path() / "armature_bench.csv");

  const auto line = [&](const char* name, const Figure& figure) {
    const double count = static_cast<double>(cycles.value());
    fmt::print("{:<10} {:6.1f} ns/cycle  {:6.2f} Mcycles/s  real-time factor {:.3f}\n", name,
               1e9 * figure.seconds / count, 1e-6 * count / figure.seconds, to_seconds(cycles) / figure.seconds);
  };
  fmt::print("{}, {} cycles, best of {} rounds\n", scenario.name, cycles.value(), rounds);
  line("bare", bare);
  line("run", run);
  line("recorded", recorded);
  fmt::print("{} / bare model  {:.3f}   (at most 1.15)\n", scenario.name, run.seconds / bare.seconds);
  fmt::print("recorder's cost  {:.2f} %  (under 3 %)\n", 100.0 * (recorded.seconds / run.seconds - 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  const auto load = [&](const char* name) {
    return load_scenario(scenarios / name, {.search_path = scenarios, .overrides = {}});
  };
  for (const char* name : {"fig9_joint_move", "max_rate_4mpps"}) {
    Scenario scenario = load(name);
    scenario.duration_s = kMeasured_s;
    compare_with_bare_model(scenario, rounds);
  }
  if (argc > 2) return 0;
  for (const char* name : {"draw_line", "draw_star_blended"}) compare_with_joint_twin(load(name), rounds);
  return 0;
}
