// What the planning of chains and windows costs.
//
//   first_plan       16 lines
//   window           such a plan, continued by as many further lines as there is room for
//   lines, polyline  16 to 4096 lines in as few windows as possible, each begun just before the arm brakes, as
//                    WindowStage does
//
// IRB 120, 100 mm/s, 2 m/s^2, 1000 m/s^3. A polyline is lines of equal length on a circle of 40 mm radius, blended
// within a tenth of it, here 0.5 mm long. The lines are the sides of squares, 5 mm long and blended within 0.5 mm.
//
// `inverses` is what core 1 is charged, in inverse kinematics of 7 us; `core1_ms` the same as time; `takes_ms` the time
// that the last plan takes to execute. usage: window_bench [--benchmark_...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/controller/support/finish_plan.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace {

using namespace armature;

constexpr PathLimits kLimits{.speed_mm_s = 100.0,
                             .accel_mm_s2 = 2'000.0,
                             .jerk_mm_s3 = 1e6,
                             .turn_speed_rad_s = 2.0,
                             .turn_accel_rad_s2 = 20.0,
                             .turn_jerk_rad_s3 = 1e3};
constexpr double kInverse_ms = 7e-3;

std::vector<SegmentRequest> circle(const Transform& from, double step_mm, std::size_t count, ProfileKind profile) {
  constexpr double kRadius_mm = 40.0;
  std::vector<SegmentRequest> lines;
  for (std::size_t i = 1; i <= count; ++i) {
    const double angle = step_mm / kRadius_mm * static_cast<double>(i);
    const Eigen::Vector3d offset = kRadius_mm * Eigen::Vector3d{std::cos(angle) - 1.0, std::sin(angle), 0.0};
    lines.push_back(test::line_to({from.rotation, from.position_mm + offset}, kLimits, 0.1 * step_mm, profile));
  }
  return lines;
}

// Each square is a little lower than the one before, and from 10 mm on a little higher.
std::vector<SegmentRequest> squares(const Transform& from, std::size_t count, ProfileKind profile) {
  constexpr double kSide_mm = 5.0, kLower_mm = 0.05, kDepth_mm = 10.0, kBlend_mm = 0.5;
  std::vector<SegmentRequest> lines;
  for (std::size_t i = 1; i <= count; ++i) {
    const double x_mm = i % 4 == 1 || i % 4 == 2 ? kSide_mm : 0.0, y_mm = i % 4 == 2 || i % 4 == 3 ? kSide_mm : 0.0;
    const double z_mm = std::fabs(std::fmod(kLower_mm * static_cast<double>(i), 2.0 * kDepth_mm) - kDepth_mm);
    const Transform target = test::moved(from, -x_mm, y_mm, z_mm - kDepth_mm);
    lines.push_back(test::line_to(target, kLimits, kBlend_mm, profile));
  }
  return lines;
}

void finish(CartesianPlanner& planner) {
  if (test::finish_plan(planner) != CartesianPlanner::Progress::kDone) throw std::logic_error{"a path was refused"};
}

void note(benchmark::State& state, const CartesianPlanner& planner) {
  const auto inverses = static_cast<double>(planner.inverses());
  state.counters["lines"] = static_cast<double>(planner.plan().count);
  state.counters["inverses"] = inverses;
  state.counters["core1_ms"] = kInverse_ms * inverses;
  state.counters["takes_ms"] = 1e3 * seconds(planner.plan().duration);
}

// `state.range(0)`: length of a line, in micrometres.
void first_plan(benchmark::State& state, ProfileKind profile) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const auto lines = circle(rig->tool_at(test::kReady), 1e-3 * static_cast<double>(state.range(0)), 16, profile);
  for ([[maybe_unused]] auto iteration : state) {
    rig->planner.begin(test::kReady, lines);
    finish(rig->planner);
  }
  note(state, rig->planner);
}

void window(benchmark::State& state, ProfileKind profile) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const auto lines = circle(rig->tool_at(test::kReady), 1e-3 * static_cast<double>(state.range(0)), 256, profile);
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

// `state.range(0)`: number of lines.
void chain(benchmark::State& state, bool short_ones, ProfileKind profile) {
  const auto rig = std::make_unique<test::PathRig>(test::irb120());
  const Transform from = rig->tool_at(test::kReady);
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto lines = short_ones ? circle(from, 0.5, count, profile) : squares(from, count, profile);
  std::int64_t inverses = 0, windows = 0;
  for ([[maybe_unused]] auto iteration : state) {
    rig->planner.begin(test::kReady, std::span{lines}.first(16));
    finish(rig->planner);
    inverses = rig->planner.inverses();
    windows = 1;
    for (std::size_t planned = 16; planned < lines.size(); ++windows) {
      const double brakes_ticks = rig->planner.continue_before_s() / kTickSeconds;
      const Ticks soon{std::max<std::int64_t>(20, static_cast<std::int64_t>(brakes_ticks) - 20)};
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

void add() {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    const std::string kind = profile == ProfileKind::kSCurve ? "_scurve" : "";
    const auto named = [&](const std::string& name, auto function, auto... arguments) {
      return benchmark::RegisterBenchmark((name + kind).c_str(), function, arguments...)->Unit(benchmark::kMillisecond);
    };
    named("first_plan", first_plan, profile)->Arg(100)->Arg(300)->Arg(500)->Arg(1'000);
    named("window", window, profile)->Arg(100)->Arg(300)->Arg(500)->Arg(1'000);
    named("lines", chain, false, profile)->Arg(16)->Arg(64)->Arg(256)->Arg(1'024)->Arg(4'096);
    named("polyline", chain, true, profile)->Arg(16)->Arg(64)->Arg(256)->Arg(1'024)->Arg(4'096);
  }
}

}  // namespace

int main(int argc, char** argv) {
  add();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
