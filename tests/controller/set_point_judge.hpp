// Judges set-points of a Cartesian motion by themselves: limits, branch, path, end. Uses forward kinematics and the
// requests; of the inverse and the planner only the answers that are on trial.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "controller/kinematics/arm.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/path_oracle.hpp"
#include "tests/controller/path_rig.hpp"
#include "tests/controller/random_chains.hpp"

namespace armature::test {

class SetPointJudge {
 public:
  SetPointJudge(const RandomChain& chain, const Arm& arm)
      : chain_{chain}, arm_{arm}, path_{arm.forward(chain.start) * chain.tool, chain.requests} {}

  // `slack`: what rounding may exceed limits by. `with_jerk`: every law is an S-curve and the rate is constant.
  // Set-points begin and end with the arm at rest. `with_tool`: the tool's own limits hold, as they do but in a stop.
  void judge(const std::vector<JointAngles>& joints, bool with_jerk, double slack, bool with_tool = true) const {
    const JointPeaks peaks = joint_peaks(chain_.robot, joints);
    ASSERT_LE(peaks.speed, 1.0 + slack);
    ASSERT_LE(peaks.accel, 1.0 + slack) << "axis " << peaks.accel_axis << " at set-point " << peaks.accel_at;
    if (with_jerk) {
      ASSERT_LE(peaks.jerk, 1.0 + slack);
    }
    judge_branch(joints);
    if (testing::Test::HasFatalFailure()) return;
    judge_tool(joints, with_tool);
  }

  // The last set-point: the pose that was asked for, to half a pulse of every drive.
  void judge_end(const JointAngles& last) const {
    const Transform asked = path_.end() * inverse(chain_.tool);
    ASSERT_LT(((arm_.forward(last) * chain_.tool).position_mm - path_.end().position_mm).norm(), 1e-8);
    if (six()) {
      ASSERT_LT((arm_.forward(last).rotation - asked.rotation).cwiseAbs().maxCoeff(), kRotation);
    }
    if (!chain_.exact) {
      const Eigen::Matrix3d miss = (arm_.forward(last) * chain_.tool).rotation * path_.end().rotation.transpose();
      ASSERT_LE(Eigen::AngleAxisd{miss}.angle(), chain_.robot.arm.max_projection_rad);
      return;
    }
    const IkSolutions all = arm_.inverse(asked, last);
    ASSERT_GT(all.count, 0u);
    // The nearest one, whether or not rounding has it inside the limits.
    const auto distance = [&](const IkBranch& branch) {
      double most = 0.0;
      for (std::size_t i = 0; i < chain_.robot.axis_count; ++i) {
        most = std::max(most, std::fabs((branch.joints[i] - last[i]).value()));
      }
      return most;
    };
    const auto nearer = [&](const IkBranch& a, const IkBranch& b) { return distance(a) < distance(b); };
    const auto branches = std::span{all.branches}.first(all.count);
    const JointAngles& wanted = std::min_element(branches.begin(), branches.end(), nearer)->joints;
    // In the wrist singularity only the sum of joints 4 and 6 is determined.
    const bool free = six() && std::fabs(arm_.wrist_sine(last)) < 1e-6;
    for (std::size_t i = 0; i < chain_.robot.axis_count; ++i) {
      if (free && (i == 3 || i == 5)) continue;
      const AxisUnits units{chain_.robot.axes[i]};
      ASSERT_LT(std::fabs(units.to_exact_pulses(last[i]) - units.to_exact_pulses(wanted[i])), 0.5) << "axis " << i + 1;
      ASSERT_LE(std::fabs(static_cast<double>(units.to_pulses(last[i]).value()) - units.to_exact_pulses(wanted[i])),
                0.5 + 1e-3)
          << "axis " << i + 1;
    }
  }

 private:
  // Of rotation matrices; around the wrist singularity theta_4 is kept, which turns the tool by 1e-7 rad at most.
  static constexpr double kRotation = 2e-7;
  // The 1e-11 rad by which a path may miss the wrist singularity, times 1 m, and some more.
  static constexpr double kOnPath_mm = 1e-7;
  // In a rounded corner the planner lets the tool exceed its limits by a thousandth.
  static constexpr double kTool = 1.002;

