// What a pose costs: the closed forms beside Orocos KDL's iterations and beside the closed form that opw_kinematics
// uses, on the same random poses of an ABB IRB 120 (and
// of the arm of Hu 2012 for five joints), in one process.
//
// Each figure is the smallest processor time of several repetitions, which alternate, so that other load on the machine
// hardly matters. `solutions` is the mean number of solutions of a pose. `found` is the share of poses solved within 1
// um and 1e-5 rad: by all solutions, or by the one chosen. KDL finds one solution; "near" it starts 0.01 rad from it in
// every joint (a path), "far" in the middle of the joints' ranges (any move). Arm includes limits, vendor angles and
// the choice of a branch; SixR and FiveR are the closed forms alone. usage: kinematics_bench [--benchmark_...]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "controller/kinematics/arm.hpp"
#include "tests/bench/bench_arms.hpp"
#include "tests/bench/best_only.hpp"
#include "tests/bench/kdl_arm.hpp"
#include "tests/bench/opw_reference.hpp"
#include "tests/controller/support/random.hpp"

namespace {

using namespace armature;
using bench::hu_2012;
using bench::irb_120;
using bench::kDeg;

constexpr std::size_t kPoses = 1000;
constexpr std::uint64_t kSeed = 120;
constexpr double kClose_mm = 1e-3;
constexpr double kClose_rad = 1e-5;

bench::KdlPose to_kdl(const Transform& pose) {
  bench::KdlPose rows{};
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      rows[static_cast<std::size_t>(4 * row + column)] = pose.rotation(row, column);
    }
    rows[static_cast<std::size_t>(4 * row + 3)] = pose.position_mm[row];
  }
  return rows;
}

Theta theta_of(const ArmGeometry& arm, const JointAngles& joints) {
  return make_per_axis([&](std::size_t i) { return arm.sign[i] * joints[i].value() + arm.offset_rad[i]; });
}

struct Sample {
  JointAngles joints{}, near{}, far{};
  Theta theta{}, theta_near{}, theta_far{};
  Transform pose{};
  bench::KdlPose kdl_pose{};
};

std::vector<Sample> six_axis_samples() {
  const RobotModel robot = irb_120();
  const Arm arm{robot};
  test::Random random{kSeed};
  std::vector<Sample> samples(kPoses);
  for (Sample& sample : samples) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      const AxisModel& axis = robot.axes[i];
      const double joint = random.real(axis.min_rad + 0.01, axis.max_rad - 0.01);
      sample.joints[i] = Radians{joint};
      sample.near[i] = Radians{joint + (random.integer(0, 1) ? 0.01 : -0.01)};
      sample.far[i] = Radians{0.5 * (axis.min_rad + axis.max_rad)};
    }
    sample.theta = theta_of(robot.arm, sample.joints);
    sample.theta_near = theta_of(robot.arm, sample.near);
    sample.theta_far = theta_of(robot.arm, sample.far);
    sample.pose = arm.forward(sample.joints);
    sample.kdl_pose = to_kdl(sample.pose);
  }
  return samples;
}

const std::vector<Sample>& six_axis() {
  static const std::vector<Sample> samples = six_axis_samples();
  return samples;
}

bool close(const Transform& a, const Transform& b) {
  const Eigen::Matrix3d turn = a.rotation.transpose() * b.rotation;
  const Eigen::Vector3d axis{turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)};
  return (a.position_mm - b.position_mm).norm() < kClose_mm && std::atan2(axis.norm(), turn.trace() - 1.0) < kClose_rad;
}

// Whether every branch, and at least one, gives the pose back.
template <class Family>
bool all_give(const Family& arm, const RawSolutions& all, const Transform& pose) {
  return all.count > 0 && std::all_of(all.branches.begin(), all.branches.begin() + all.count,
                                      [&](const RawBranch& branch) { return close(arm.forward(branch.theta), pose); });
}

// Runs `work` on one sample an iteration, in turn.
template <class Samples, class Work>
void run(benchmark::State& state, const Samples& samples, Work work) {
  std::size_t i = 0;
  for (auto _ : state) {
    work(samples[i]);
    if (++i == samples.size()) i = 0;
  }
}

// Share, or mean, of `value` over all samples; outside the timed loop.
template <class Samples, class Value>
double mean(const Samples& samples, Value value) {
  double sum = 0.0;
  for (const auto& sample : samples) sum += static_cast<double>(value(sample));
  return sum / static_cast<double>(samples.size());
}

