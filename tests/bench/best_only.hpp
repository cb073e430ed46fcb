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
  // Names in the order of the lines; pairs (slow, fast) whose ratio is printed below them.
  BestOnly(std::vector<std::string> names, std::vector<std::pair<std::string, std::string>> ratios)
      : names_{std::move(names)}, ratios_{std::move(ratios)} {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      Figure& figure = figures_.try_emplace(name).first->second;
      figure.ns = std::min(figure.ns, run.GetAdjustedCPUTime());
      for (const auto& [counter, value] : run.counters) figure.counters[counter] = value.value;
    }
  }
  void Finalize() override {
    for (const std::string& name : names_) {
      if (!figures_.contains(name)) continue;
      fmt::print("{:<34} {:10.1f} ns", name, figures_.at(name).ns);
      for (const char* counter : {"solutions", "found"}) {
        const auto& counters = figures_.at(name).counters;
        if (counters.contains(counter)) fmt::print("   {} {:.3f}", counter, counters.at(counter));
      }
      fmt::print("\n");
    }
    for (const auto& [slow, fast] : ratios_) ratio(slow, fast);
  }

 private:
  struct Figure {
    double ns = std::numeric_limits<double>::infinity();
    std::map<std::string, double> counters;
  };
  void ratio(const std::string& slow, const std::string& fast) const {
    if (!figures_.contains(slow) || !figures_.contains(fast)) return;
    fmt::print("{:<16} / {:<34} {:8.2f}\n", slow, fast, figures_.at(slow).ns / figures_.at(fast).ns);
  }

  std::vector<std::string> names_;
  std::vector<std::pair<std::string, std::string>> ratios_;
  std::map<std::string, Figure> figures_;
};

}  // namespace armature::bench
