// Judges set-points of a Cartesian motion by themselves: limits, branch, path, end. Uses forward kinematics and the
// requests; of the inverse and the planner only the answers that are on trial. Each judgement is what is wrong first,
// and where, or nothing.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "controller/kinematics/arm.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/path_follower.hpp"
#include "tests/controller/support/path_oracle.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random_chains.hpp"

namespace armature::test {

class SetPointJudge {
 public:
  SetPointJudge(const RandomChain& chain, const Arm& arm)
      : chain_{chain}, arm_{arm}, path_{arm.forward(chain.start) * chain.tool, chain.requests} {}

  // `slack`: what rounding may exceed limits by. `with_jerk`: every law is an S-curve and the rate is constant.
  // Set-points begin and end with the arm at rest. `with_tool`: the tool's own limits hold, as they do but in a stop.
  // `to_the_end`: the motion was not stopped before.
  struct Ask {
    bool with_jerk = false;
    double slack = 0.0;
    bool with_tool = true;
    bool to_the_end = true;
  };
  [[nodiscard]] std::string judge(const std::vector<JointAngles>& joints, const Ask& ask) const {
    std::string wrong = joint_limits(joints, ask.with_jerk, ask.slack);
    if (wrong.empty()) wrong = branch(joints);
    if (wrong.empty()) wrong = tool(joints, ask.with_tool, ask.to_the_end);
    return wrong;
  }

  [[nodiscard]] std::string joint_limits(const std::vector<JointAngles>& joints, bool with_jerk, double slack) const {
    const JointPeaks peaks = joint_peaks(chain_.robot, joints);
    if (!(peaks.speed <= 1.0 + slack)) return "joint speed " + std::to_string(peaks.speed);
    if (!(peaks.accel <= 1.0 + slack)) {
      return "joint acceleration " + std::to_string(peaks.accel) + " of axis " + std::to_string(peaks.accel_axis) +
             at(peaks.accel_at);
    }
    if (with_jerk && !(peaks.jerk <= 1.0 + slack)) return "joint jerk " + std::to_string(peaks.jerk);
    return {};
  }

  // A path cannot go from one solution of the inverse to another but through a singularity, and of those only the
  // wrist's is passed.
  [[nodiscard]] std::string branch(const std::vector<JointAngles>& joints) const {
    const double elbow_before = elbow(joints[0]), shoulder_before = shoulder(joints[0]);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const JointAngles& q = joints[k];
      if (!(elbow(q) * elbow_before > 0.0)) return "elbow" + at(k);
      if (!(shoulder(q) * shoulder_before > 0.0)) return "shoulder" + at(k);
      for (std::size_t i = 0; i < chain_.robot.axis_count; ++i) {
        const AxisModel& axis = chain_.robot.axes[i];
        const bool inside = q[i].value() >= axis.min_rad - 1e-9 && q[i].value() <= axis.max_rad + 1e-9;
        if (!inside) return "joint range" + at(k);
      }
    }
    return {};
  }

