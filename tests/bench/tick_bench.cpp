// What the software of core 0's 50 us tick costs, and a set-point of the planner's check, on an ABB IRB 120 (and a
// five-axis arm of the shape of Hu 2012).
//
// Both cores of the controller run on the model of the logic, core 1 in a thread of its own. The model works outside of
// what is timed: "bus alone" is all that it adds to a tick. The same run is made again and again, and each of its ticks
// keeps the smallest time that it ever took. So other load on the machine hardly matters, while a tick that has more to
// do still shows. The first figure (mean), `median`, `p99` and `max` are over the ticks of a run that the line is
// about. "cold" runs through 4 MiB of other memory between any two ticks: what a tick costs where nothing of it is in
// the caches of its core.
//
// usage: tick_bench [--benchmark_...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "tests/bench/best_only.hpp"
#include "tests/bench/tick_run.hpp"
#include "tests/bench/tick_scripts.hpp"
#include "tests/controller/support/finish_plan.hpp"

namespace {

using namespace armature;
using bench::TickRun;
using bench::TickScript;

constexpr std::size_t kRuns = 6;  // an iteration is a run
constexpr int kRepetitions = 5;
using Meant = bool (*)(const TickRun&, std::size_t tick);

// The best of each tick over all runs of one name.
std::map<std::string, std::vector<double>> best_ns;

void note(benchmark::State& state, const std::string& name, const std::vector<double>& ns) {
  std::vector<double>& best =
      best_ns.try_emplace(name, ns.size(), std::numeric_limits<double>::infinity()).first->second;
  double sum = 0.0;
  for (std::size_t i = 0; i < ns.size(); ++i) {
    best[i] = std::min(best[i], ns[i]);
    sum += best[i];
  }
  state.SetIterationTime(1e-9 * sum / static_cast<double>(ns.size()));
}

void count(benchmark::State& state, const std::string& name) {
  std::vector<double> sorted = best_ns.at(name);
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  state.counters["ticks"] = static_cast<double>(sorted.size());
  state.counters["median"] = quantile(0.5);
  state.counters["p99"] = quantile(0.99);
  state.counters["max"] = sorted.back();
}

void ticks_of(benchmark::State& state, const std::string& name, const TickScript& script, const Meant& meant) {
  for (auto _ : state) {
    const TickRun run = bench::run(script);
    std::vector<double> ns;
    for (std::size_t tick = 0; tick < run.ticks.size(); ++tick) {
      if (meant(run, tick)) ns.push_back(run.ticks[tick].ns);
    }
    note(state, name, ns);
  }
  count(state, name);
}

void bus_alone(benchmark::State& state, const std::string& name) {
  for (auto _ : state) note(state, name, bench::bus_alone_ns(5'000));
  count(state, name);
}

// A set-point of the planner's check, the mean over all passes.
void planner_check(benchmark::State& state, const std::string& name, const bench::PathCase& path) {
  const Arm arm{path.robot};
  CartesianPlanner planner{path.robot, arm, path.flange_T_tool, 20.0};
  for (auto _ : state) {
    const auto before = std::chrono::steady_clock::now();
    planner.begin(path.start, {&path.request, 1});
    test::finish_plan(planner);
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - before;
    if (planner.progress() != CartesianPlanner::Progress::kDone) throw std::logic_error{"a path was refused"};
    const auto set_points = static_cast<double>(planner.plan().duration.value() * planner.passes());
    note(state, name, {taken.count() / set_points});
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name, auto function, auto... arguments) {
    names.push_back(name);
    benchmark::RegisterBenchmark(name.c_str(), function, name, arguments...)
        ->Iterations(kRuns)
        ->Repetitions(kRepetitions)
        ->UseManualTime();
  };
  const auto cold = [](TickScript script) {
    script.cold = true;
    return script;
  };
  add("bus alone", bus_alone);
  add("idle", ticks_of, bench::idle(), &bench::all);
  add("joint move", ticks_of, bench::joint_move(), &bench::in_last_move);
  add("joint move, S-curve", ticks_of, bench::joint_scurve(), &bench::in_last_move);
  add("line", ticks_of, bench::line(), &bench::in_last_move);
  add("rounded corners", ticks_of, bench::corners(), &bench::in_corners);
  add("short lines in windows", ticks_of, bench::short_lines(), &bench::in_lines);
  add("arc, S-curve", ticks_of, bench::arc(), &bench::in_last_move);
  add("ramps of hold and resume", ticks_of, bench::holds(), &bench::on_ramps);
  add("line, five axes", ticks_of, bench::five_axis_line(), &bench::in_last_move);
  add("line, cold", ticks_of, cold(bench::line()), &bench::in_last_move);
  add("short lines, cold", ticks_of, cold(bench::short_lines()), &bench::in_lines);
  add("ramps, cold", ticks_of, cold(bench::holds()), &bench::on_ramps);
  add("planner, line", planner_check, bench::path_of(bench::line()));
  add("planner, arc, S-curve", planner_check, bench::path_of(bench::arc()));
  return bench::run_benchmarks(
      argc, argv, "ns of a tick's software, at best of each tick; planner: of a set-point",
      {.names = names, .counters = {{"median", 0}, {"p99", 0}, {"max", 0}, {"ticks", 0}}, .ratios = {}});
}