void six_forward(benchmark::State& state) {
  const SixR arm{irb_120().arm};
  run(state, six_axis(), [&](const Sample& sample) { benchmark::DoNotOptimize(arm.forward(sample.theta)); });
}

void six_inverse(benchmark::State& state) {
  const SixR arm{irb_120().arm};
  run(state, six_axis(),
      [&](const Sample& sample) { benchmark::DoNotOptimize(arm.inverse(sample.pose, sample.theta_far)); });
  state.counters["solutions"] =
      mean(six_axis(), [&](const Sample& s) { return arm.inverse(s.pose, s.theta_far).count; });
  state.counters["found"] =
      mean(six_axis(), [&](const Sample& s) { return all_give(arm, arm.inverse(s.pose, s.theta_far), s.pose); });
}

void arm_inverse(benchmark::State& state) {
  const Arm arm{irb_120()};
  run(state, six_axis(), [&](const Sample& sample) { benchmark::DoNotOptimize(arm.inverse(sample.pose, sample.far)); });
  state.counters["solutions"] = mean(six_axis(), [&](const Sample& s) { return arm.inverse(s.pose, s.far).count; });
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    const IkSolutions all = arm.inverse(s.pose, s.far);
    return solved(all.status) &&
           close(arm.forward(all.branches[static_cast<std::size_t>(all.selected)].joints), s.pose);
  });
}

// The IRB 120 in the lengths of the paper. Its joint 3 counts from the upright forearm.
void opw_inverse(benchmark::State& state) {
  constexpr bench::OpwLengths kLengths{.a1 = 0, .a2 = -70, .b = 0, .c1 = 290, .c2 = 270, .c3 = 302, .c4 = 72};
  const Arm arm{irb_120()};
  run(state, six_axis(),
      [&](const Sample& sample) { benchmark::DoNotOptimize(bench::opw_inverse(kLengths, sample.pose)); });
  state.counters["solutions"] = 8.0;
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    return std::ranges::all_of(bench::opw_inverse(kLengths, s.pose), [&](const std::array<double, 6>& theta) {
      JointAngles joints = make_per_axis([&](std::size_t i) { return Radians{theta[i]}; });
      joints[2] -= Radians{90 * kDeg};
      return close(arm.forward(joints), s.pose);
    });
  });
}

void arm_track(benchmark::State& state) {
  const Arm arm{irb_120()};
  run(state, six_axis(), [&](const Sample& sample) { benchmark::DoNotOptimize(arm.track(sample.pose, sample.near)); });
  state.counters["solutions"] = 1.0;
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    const IkTracking one = arm.track(s.pose, s.near);
    return solved(one.status) && close(arm.forward(one.joints), s.pose);
  });
}

bench::KdlArm kdl_irb_120() {
  const RobotModel robot = irb_120();
  const ArmGeometry& arm = robot.arm;
  bench::KdlArmModel model;
  model.a_mm = {arm.a1_mm, arm.a2_mm, arm.a3_mm, 0, 0, 0};
  model.alpha_rad = {90 * kDeg, 0, 90 * kDeg, -90 * kDeg, 90 * kDeg, 0};
  model.d_mm = {arm.d1_mm, 0, 0, arm.d4_mm, 0, arm.d6_mm};
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double a = arm.sign[i] * robot.axes[i].min_rad + arm.offset_rad[i];
    const double b = arm.sign[i] * robot.axes[i].max_rad + arm.offset_rad[i];
    model.lowest_rad[i] = std::min(a, b);
    model.highest_rad[i] = std::max(a, b);
  }
  return bench::KdlArm{model};
}

void kdl_forward(benchmark::State& state) {
  bench::KdlArm kdl = kdl_irb_120();
  bench::KdlPose pose{};
  run(state, six_axis(), [&](const Sample& sample) {
    kdl.forward(sample.theta, pose);
    benchmark::DoNotOptimize(pose);
  });
}

using KdlInverse = bool (bench::KdlArm::*)(const bench::KdlPose&, const Theta& start, Theta& found);

