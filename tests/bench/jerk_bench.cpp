// How much longer S-curves take than the fastest motion with limited jerk that an oracle finds, and what their planning
// costs: a table, one line for each path. `jerk_bench [RANDOM [NODES]]`: random chains behind the named paths, and
// nodes of the oracle's grid.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "tests/controller/support/jerk_cases.hpp"
#include "tests/controller/support/jerk_oracle.hpp"

int main(int argc, char** argv) {
  using namespace armature;
  constexpr double kInverse_ms = 3e-3;  // of core 1
  constexpr std::uint64_t kFirstSeed = 1'000;
  const int randoms = argc > 1 ? std::atoi(argv[1]) : 100, nodes = argc > 2 ? std::atoi(argv[2]) : 1'500;
  std::vector<test::JerkCase> cases = test::jerk_cases();
  for (int i = 0; i < randoms; ++i) cases.push_back(test::random_jerk_case(kFirstSeed + static_cast<std::uint64_t>(i)));
  fmt::print("{:28} {:>9} {:>9} {:>6} {:>6} {:>6} {:>6} {:>9} {:>6}\n", "path", "plan ms", "oracle ms", "ratio",
             "accel", "jerk", "oracle", "core 1 ms", "passes");
  double sum = 0.0, most = 0.0;
  for (const test::JerkCase& path : cases) {
    const auto rig = std::make_unique<test::PathRig>(path.robot);
    if (rig->plan(path.start, path.chain) != CartesianPlanner::Progress::kDone) {
      fmt::print("{:28} refused: {}\n", path.name, static_cast<int>(rig->planner.problem().kind));
      continue;
    }
    const double planned_s = seconds(rig->planner.plan().duration);
    const test::SampledShares shares = test::shares_of_plan(*rig), between = test::shares_of_plan(*rig, 0.37);
    const test::OracleMotion oracle = test::fastest_with_jerk(*rig, nodes);
    const double ratio = planned_s / oracle.duration_s;
    fmt::print("{:28} {:9.2f} {:9.2f} {:6.3f} {:6.3f} {:6.3f} {:6.3f} {:9.1f} {:6}\n", path.name, 1e3 * planned_s,
               1e3 * oracle.duration_s, ratio, std::max(shares.accel, between.accel),
               std::max(shares.jerk, between.jerk), std::max(oracle.shares.accel, oracle.shares.jerk),
               kInverse_ms * static_cast<double>(rig->planner.inverses()), rig->planner.passes());
    sum += ratio;
    most = std::max(most, ratio);
  }
  fmt::print("mean ratio {:.3f}, largest {:.3f}\n", sum / static_cast<double>(cases.size()), most);
}
