// Arms and planning by one call for the tests of Cartesian paths.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "tests/controller/support/finish_plan.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature::test {

// ABB IRB 120 with the drives of paper_robot(); its data sheet has no accelerations and jerks, these are round numbers.
inline RobotModel irb120() {
  RobotModel robot = paper_robot();
  const PerAxis<double> low{-165, -110, -110, -160, -120, -400}, high{165, 110, 70, 160, 120, 400};
  const PerAxis<double> speed{250, 250, 250, 320, 320, 420};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    AxisModel& model = robot.axes[axis];
    model.min_rad = low[axis] * kDeg;
    model.max_rad = high[axis] * kDeg;
    model.max_speed_rad_s = speed[axis] * kDeg;
    model.max_accel_rad_s2 = 25.0 * speed[axis] * kDeg;
    model.max_jerk_rad_s3 = 1500.0 * speed[axis] * kDeg;
  }
  robot.arm = irb120_geometry();
  return robot;
}

// The arm of Hu 2012 ten times larger than its centimetres say, with the drives of irb120(). `max_projection_rad`: how
// far orientations may be changed into ones that five joints reach.
inline RobotModel hu2012(double max_projection_rad = 0.0) {
  RobotModel robot = irb120();
  robot.axis_count = 5;
  robot.axes[5] = {};
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    robot.axes[axis].min_rad = -170.0 * kDeg;
    robot.axes[axis].max_rad = 170.0 * kDeg;
  }
  robot.arm = {.family = ArmFamily::kFiveR,
               .a1_mm = 11.0,
               .a2_mm = 100.0,
               .a3_mm = 95.0,
               .a4_mm = 32.0,
               .d5_mm = 145.0,
               .max_projection_rad = max_projection_rad};
  return robot;
}

inline constexpr PathLimits kBrisk{.speed_mm_s = 800.0,
                                   .accel_mm_s2 = 8'000.0,
                                   .jerk_mm_s3 = 400'000.0,
                                   .turn_speed_rad_s = 4.0,
                                   .turn_accel_rad_s2 = 40.0,
                                   .turn_jerk_rad_s3 = 2'000.0};
// So slow that no joint comes near its limits away from singularities.
inline constexpr PathLimits kGentle{.speed_mm_s = 100.0,
                                    .accel_mm_s2 = 1'000.0,
                                    .jerk_mm_s3 = 20'000.0,
                                    .turn_speed_rad_s = 0.5,
                                    .turn_accel_rad_s2 = 5.0,
                                    .turn_jerk_rad_s3 = 100.0};

inline SegmentRequest line_to(const Transform& target, const PathLimits& limits, double blend_mm = 0.0,
                              ProfileKind profile = ProfileKind::kTrapezoid) {
  SegmentRequest request;
  request.target = target;
  request.limits = limits;
  request.profile = profile;
  request.blend_mm = blend_mm;
  return request;
}

inline SegmentRequest arc_to(const Eigen::Vector3d& via_mm, const Transform& target, const PathLimits& limits,
                             double blend_mm = 0.0, ProfileKind profile = ProfileKind::kTrapezoid) {
  SegmentRequest request = line_to(target, limits, blend_mm, profile);
  request.kind = SegmentRequest::Kind::kArc;
  request.via_mm = via_mm;
  return request;
}

inline SegmentRequest circle_through(const Eigen::Vector3d& second_mm, const Transform& third,
                                     const PathLimits& limits) {
  SegmentRequest request = arc_to(second_mm, third, limits);
  request.kind = SegmentRequest::Kind::kCircle;
  return request;
}

inline Transform moved(const Transform& from, double x_mm, double y_mm, double z_mm) {
  return {from.rotation, from.position_mm + Eigen::Vector3d{x_mm, y_mm, z_mm}};
}
// About an axis of the base frame, the tool centre point stays.
inline Transform turned_by(const Transform& from, double angle_rad, const Eigen::Vector3d& axis) {
  return {Eigen::AngleAxisd{angle_rad, axis.normalized()}.toRotationMatrix() * from.rotation, from.position_mm};
}

// Of irb120(): forearm forward, tool down, 302 mm in front, far from every singularity.
inline const JointAngles kReady = degrees({0, 0, 0, 0, 90, 0});

struct PathRig {
  explicit PathRig(const RobotModel& model, double max_stretch = PlanningConfig{}.max_stretch,
                   const Transform& tool = {})
      : robot{model}, flange_T_tool{tool}, planner{robot, arm, flange_T_tool, max_stretch} {}

  [[nodiscard]] Transform tool_at(const JointAngles& joints) const { return arm.forward(joints) * flange_T_tool; }

  CartesianPlanner::Progress plan(const JointAngles& start, std::span<const SegmentRequest> chain) {
    planner.begin(start, chain);
    return finish_plan(planner);
  }
  CartesianPlanner::Progress plan(const JointAngles& start, const SegmentRequest& request) {
    return plan(start, std::span{&request, 1});
  }

  // The set-points as a motion loop would send them, `shift` ticks after each tick; rests at both ends.
  [[nodiscard]] std::vector<JointAngles> set_points(double shift = 0.0) const {
    const CartesianPlan& p = planner.plan();
    std::vector<JointAngles> joints(4, p.start);
    joints.reserve(static_cast<std::size_t>(p.duration.value()) + 10);
    for (std::int64_t tick = 1; tick <= p.duration.value() + 4; ++tick) {
      joints.push_back(position(p, arm, (static_cast<double>(tick) - shift) * kTickSeconds, joints.back()));
    }
    return joints;
  }

  RobotModel robot;
  Transform flange_T_tool;
  Arm arm{robot};
  CartesianPlanner planner;
};

// The largest speed, acceleration and jerk of any joint, as shares of its limits, from the set-points alone.
struct JointPeaks {
  double speed = 0.0, accel = 0.0, jerk = 0.0;
  std::size_t accel_axis = 0, accel_at = 0;  // number of the axis, and the set-point
  [[nodiscard]] double most(bool with_jerk) const { return std::max({speed, accel, with_jerk ? jerk : 0.0}); }
};

inline JointPeaks joint_peaks(const RobotModel& robot, const std::vector<JointAngles>& joints) {
  JointPeaks peaks;
  const double ts = 50e-6;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const AxisModel& model = robot.axes[axis];
    // 4 Mpps at the drive.
    const double pulse_speed =
        4e6 * 2.0 * std::numbers::pi / (std::fabs(model.gear_ratio) * static_cast<double>(model.pulses_per_rev));
    const double speed = std::min(model.max_speed_rad_s, pulse_speed);
    for (std::size_t k = 3; k < joints.size(); ++k) {
      const auto q = [&](std::size_t back) { return joints[k - back][axis].value(); };
      peaks.speed = std::max(peaks.speed, std::fabs(q(0) - q(1)) / ts / speed);
      const double accel = std::fabs(q(0) - 2 * q(1) + q(2)) / (ts * ts) / model.max_accel_rad_s2;
      if (accel > peaks.accel) {
        peaks.accel = accel;
        peaks.accel_axis = axis + 1;
        peaks.accel_at = k;
      }
      peaks.jerk =
          std::max(peaks.jerk, std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3)) / (ts * ts * ts) / model.max_jerk_rad_s3);
    }
  }
  return peaks;
}

