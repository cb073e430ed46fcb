// Paths whose S-curves are compared with the fastest motion that an oracle finds (jerk_oracle.hpp).
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/topp_cases.hpp"

namespace armature::test {

struct JerkCase {
  std::string name;
  RobotModel robot;
  JointAngles start;
  std::vector<SegmentRequest> chain;
};

// An IRB 120 whose joints 4 and 6 can turn more than once.
inline RobotModel turning_irb120() {
  RobotModel robot = irb120();
  robot.axes[3].min_rad = robot.axes[5].min_rad = -7.0, robot.axes[3].max_rad = robot.axes[5].max_rad = 7.0;
  return robot;
}

inline JerkCase smooth(const std::string& name, const RobotModel& robot, const JointAngles& start,
                       std::vector<SegmentRequest> chain) {
  for (SegmentRequest& request : chain) request.profile = ProfileKind::kSCurve;
  return {name, robot, start, std::move(chain)};
}

inline JerkCase axis_1_at(double miss_mm) {
  const PathRig rig{irb120()};
  return smooth("axis 1 at " + std::to_string(miss_mm), turning_irb120(),
                joints_at(rig, down_from(rig, miss_mm, -150, 650)),
                {line_to(down_from(rig, miss_mm, 150, 650), kFast)});
}

// A line that misses the wrist singularity: joint 4 turns by half a revolution.
inline JerkCase wrist_at(double miss_mm) {
  const PathRig rig{turning_irb120()};
  const Transform from = moved(rig.tool_at(degrees({0, 0, 0, 0, 25, 0})), 0, miss_mm, 0);
  return smooth("wrist at " + std::to_string(miss_mm), rig.robot, joints_at(rig, from),
                {line_to(moved(from, 0, 0, -150), kFast)});
}

inline std::vector<SegmentRequest> zigzag() {
  std::vector<SegmentRequest> chain;
  Transform at = PathRig{irb120()}.tool_at(kReady);
  for (int i = 0; i < 12; ++i) {
    at = moved(at, i % 2 == 0 ? -10.0 : 10.0, 4.0, 0);
    chain.push_back(line_to(at, kFast, 0.5));
  }
  return chain;
}

// The paths of the cases without limits of jerk, and some more.
inline std::vector<JerkCase> jerk_cases() {
  std::vector<JerkCase> cases;
  for (const ToppCase& path : topp_cases()) cases.push_back(smooth(path.name, path.robot, path.start, path.chain));
  cases.push_back(axis_1_at(5.0));
  cases.push_back(smooth("zigzag", irb120(), kReady, zigzag()));
  cases.push_back(smooth("fourteen lines of 1 mm", irb120(), kReady, fourteen_lines()));
  for (const double length_mm : {0.1, 10.0, 200.0}) {
    const PathRig rig{irb120()};
    cases.push_back(smooth("line of " + std::to_string(length_mm), irb120(), kReady,
                           {line_to(moved(rig.tool_at(kReady), 0, length_mm, 0), kFast)}));
  }
  for (const double miss_mm : {3.0, 0.5, 0.1}) cases.push_back(wrist_at(miss_mm));
  return cases;
}

// A random chain of 2 to 8 lines and arcs, from 1 to 60 mm, with blends, whose tool turns a little.
inline JerkCase random_jerk_case(std::uint64_t seed) {
  Random random{seed};
  const PathRig rig{irb120()};
  const double pace = std::exp(random.real(std::log(0.1), std::log(1.0)));
  const PathLimits limits{.speed_mm_s = 1'000.0 * pace,
                          .accel_mm_s2 = 10'000.0 * pace,
                          .jerk_mm_s3 = 1e6 * pace * std::exp(random.real(std::log(0.2), std::log(2.0))),
                          .turn_speed_rad_s = 10.0,
                          .turn_accel_rad_s2 = 100.0,
                          .turn_jerk_rad_s3 = 1e4};
  const auto vector = [&random](double size) {
    Eigen::Vector3d v;
    for (double& x : v) x = random.real(-size, size);
    return v;
  };
  const double size_mm = std::exp(random.real(std::log(1.0), std::log(60.0)));
  JointAngles start = kReady;
  for (std::size_t axis = 0; axis < kAxes; ++axis) start[axis] = Radians{start[axis].value() + random.real(-0.3, 0.3)};
  Transform at = rig.tool_at(start);
  const Eigen::Vector3d center = at.position_mm;
  std::vector<SegmentRequest> chain;
  const std::int64_t count = random.integer(2, 8);
  for (std::int64_t i = 0; i < count; ++i) {
    const Eigen::Vector3d way = vector(size_mm), via = vector(0.6 * size_mm);
    const double turn = random.real(0.0, 0.1), blend = size_mm * random.real(0.01, 0.2);
    const bool arc = random.integer(0, 3) == 0;
    Eigen::Vector3d to = at.position_mm + way;
    if ((to - center).norm() > 80.0) to = center + way;
    const Eigen::Vector3d from = at.position_mm;
    at = turned_by({at.rotation, to}, turn, vector(1.0));
    chain.push_back(arc ? arc_to(0.5 * (from + to) + via, at, limits, blend) : line_to(at, limits, blend));
  }
  return smooth("random " + std::to_string(seed), irb120(), start, std::move(chain));
}

}  // namespace armature::test
