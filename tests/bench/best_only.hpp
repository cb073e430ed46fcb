// How the benchmarks of Google Benchmark report.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace armature::bench {

// One line a benchmark, its best repetition; then the ratios.
class BestOnly final : public benchmark::BenchmarkReporter {
 public:
  struct Layout {
    std::vector<std::string> names;                           // of the lines, in their order
    std::vector<std::pair<std::string, int>> counters;        // printed where a benchmark has them, and their decimals
    std::vector<std::pair<std::string, std::string>> ratios;  // pairs (slow, fast), printed below the lines
  };
  explicit BestOnly(Layout layout) : layout_{std::move(layout)} {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      Figure& figure = figures_.try_emplace(name).first->second;
      const bool manual = run.run_name.time_type == "manual_time";
      figure.ns = std::min(figure.ns, manual ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
      for (const auto& [counter, value] : run.counters) figure.counters[counter] = value.value;
    }
  }
  void Finalize() override {
    for (const std::string& name : layout_.names) {
      if (!figures_.contains(name)) continue;
      fmt::print("{:<34} {:10.1f} ns", name, figures_.at(name).ns);
      const auto& counters = figures_.at(name).counters;
      for (const auto& [counter, decimals] : layout_.counters) {
        if (counters.contains(counter)) fmt::print("   {} {:.{}f}", counter, counters.at(counter), decimals);
      }
      fmt::print("\n");
    }
    for (const auto& [slow, fast] : layout_.ratios) ratio(slow, fast);
  }

 private:
  struct Figure {
    double ns = std::numeric_limits<double>::infinity();
    std::map<std::string, double> counters;
  };
  void ratio(const std::string& slow, const std::string& fast) const {
    if (!figures_.contains(slow) || !figures_.contains(fast)) return;
    fmt::print("{:<34} / {:<34} {:8.2f}\n", slow, fast, figures_.at(slow).ns / figures_.at(fast).ns);
  }

  Layout layout_;
  std::map<std::string, Figure> figures_;
};

// The main of a benchmark program, after everything is registered: repetitions of all benchmarks alternate, unless the
// user's arguments say otherwise. `title` is printed first.
inline int run_benchmarks(int argc, char** argv, const std::string& title, BestOnly::Layout layout) {
  char interleave[] = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv[0], interleave};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  argc = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  argv = arguments.data();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  fmt::print("{}\n", title);
  BestOnly reporter{std::move(layout)};
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}

}  // namespace armature::bench
