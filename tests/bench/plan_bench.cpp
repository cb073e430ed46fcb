// What joint plans cost: from rest, from any state of motion, and the ticks of the velocity source.
//
// Random states and targets of six axes. `worst` is the slowest of all states, each with its best time of several.
// usage: plan_bench [--benchmark_...]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/activity/jog/velocity_source.hpp"
#include "controller/trajectory/joint/joint_passage.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"
#include "tests/bench/bench_arms.hpp"
#include "tests/bench/best_only.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace {

using namespace armature;

constexpr std::uint64_t kSeed = 14;
constexpr std::size_t kStates = 4'096;

RobotModel robot_with_jerk() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * test::kDeg;
  return robot;
}

struct State {
  PerAxis<AxisState> moving{};
  PerAxis<Radians> resting{}, target{};
};

const std::vector<State>& states() {
  static const std::vector<State> drawn = [] {
    const RobotModel robot = robot_with_jerk();
    test::Random random{kSeed};
    std::vector<State> result(kStates);
    for (State& state : result) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const AxisModel& model = robot.axes[axis];
        state.moving[axis] = {.position = random.real(-2.0, 2.0),
                              .velocity = random.real(-0.75, 0.75) * model.max_speed_rad_s,
                              .accel = random.real(-0.7, 0.7) * model.max_accel_rad_s2};
        state.resting[axis] = Radians{state.moving[axis].position};
        state.target[axis] = Radians{random.real(-2.0, 2.0)};
      }
    }
    return result;
  }();
  return drawn;
}

// The mean time by the benchmark library; the worst by own measurements of a few calls each.
template <class Work>
void run(benchmark::State& bench, Work work) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto iteration : bench) {
    work(states()[next]);
    next = (next + 1) % kStates;
  }
  using Clock = std::chrono::steady_clock;
  constexpr int kCalls = 4, kRounds = 9;
  double worst_ns = 0.0;
  for (const State& state : states()) {
    double best_ns = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
      const auto begin = Clock::now();
      for (int call = 0; call < kCalls; ++call) work(state);
      best_ns = std::min(best_ns, std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / kCalls);
    }
    worst_ns = std::max(worst_ns, best_ns);
  }
  bench.counters["worst ns"] = worst_ns;
}

void joint_move(benchmark::State& bench, ProfileKind kind) {
  const RobotModel robot = robot_with_jerk();
  run(bench, [&](const State& s) {
    benchmark::DoNotOptimize(plan_joint_move(robot, s.resting, s.target, 1.0, SyncRule::kFig9, kind));
  });
}

void retarget(benchmark::State& bench, ProfileKind kind) {
  const RobotModel robot = robot_with_jerk();
  run(bench, [&](const State& s) { benchmark::DoNotOptimize(plan_retarget(robot, s.moving, s.target, 1.0, kind)); });
}

// From rest to a state of motion.
void passage(benchmark::State& bench, ProfileKind kind) {
  const RobotModel robot = robot_with_jerk();
  run(bench, [&](const State& s) {
    const auto rest = make_per_axis([&](std::size_t axis) { return AxisState{.position = s.target[axis].value()}; });
    benchmark::DoNotOptimize(plan_passage(robot, rest, s.moving, 1.0, kind));
  });
}

class OneCommand final : public VelocityInput {
 public:
  std::optional<VelocityCommand> latest() noexcept override { return std::exchange(next, std::nullopt); }
  std::optional<VelocityCommand> next;
};

// A tick of the velocity source: `commands` new velocities for all axes, or none.
void velocity_tick(benchmark::State& bench, ProfileKind kind, bool commands) {
  const RobotModel robot = robot_with_jerk();
  const Arm arm{robot};
  OneCommand input;
  VelocitySource source{robot, arm, input, {.manner = {.profile = kind}, .time_out = Ticks{1'000'000'000}}};
  source.reset_to({});
  std::int64_t tick = 0;
  const auto command_of = [](const State& s) {
    return VelocityCommand{.joint_rad_s = make_per_axis([&](std::size_t axis) { return s.moving[axis].velocity; })};
  };
  input.next = command_of(states().front());
  // A command repeated by the measurement would change nothing.
  double factor = 1.0;
  run(bench, [&](const State& s) {
    if (commands) {
      input.next = command_of(s);
      factor = -factor;
      for (double& velocity : input.next->joint_rad_s) velocity *= factor;
    }
    benchmark::DoNotOptimize(source.advance(Ticks{++tick}));
  });
}

// A tick of the velocity source while the tool follows a velocity that changes all the time.
void tool_tick(benchmark::State& bench) {
  RobotModel robot = bench::irb_120();
  for (AxisModel& axis : robot.axes) axis.max_accel_rad_s2 = 30.0;
  const Arm arm{robot};
  OneCommand input;
  VelocitySource source{robot, arm, input, {.time_out = Ticks{1'000'000'000}}};
  source.reset_to({Radians{0.2}, Radians{0.3}, Radians{0.2}, Radians{0.5}, Radians{0.9}, Radians{-0.3}});
  std::int64_t tick = 0;
  run(bench, [&](const State&) {
    // 25 mm to and fro.
    const double direction = tick / 10'000 % 2 == 0 ? 50.0 : -50.0;
    if (tick % 10'000 == 0) {
      input.next = VelocityCommand{.kind = VelocityCommand::Kind::kTool,
                                   .tool = {.move_mm_s = {direction, direction, 0.0}, .turn_rad_s = {0, 0, 0.2}}};
    }
    benchmark::DoNotOptimize(source.advance(Ticks{++tick}));
  });
  bench.counters["departures"] = source.departures();
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names;
  const auto add = [&names](const char* name, auto function, auto... arguments) {
    names.emplace_back(name);
    benchmark::RegisterBenchmark(name, function, arguments...)->Repetitions(5)->MinTime(0.05);
  };
  constexpr ProfileKind kTrapezoid = ProfileKind::kTrapezoid, kSCurve = ProfileKind::kSCurve;
  add("joint move, trapezoid", joint_move, kTrapezoid);
  add("joint move, S-curve", joint_move, kSCurve);
  add("retarget, trapezoid", retarget, kTrapezoid);
  add("retarget, S-curve", retarget, kSCurve);
  add("passage, trapezoid", passage, kTrapezoid);
  add("passage, S-curve", passage, kSCurve);
  add("velocity tick, trapezoid", velocity_tick, kTrapezoid, false);
  add("velocity tick, S-curve", velocity_tick, kSCurve, false);
  add("velocity command, trapezoid", velocity_tick, kTrapezoid, true);
  add("velocity command, S-curve", velocity_tick, kSCurve, true);
  add("velocity tick, tool", tool_tick);
  return bench::run_benchmarks(
      argc, argv, fmt::format("{} states, seed {}, smallest processor time of all repetitions", kStates, kSeed),
      {.names = names,
       .counters = {{"worst ns", 1}, {"departures", 0}},
       .ratios = {{"retarget, trapezoid", "joint move, trapezoid"},
                  {"retarget, S-curve", "joint move, S-curve"},
                  {"passage, trapezoid", "retarget, trapezoid"},
                  {"passage, S-curve", "retarget, S-curve"}}});
}
