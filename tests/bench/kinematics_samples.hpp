// The poses of the benchmark `kinematics`, and how its lines run over them.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/kinematics/arm.hpp"
#include "tests/bench/bench_arms.hpp"
#include "tests/bench/kdl_arm.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::bench {

inline constexpr std::size_t kPoses = 1000;
inline constexpr std::uint64_t kSeed = 120;
inline constexpr double kClose_mm = 1e-3;
inline constexpr double kClose_rad = 1e-5;

inline KdlPose to_kdl(const Transform& pose) {
  KdlPose rows{};
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      rows[static_cast<std::size_t>(4 * row + column)] = pose.rotation(row, column);
    }
    rows[static_cast<std::size_t>(4 * row + 3)] = pose.position_mm[row];
  }
  return rows;
}

inline Theta theta_of(const ArmGeometry& arm, const JointAngles& joints) {
  return make_per_axis([&](std::size_t i) { return arm.sign[i] * joints[i].value() + arm.offset_rad[i]; });
}

struct Sample {
  JointAngles joints{}, near{}, far{};
  JointAngles around{}, anywhere{};  // random: within 0.5 rad, and within the limits
  Theta theta{}, theta_near{}, theta_far{}, theta_anywhere{};
  Transform pose{};
  KdlPose kdl_pose{};
};

inline std::vector<Sample> six_axis_samples() {
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
      sample.around[i] = Radians{std::clamp(joint + random.real(-0.5, 0.5), axis.min_rad, axis.max_rad)};
      sample.anywhere[i] = Radians{random.real(axis.min_rad, axis.max_rad)};
    }
    sample.theta = theta_of(robot.arm, sample.joints);
    sample.theta_near = theta_of(robot.arm, sample.near);
    sample.theta_far = theta_of(robot.arm, sample.far);
    sample.theta_anywhere = theta_of(robot.arm, sample.anywhere);
    sample.pose = arm.forward(sample.joints);
    sample.kdl_pose = to_kdl(sample.pose);
  }
  return samples;
}

inline const std::vector<Sample>& six_axis() {
  static const std::vector<Sample> samples = six_axis_samples();
  return samples;
}

inline bool close(const Transform& a, const Transform& b) {
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

}  // namespace armature::bench
