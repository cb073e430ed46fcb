// What a pose costs: the closed forms beside Orocos KDL's iterations and, if the build has it, beside the library
// opw_kinematics, on the same random poses of an ABB IRB 120 (and of the arm of Hu 2012 for five joints), in one
// process.
//
// Each figure is the smallest processor time of several repetitions, which alternate, so that other load on the machine
// hardly matters. `solutions` is the mean number of solutions of a pose. `found` is the share of poses solved within 1
// um and 1e-5 rad: by all solutions, or by the one chosen. KDL finds one solution; "near" it starts 0.01 rad from it in
// every joint (a path), "far" in the middle of the joints' ranges (any move). Arm includes limits, vendor angles and
// the choice of a branch, for previous joints within 0.5 rad in every joint ("around") or anywhere within the limits;
// SixR and FiveR are the closed forms alone. usage: kinematics_bench [--benchmark_...]
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
#include "tests/bench/kinematics_samples.hpp"
#include "tests/bench/opw_arm.hpp"

namespace {

using namespace armature;
using bench::all_give;
using bench::close;
using bench::hu_2012;
using bench::irb_120;
using bench::kDeg;
using bench::kPoses;
using bench::kSeed;
using bench::mean;
using bench::run;
using bench::Sample;
using bench::six_axis;

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

void arm_inverse(benchmark::State& state, JointAngles Sample::*previous) {
  const Arm arm{irb_120()};
  run(state, six_axis(),
      [&](const Sample& sample) { benchmark::DoNotOptimize(arm.inverse(sample.pose, sample.*previous)); });
  state.counters["solutions"] =
      mean(six_axis(), [&](const Sample& s) { return arm.inverse(s.pose, s.*previous).count; });
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    const IkSolutions all = arm.inverse(s.pose, s.*previous);
    return solved(all.status) &&
           close(arm.forward(all.branches[static_cast<std::size_t>(all.selected)].joints), s.pose);
  });
}

void arm_soonest(benchmark::State& state, JointAngles Sample::*previous) {
  const Arm arm{irb_120()};
  run(state, six_axis(),
      [&](const Sample& sample) { benchmark::DoNotOptimize(arm.soonest(sample.pose, sample.*previous)); });
  state.counters["solutions"] = 1.0;
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    const IkTracking one = arm.soonest(s.pose, s.*previous);
    return solved(one.status) && close(arm.forward(one.joints), s.pose);
  });
}

#ifdef ARMATURE_OPW
bench::OpwArm opw_samples() {
  bench::OpwArm opw;
  for (const Sample& sample : six_axis()) {
    opw.add(make_per_axis([&](std::size_t axis) { return sample.joints[axis].value(); }));
  }
  return opw;
}

template <class Work>
void run_opw(benchmark::State& state, Work work) {
  const bench::OpwArm opw = opw_samples();
  std::size_t i = 0;
  for ([[maybe_unused]] auto iteration : state) {
    work(opw, i);
    if (++i == kPoses) i = 0;
  }
}

void opw_forward(benchmark::State& state) {
  run_opw(state, [](const bench::OpwArm& opw, std::size_t i) { opw.forward(i); });
}

void opw_inverse(benchmark::State& state) {
  run_opw(state, [](const bench::OpwArm& opw, std::size_t i) { benchmark::DoNotOptimize(opw.inverse(i)); });
  const bench::OpwArm opw = opw_samples();
  const Arm arm{irb_120()};
  std::size_t i = 0;
  state.counters["solutions"] = 8.0;
  state.counters["found"] = mean(six_axis(), [&](const Sample& s) {
    return std::ranges::all_of(opw.inverse(i++), [&](const std::array<double, 6>& rad) {
      return close(arm.forward(make_per_axis([&](std::size_t axis) { return Radians{rad[axis]}; })), s.pose);
    });
  });
}
#endif

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
constexpr const char* kArmInverseAround = "Arm inverse, all, around";
constexpr const char* kArmInverse = "Arm inverse, all, anywhere";
constexpr const char* kArmSoonestAround = "Arm soonest, around";
constexpr const char* kArmSoonest = "Arm soonest, anywhere";
constexpr const char* kOpwInverse = "opw_kinematics inverse, all";
constexpr const char* kOpwForward = "opw_kinematics forward";
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
  add(kArmInverseAround, arm_inverse, &Sample::around);
  add(kArmInverse, arm_inverse, &Sample::anywhere);
  add(kArmSoonestAround, arm_soonest, &Sample::around);
  add(kArmSoonest, arm_soonest, &Sample::anywhere);
#ifdef ARMATURE_OPW
  add(kOpwForward, opw_forward);
  add(kOpwInverse, opw_inverse);
#endif
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
                  {kArmInverseAround, kOpwInverse},
                  {kArmInverse, kOpwInverse},
                  {kArmSoonestAround, kOpwInverse},
                  {kArmSoonest, kOpwInverse},
                  {kOpwForward, kSixForward},
                  {kKdlForward, kSixForward},
                  {kKdlNewtonNear, kArmTrack},
                  {kKdlLmaNear, kArmTrack},
                  {kKdlNewtonFar, kArmInverse},
                  {kKdlLmaFar, kArmInverse}}});
}
