// Lines that pass a pose, and judgements of their set-points by forward kinematics in long double that are written
// here.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

inline constexpr double kTolerance_rad = 5 * kDeg;
inline constexpr PathLimits kWalk{.speed_mm_s = 100.0,
                                  .accel_mm_s2 = 1'000.0,
                                  .jerk_mm_s3 = 20'000.0,
                                  .turn_speed_rad_s = 1.5,
                                  .turn_accel_rad_s2 = 15.0,
                                  .turn_jerk_rad_s3 = 300.0};
inline const Transform kSkewTool{.rotation = rotation_from_rpy(0.1, -0.2, 0.3), .position_mm = {15, -10, 60}};

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;
using RealMatrix = Eigen::Matrix<Real, 3, 3>;

struct RealPose {
  RealMatrix rotation = RealMatrix::Identity();
  RealVector position = RealVector::Zero();
};

// The six links of Vo 2021 Table 2, multiplied one by one.
inline RealPose tool_of(const RobotModel& robot, const JointAngles& joints, const Transform& tool) {
  const ArmGeometry& g = robot.arm;
  const std::array<Real, 6> a{g.a1_mm, g.a2_mm, g.a3_mm, 0, 0, 0}, d{g.d1_mm, 0, 0, g.d4_mm, 0, g.d6_mm};
  const std::array<int, 6> twist{1, 0, 1, -1, 1, 0};  // sine of alpha
  RealPose pose;
  const auto move = [&pose](const RealMatrix& rotation, const RealVector& position) {
    pose.position += pose.rotation * position;
    pose.rotation = pose.rotation * rotation;
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const Real theta = Real{g.sign[i]} * Real{joints[i].value()} + Real{g.offset_rad[i]};
    const Real c = std::cos(theta), s = std::sin(theta), sa = twist[i], ca = twist[i] == 0 ? 1 : 0;
    RealMatrix link;
    link << c, -s * ca, s * sa, s, c * ca, -c * sa, 0, sa, ca;
    move(link, {a[i] * c, a[i] * s, d[i]});
  }
  move(tool.rotation.cast<Real>(), tool.position_mm.cast<Real>());
  return pose;
}

struct Passage {
  JointAngles start{};
  SegmentRequest request{};
};

// A line of twice `along_mm` that passes beside the pose of `singular` in its middle, with a constant orientation.
inline Passage pass(const PathRig& rig, const JointAngles& singular, const Eigen::Vector3d& along_mm,
                    const Eigen::Vector3d& aside, double miss_mm, AtSingularity mode,
                    ProfileKind profile = ProfileKind::kTrapezoid) {
  const Transform middle = rig.tool_at(singular);
  const Eigen::Vector3d centre = middle.position_mm + miss_mm * aside.normalized();
  const Transform from{middle.rotation, centre - along_mm};
  const IkSolutions solutions = rig.arm.inverse(from * inverse(rig.flange_T_tool), singular);
  EXPECT_GE(solutions.selected, 0);
  Passage result{.request = line_to({middle.rotation, centre + along_mm}, kWalk, 0.0, profile)};
  if (solutions.selected >= 0) result.start = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
  result.request.at_singularity = mode;
  result.request.orientation_tolerance_rad = kTolerance_rad;
  return result;
}

struct Deviation {
  double beside_mm = 0.0;  // of the tool point from the line
  double turned_rad = 0.0;
};

inline Deviation deviation_of(const PathRig& rig, const std::vector<JointAngles>& joints, const SegmentRequest& line) {
  const RealPose first = tool_of(rig.robot, joints.front(), rig.flange_T_tool);
  const RealVector end = line.target.position_mm.cast<Real>(), along = (end - first.position).normalized();
  const RealMatrix wanted = line.target.rotation.cast<Real>();
  Deviation worst;
  for (const JointAngles& q : joints) {
    const RealPose tool = tool_of(rig.robot, q, rig.flange_T_tool);
    const RealVector away = tool.position - first.position;
    worst.beside_mm = std::max(worst.beside_mm, static_cast<double>((away - along.dot(away) * along).norm()));
    const Real half_sine = (tool.rotation - wanted).norm() / (2 * std::sqrt(Real{2}));
    worst.turned_rad = std::max(worst.turned_rad, static_cast<double>(2 * std::asin(half_sine)));
  }
  return worst;
}

// The largest differences of the tool over ticks, position and rotation, as shares of the limits: speed, acceleration
// and jerk. From the set-points of the joints, so that a deviation of the orientation counts.
struct HandPeaks {
  std::array<Real, 3> move{}, turn{};
};

inline HandPeaks hand_peaks(const PathRig& rig, const std::vector<JointAngles>& joints, const PathLimits& limits) {
  const std::array<Real, 3> move_limits{limits.speed_mm_s, limits.accel_mm_s2, limits.jerk_mm_s3};
  const std::array<Real, 3> turn_limits{limits.turn_speed_rad_s, limits.turn_accel_rad_s2, limits.turn_jerk_rad_s3};
  constexpr Real kTick = 50e-6L;
  HandPeaks peaks;
  std::array<RealVector, 3> move, turn;  // differences of the last set-points, by order
  move.fill(RealVector::Zero());
  turn.fill(RealVector::Zero());
  const auto add = [](std::array<RealVector, 3>& last, std::array<Real, 3>& most, const std::array<Real, 3>& limit,
                      RealVector difference) {
    Real tick = kTick;
    for (std::size_t order = 0; order < 3; ++order, tick *= kTick) {
      most[order] = std::max(most[order], difference.norm() / tick / limit[order]);
      const RealVector before = last[order];
      last[order] = difference;
      difference -= before;
    }
  };
  RealPose before = tool_of(rig.robot, joints.front(), rig.flange_T_tool);
  for (const JointAngles& q : joints) {
    const RealPose tool = tool_of(rig.robot, q, rig.flange_T_tool);
    const RealMatrix m = tool.rotation * before.rotation.transpose();
    add(move, peaks.move, move_limits, tool.position - before.position);
    add(turn, peaks.turn, turn_limits, Real{0.5} * RealVector{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)});
    before = tool;
  }
  return peaks;
}

}  // namespace armature::test