  // The last set-point: the pose that was asked for, to half a pulse of every drive.
  [[nodiscard]] std::string end(const JointAngles& last) const {
    const Transform asked = path_.end() * inverse(chain_.tool);
    const Transform tool = arm_.forward(last) * chain_.tool;
    if (!((tool.position_mm - path_.end().position_mm).norm() < 1e-8)) return "end position";
    if (six() && !((arm_.forward(last).rotation - asked.rotation).cwiseAbs().maxCoeff() < PathFollower::kRotation)) {
      return "end rotation";
    }
    if (!chain_.exact) {
      const Eigen::Matrix3d miss = tool.rotation * path_.end().rotation.transpose();
      return Eigen::AngleAxisd{miss}.angle() <= chain_.robot.arm.max_projection_rad ? "" : "end projection";
    }
    const IkSolutions all = arm_.inverse(asked, last);
    if (all.count == 0) return "end unreachable";
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
      const double pulses = units.to_exact_pulses(wanted[i]);
      const bool half = std::fabs(units.to_exact_pulses(last[i]) - pulses) < 0.5 &&
                        std::fabs(static_cast<double>(units.to_pulses(last[i]).value()) - pulses) <= 0.5 + 1e-3;
      if (!half) return "end pulses of axis " + std::to_string(i + 1);
    }
    return {};
  }

  // The tool's limits, those of the move where a set-point is within one, and the path.
  [[nodiscard]] std::string tool(const std::vector<JointAngles>& joints, bool limits, bool to_the_end = true) const {
    PathFollower follower{path_, six(), chain_.most.accel_mm_s2 * kTickSeconds * kTickSeconds};
    std::vector<Motion> steps;
    std::vector<PathFollower::Place> places;
    Transform last{};
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Transform now = arm_.forward(joints[k]) * chain_.tool;
      const auto place = follower.go_to(now);
      if (!place) return "path" + at(k);
      places.push_back(*place);
      steps.push_back(k == 0 ? Motion{} : motion(last, now, joints[k - 1], joints[k]));
      last = now;
      if (k < 2) continue;
      const PathLimits most = limits_around(places[k - 2], places[k - 1], *place);
      const std::string wrong = beyond(steps[k - 1], steps[k], most, limits);
      if (!wrong.empty()) return wrong + at(k);
    }
    return to_the_end && !follower.at_end() ? "path left out" : "";
  }

 private:
  // In a rounded corner the planner lets the tool exceed its limits by a thousandth.
  static constexpr double kTool = 1.002;

  [[nodiscard]] bool six() const { return chain_.robot.arm.family == ArmFamily::kSixR; }
  [[nodiscard]] double theta(const JointAngles& joints, std::size_t i) const {
    return chain_.robot.arm.sign[i] * joints[i].value() + chain_.robot.arm.offset_rad[i];
  }

  // What tells one solution of the inverse from another, from the Denavit-Hartenberg angles.
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

  // Of the tool in a tick, per second. Five joints turn the tool in space or change pitch and roll steadily, and the
  // limits are about the one that they do.
  struct Motion {
    Eigen::Vector3d move_mm_s = Eigen::Vector3d::Zero(), turn_rad_s = Eigen::Vector3d::Zero();
    Eigen::Vector2d in_plane_rad_s = Eigen::Vector2d::Zero();
  };
  [[nodiscard]] Motion motion(const Transform& from, const Transform& to, const JointAngles& before,
                              const JointAngles& after) const {
    // From the matrix: a quaternion has lost half the digits of so small a turn.
    const Eigen::Matrix3d m = to.rotation * from.rotation.transpose();
    const Eigen::Vector3d turn = 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    const auto pitch = [&](const JointAngles& q) { return theta(q, 1) + theta(q, 2) + theta(q, 3); };
    const Eigen::Vector2d in_plane{pitch(after) - pitch(before), theta(after, 4) - theta(before, 4)};
    return {(to.position_mm - from.position_mm) / kTickSeconds, turn / kTickSeconds, in_plane / kTickSeconds};
  }

  // Of the pieces that three successive set-points are on; in a corner of all.
  [[nodiscard]] PathLimits limits_around(const PathFollower::Place& a, const PathFollower::Place& b,
                                         const PathFollower::Place& c) const {
    if (a.in_corner || b.in_corner || c.in_corner) return chain_.most;
    PathLimits most = chain_.requests[a.first].limits;
    for (std::size_t i = a.first + 1; i <= c.last; ++i) {
      const PathLimits& own = chain_.requests[i].limits;
      most.speed_mm_s = std::max(most.speed_mm_s, own.speed_mm_s);
      most.accel_mm_s2 = std::max(most.accel_mm_s2, own.accel_mm_s2);
      most.turn_speed_rad_s = std::max(most.turn_speed_rad_s, own.turn_speed_rad_s);
      most.turn_accel_rad_s2 = std::max(most.turn_accel_rad_s2, own.turn_accel_rad_s2);
    }
    return most;
  }

  [[nodiscard]] std::string beyond(const Motion& before, const Motion& now, const PathLimits& most,
                                   bool accelerations) const {
    const auto over = [](const char* what, double size, double limit) {
      return size <= limit * kTool ? "" : what + std::to_string(size / limit);
    };
    const auto turning = [&](double in_space, double in_plane) {
      return six() ? in_space : std::min(in_space, in_plane);
    };
    std::string wrong = over("tool speed ", now.move_mm_s.norm(), most.speed_mm_s);
    if (wrong.empty()) {
      wrong = over("turn speed ", turning(now.turn_rad_s.norm(), now.in_plane_rad_s.norm()), most.turn_speed_rad_s);
    }
    if (!wrong.empty() || !accelerations) return wrong;
    const auto accel = [](const auto& a, const auto& b) { return (b - a).norm() / kTickSeconds; };
    wrong = over("tool acceleration ", accel(before.move_mm_s, now.move_mm_s), most.accel_mm_s2);
    if (!wrong.empty()) return wrong;
    return over("turn acceleration ",
                turning(accel(before.turn_rad_s, now.turn_rad_s), accel(before.in_plane_rad_s, now.in_plane_rad_s)),
                most.turn_accel_rad_s2);
  }

  [[nodiscard]] static std::string at(std::size_t k) { return " at set-point " + std::to_string(k); }

  const RandomChain& chain_;
  const Arm& arm_;
  IdealPath path_;
};

}  // namespace armature::test