  [[nodiscard]] bool six() const { return chain_.robot.arm.family == ArmFamily::kSixR; }
  [[nodiscard]] double theta(const JointAngles& joints, std::size_t i) const {
    return chain_.robot.arm.sign[i] * joints[i].value() + chain_.robot.arm.offset_rad[i];
  }

  // What tells one solution of the inverse from another, from the Denavit-Hartenberg angles. A path cannot go from one
  // to the other but through a singularity, and of those only the wrist's is passed.
  [[nodiscard]] double elbow(const JointAngles& q) const {
    const ArmGeometry& arm = chain_.robot.arm;
    return six() ? std::sin(theta(q, 2) - std::atan2(arm.d4_mm, arm.a3_mm)) : std::sin(theta(q, 2));
  }
  [[nodiscard]] double shoulder(const JointAngles& q) const {
    const ArmGeometry& arm = chain_.robot.arm;
    if (!six()) return 1.0;  // five joints pass axis 1 without one
    const double t23 = theta(q, 1) + theta(q, 2);
    return arm.a1_mm + arm.a2_mm * std::cos(theta(q, 1)) + arm.a3_mm * std::cos(t23) + arm.d4_mm * std::sin(t23);
  }
  void judge_branch(const std::vector<JointAngles>& joints) const {
    const double elbow_before = elbow(joints[0]), shoulder_before = shoulder(joints[0]);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const JointAngles& q = joints[k];
      ASSERT_GT(elbow(q) * elbow_before, 0.0) << "at set-point " << k;
      ASSERT_GT(shoulder(q) * shoulder_before, 0.0) << "at set-point " << k;
      for (std::size_t i = 0; i < chain_.robot.axis_count; ++i) {
        const AxisModel& axis = chain_.robot.axes[i];
        ASSERT_GE(q[i].value(), axis.min_rad - 1e-9) << "axis " << i + 1;
        ASSERT_LE(q[i].value(), axis.max_rad + 1e-9) << "axis " << i + 1;
      }
    }
  }

  void judge_tool(const std::vector<JointAngles>& joints, bool limits) const {
    std::vector<Transform> tool;
    tool.reserve(joints.size());
    for (const JointAngles& q : joints) tool.push_back(arm_.forward(q) * chain_.tool);
    const double ts = kTickSeconds;
    for (std::size_t k = 2; k < tool.size(); ++k) {
      const Eigen::Vector3d v = (tool[k].position_mm - tool[k - 1].position_mm) / ts;
      const Eigen::Vector3d before = (tool[k - 1].position_mm - tool[k - 2].position_mm) / ts;
      ASSERT_LE(v.norm(), chain_.most.speed_mm_s * kTool) << "at set-point " << k;
      if (limits) {
        ASSERT_LE((v - before).norm() / ts, chain_.most.accel_mm_s2 * kTool) << "at set-point " << k;
      }
      if (k % 3 != 0) continue;
      const IdealPath::Miss miss = path_.miss(tool[k].position_mm);
      ASSERT_LE(miss.distance_mm, std::max(miss.allowed_mm, kOnPath_mm)) << "at set-point " << k;
      if (six() && miss.allowed_mm == 0.0) judge_rotation(tool[k], k);
    }
  }

  // On a line, away from corners, the tool has turned by as much of its turn as it has covered of the line.
  void judge_rotation(const Transform& tool, std::size_t k) const {
    double least = std::numeric_limits<double>::infinity();
    for (const IdealPiece& piece : path_.pieces()) {
      if (!(piece.distance_mm(tool.position_mm) < kOnPath_mm)) continue;
      if (piece.round || piece.way_mm().norm() < 0.05) return;  // the share is not known
      const Eigen::Matrix3d ideal = piece.rotation(std::clamp(piece.share(tool.position_mm), 0.0, 1.0));
      least = std::min(least, (tool.rotation - ideal).cwiseAbs().maxCoeff());
    }
    ASSERT_LT(least, kRotation) << "at set-point " << k;
  }

  const RandomChain& chain_;
  const Arm& arm_;
  IdealPath path_;
};

}  // namespace armature::test
