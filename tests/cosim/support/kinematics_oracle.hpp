// The arm of a robot file as an Orocos KDL chain, from the numbers of the file alone.
#pragma once

#include <filesystem>
#include <kdl/chain.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::cosim::test {

inline const std::filesystem::path kRobotFolder = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios/robots";
inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;

inline RobotSpec load_project_robot(const std::string& name) {
  return load_robot(kRobotFolder / (name + ".toml"));
}

// The robots of the project whose files have [kinematics].
inline std::vector<std::string> arms() {
  std::vector<std::string> names;
  for (const std::string& name : list_robots(kRobotFolder)) {
    if (load_project_robot(name).kinematics) names.push_back(name);
  }
  return names;
}

// Standard Denavit-Hartenberg rows of Vo 2021 Table 2 and Hu 2012 Table 1; theta = sign * q + offset.
inline KDL::Chain kdl_chain(const KinematicsSpec& arm) {
  struct Row {
    double a_mm, alpha_deg, d_mm;
  };
  const std::vector<Row> six_r{{arm.a1_mm, 90, arm.d1_mm}, {arm.a2_mm, 0, 0}, {arm.a3_mm, 90, 0},
                               {0, -90, arm.d4_mm},        {0, 90, 0},        {0, 0, arm.d6_mm}};
  const std::vector<Row> five_r{
      {arm.a1_mm, -90, 0}, {arm.a2_mm, 0, 0}, {arm.a3_mm, 0, 0}, {arm.a4_mm, -90, 0}, {0, 0, arm.d5_mm}};
  KDL::Chain chain;
  std::size_t joint = 0;
  for (const Row& row : arm.family == "six_r" ? six_r : five_r) {
    // KDL measures a joint from where the segment's own frame has it: the offset belongs into that frame, not to the
    // joint.
    const double offset_rad = arm.offset_deg[joint] * kRadPerDeg;
    chain.addSegment(KDL::Segment{KDL::Joint{KDL::Joint::RotZ, arm.sign[joint]},
                                  KDL::Frame::DH(row.a_mm, row.alpha_deg * kRadPerDeg, row.d_mm, offset_rad)});
    ++joint;
  }
  return chain;
}

// Angles inside the limits, deg.
inline PerAxis<double> random_joints_deg(armature::test::Random& random, const RobotSpec& robot) {
  PerAxis<double> deg{};
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    deg[i] = random.real(robot.axes[i].min_deg, robot.axes[i].max_deg);
  }
  return deg;
}

inline PerAxis<Radians> to_radians(const PerAxis<double>& deg) {
  return make_per_axis([&](std::size_t axis) { return Radians{deg[axis] * kRadPerDeg}; });
}

}  // namespace armature::cosim::test