// The largest speeds and accelerations of the tool as shares of `limits`, from its poses alone.
struct ToolPeaks {
  double speed = 0.0, accel = 0.0, turn_speed = 0.0, turn_accel = 0.0;
  [[nodiscard]] double most() const { return std::max({speed, accel, turn_speed, turn_accel}); }
};

inline ToolPeaks tool_peaks(const CartesianPlan& plan, const PathLimits& limits) {
  ToolPeaks peaks;
  const double ts = 50e-6;
  Transform last = tool_pose(plan, 0.0);
  Eigen::Vector3d last_v = Eigen::Vector3d::Zero(), last_w = Eigen::Vector3d::Zero();
  for (std::int64_t tick = 1; tick <= plan.duration.value() + 2; ++tick) {
    const Transform now = tool_pose(plan, static_cast<double>(tick) * ts);
    const Eigen::Vector3d v = (now.position_mm - last.position_mm) / ts;
    const Eigen::Quaterniond turn{Eigen::Matrix3d{now.rotation * last.rotation.transpose()}};
    const Eigen::Vector3d w = std::copysign(2.0 / ts, turn.w()) * turn.vec();
    peaks.speed = std::max(peaks.speed, v.norm() / limits.speed_mm_s);
    peaks.accel = std::max(peaks.accel, (v - last_v).norm() / ts / limits.accel_mm_s2);
    peaks.turn_speed = std::max(peaks.turn_speed, w.norm() / limits.turn_speed_rad_s);
    peaks.turn_accel = std::max(peaks.turn_accel, (w - last_w).norm() / ts / limits.turn_accel_rad_s2);
    last = now;
    last_v = v;
    last_w = w;
  }
  return peaks;
}

// The turning of a five-axis arm whose heading follows the tool, in place of that in space: the rates of pitch and
// roll, from the joints alone. Signs are those of hu2012().
inline void limit_pitch_and_roll(ToolPeaks& peaks, const std::vector<JointAngles>& joints, const PathLimits& limits) {
  const double ts = 50e-6;
  peaks.turn_speed = peaks.turn_accel = 0.0;
  const auto pitch = [](const JointAngles& q) { return (q[1] + q[2] + q[3]).value(); };
  for (std::size_t k = 2; k < joints.size(); ++k) {
    const JointAngles &a = joints[k - 2], &b = joints[k - 1], &c = joints[k];
    const double speed = std::hypot(pitch(c) - pitch(b), (c[4] - b[4]).value()) / ts;
    const double accel =
        std::hypot(pitch(c) - 2 * pitch(b) + pitch(a), (c[4] - b[4] - (b[4] - a[4])).value()) / (ts * ts);
    peaks.turn_speed = std::max(peaks.turn_speed, speed / limits.turn_speed_rad_s);
    peaks.turn_accel = std::max(peaks.turn_accel, accel / limits.turn_accel_rad_s2);
  }
}

// An IRB 120 whose tool points down as at kReady, with its wrist centre at the given place.
inline Transform down_from(const PathRig& rig, double x_mm, double y_mm, double z_mm) {
  return {rig.tool_at(kReady).rotation, {x_mm, y_mm, z_mm - 72.0}};
}
// The branch that is nearest to kReady.
inline JointAngles joints_at(const PathRig& rig, const Transform& pose) {
  const IkSolutions solutions = rig.arm.inverse(pose, kReady);
  EXPECT_GE(solutions.selected, 0);
  return solutions.branches[static_cast<std::size_t>(std::max<int>(solutions.selected, 0))].joints;
}

}  // namespace armature::test
