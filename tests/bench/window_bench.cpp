// What the planning of a window costs: a plan of 16 lines, continued by as many further lines as there is room for, and
// a chain of 256 lines, planned in as few windows as possible.
//
// Lines of equal length on a circle of 40 mm radius, IRB 120, 100 mm/s, 2 m/s^2. `inverses` is what core 1 is charged,
// in inverse kinematics of 3 us; `core1_ms` the same as time; `per_window_ms` the time that the window takes to
// execute. usage: window_bench [--benchmark_...]
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tests/controller/support/path_rig.hpp"

namespace {

using namespace armature;

constexpr PathLimits kLimits{.speed_mm_s = 100.0,
                             .accel_mm_s2 = 2'000.0,
                             .jerk_mm_s3 = 1e6,
                             .turn_speed_rad_s = 2.0,
                             .turn_accel_rad_s2 = 20.0,
                             .turn_jerk_rad_s3 = 1e3};
constexpr double kInverse_ms = 3e-3;

std::vector<SegmentRequest> circle(const Transform& from, double step_mm, std::size_t count) {
  constexpr double kRadius_mm = 40.0;
  std::vector<SegmentRequest> lines;
  for (std::size_t i = 1; i <= count; ++i) {
    const double angle = step_mm / kRadius_mm * static_cast<double>(i);
    const Eigen::Vector3d offset = kRadius_mm * Eigen::Vector3d{std::cos(angle) - 1.0, std::sin(angle), 0.0};
    lines.push_back(test::line_to({from.rotation, from.position_mm + offset}, kLimits, 0.1 * step_mm));
  }
  return lines;
}

void finish(CartesianPlanner& planner) {
  while (planner.work(1'000) == CartesianPlanner::Progress::kWorking) {
  }
  if (planner.progress() != CartesianPlanner::Progress::kDone) throw std::logic_error{"a path was refused"};
}

void note(benchmark::State& state, const CartesianPlanner& planner) {
  const auto inverses = static_cast<double>(planner.inverses());
  state.counters["lines"] = static_cast<double>(planner.plan().count);
  state.counters["inverses"] = inverses;
  state.counters["core1_ms"] = kInverse_ms * inverses;
  state.counters["per_window_ms"] = 1e3 * seconds(planner.plan().duration);
}

// `state.range(0)`: length of a line, in micrometres.
void first_plan(benchmark::State& state) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const auto lines = circle(rig->tool_at(test::kReady), 1e-3 * static_cast<double>(state.range(0)), 16);
  for ([[maybe_unused]] auto iteration : state) {
    rig->planner.begin(test::kReady, lines);
    finish(rig->planner);
  }
  note(state, rig->planner);
}

void window(benchmark::State& state) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const auto lines = circle(rig->tool_at(test::kReady), 1e-3 * static_cast<double>(state.range(0)), 256);
  for ([[maybe_unused]] auto iteration : state) {
    state.PauseTiming();
    rig->planner.begin(test::kReady, std::span{lines}.first(16));
    finish(rig->planner);
    const Ticks soon{20};
    const std::size_t room = std::min(rig->planner.room(soon), lines.size() - 16);
    state.ResumeTiming();
    if (!rig->planner.extend(soon, lines[15].blend_mm, std::span{lines}.subspan(16, room))) {
      throw std::logic_error{"a window cannot continue"};
    }
    finish(rig->planner);
  }
  note(state, rig->planner);
}

// All lines are in the last plan, except those that are over at its begin.
void chain_of_256(benchmark::State& state) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const auto lines = circle(rig->tool_at(test::kReady), 1e-3 * static_cast<double>(state.range(0)), 256);
  std::int64_t inverses = 0, windows = 0;
  for ([[maybe_unused]] auto iteration : state) {
    rig->planner.begin(test::kReady, std::span{lines}.first(16));
    finish(rig->planner);
    inverses = rig->planner.inverses();
    windows = 1;
    for (std::size_t planned = 16; planned < lines.size(); ++windows) {
      const Ticks soon{20};
      const std::size_t room = std::min(rig->planner.room(soon), lines.size() - planned);
      if (!rig->planner.extend(soon, lines[planned - 1].blend_mm, std::span{lines}.subspan(planned, room))) {
        throw std::logic_error{"a window cannot continue"};
      }
      finish(rig->planner);
      inverses += rig->planner.inverses();
      planned += room;
    }
  }
  note(state, rig->planner);
  state.counters["plans"] = static_cast<double>(windows);
  state.counters["inverses"] = static_cast<double>(inverses);
  state.counters["core1_ms"] = kInverse_ms * static_cast<double>(inverses);
}

BENCHMARK(first_plan)->Arg(100)->Arg(300)->Arg(500)->Arg(1'000)->Unit(benchmark::kMillisecond);
BENCHMARK(chain_of_256)->Arg(100)->Arg(300)->Arg(500)->Arg(1'000)->Unit(benchmark::kMillisecond);
BENCHMARK(window)->Arg(100)->Arg(300)->Arg(500)->Arg(1'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