void kdl_inverse(benchmark::State& state, KdlInverse inverse, Theta Sample::*start) {
  bench::KdlArm kdl = kdl_irb_120();
  const SixR arm{irb_120().arm};
  Theta found{};
  run(state, six_axis(), [&](const Sample& sample) {
    (kdl.*inverse)(sample.kdl_pose, sample.*start, found);
    benchmark::DoNotOptimize(found);
  });
  state.counters["solutions"] = 1.0;
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    return (kdl.*inverse)(s.kdl_pose, s.*start, found) && close(arm.forward(found), s.pose);
  });
}

struct FiveAxisSample {
  Theta theta{};
  Transform pose{};
};

const std::vector<FiveAxisSample>& five_axis() {
  static const std::vector<FiveAxisSample> samples = [] {
    const FiveR arm{hu_2012()};
    test::Random random{kSeed};
    std::vector<FiveAxisSample> made(kPoses);
    for (FiveAxisSample& sample : made) {
      for (std::size_t i = 0; i < 5; ++i) sample.theta[i] = random.real(-std::numbers::pi, std::numbers::pi);
      sample.pose = arm.forward(sample.theta);
    }
    return made;
  }();
  return samples;
}

void five_inverse(benchmark::State& state) {
  const FiveR arm{hu_2012()};
  run(state, five_axis(), [&](const FiveAxisSample& s) { benchmark::DoNotOptimize(arm.inverse(s.pose, Theta{})); });
  state.counters["solutions"] =
      mean(five_axis(), [&](const FiveAxisSample& s) { return arm.inverse(s.pose, Theta{}).count; });
  state.counters["found"] =
      mean(five_axis(), [&](const FiveAxisSample& s) { return all_give(arm, arm.inverse(s.pose, Theta{}), s.pose); });
}

void five_track(benchmark::State& state) {
  const FiveR arm{hu_2012()};
  run(state, five_axis(), [&](const FiveAxisSample& s) { benchmark::DoNotOptimize(arm.track(s.pose, s.theta)); });
  state.counters["solutions"] = 1.0;
  state.counters["found"] = mean(five_axis(), [&](const FiveAxisSample& s) {
    const RawTracking one = arm.track(s.pose, s.theta);
    return solved(one.status) && close(arm.forward(one.theta), s.pose);
  });
}

constexpr const char* kSixForward = "SixR forward";
constexpr const char* kSixInverse = "SixR inverse, all";
constexpr const char* kArmInverse = "Arm inverse, all, limits, choice";
constexpr const char* kOpwInverse = "OPW inverse, all";
constexpr const char* kArmTrack = "Arm track";
constexpr const char* kKdlForward = "KDL forward";
constexpr const char* kKdlNewtonNear = "KDL NR_JL near";
constexpr const char* kKdlNewtonFar = "KDL NR_JL far";
constexpr const char* kKdlLmaNear = "KDL LMA near";
constexpr const char* kKdlLmaFar = "KDL LMA far";

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names;
  const auto add = [&names](const char* name, auto function, auto... arguments) {
    names.emplace_back(name);
    benchmark::RegisterBenchmark(name, function, arguments...)->Repetitions(5)->MinTime(0.05);
  };
  add(kSixForward, six_forward);
  add(kKdlForward, kdl_forward);
  add(kSixInverse, six_inverse);
  add(kArmInverse, arm_inverse);
  add(kOpwInverse, opw_inverse);
  add(kArmTrack, arm_track);
  add(kKdlNewtonNear, kdl_inverse, &bench::KdlArm::newton, &Sample::theta_near);
  add(kKdlLmaNear, kdl_inverse, &bench::KdlArm::levenberg_marquardt, &Sample::theta_near);
  add(kKdlNewtonFar, kdl_inverse, &bench::KdlArm::newton, &Sample::theta_far);
  add(kKdlLmaFar, kdl_inverse, &bench::KdlArm::levenberg_marquardt, &Sample::theta_far);
  add("FiveR inverse, all", five_inverse);
  add("FiveR track", five_track);

  return bench::run_benchmarks(
      argc, argv, fmt::format("{} poses, seed {}, smallest processor time of all repetitions", kPoses, kSeed),
      {.names = names,
       .counters = {{"solutions", 3}, {"found", 3}},
       .ratios = {{kSixInverse, kOpwInverse},
                  {kArmInverse, kOpwInverse},
                  {kKdlForward, kSixForward},
                  {kKdlNewtonNear, kArmTrack},
                  {kKdlLmaNear, kArmTrack},
                  {kKdlNewtonFar, kArmInverse},
                  {kKdlLmaFar, kArmInverse}}});
}
