#include "cosim/scenario/to_controller.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "cosim/text/angle_units.hpp"

namespace armature::cosim {
namespace {

// Whole cycles of the logic that last at least this long.
std::int32_t cycles_of_ns(double ns) {
  return static_cast<std::int32_t>(std::ceil(ns / static_cast<double>(kNsPerCycle)));
}

// Whole ticks that last at least this long. A time that is a whole number of ticks except for rounding gives that
// number.
Ticks at_least_ticks(double s) {
  return Ticks{static_cast<std::int64_t>(std::ceil(s / kTickSeconds - 1e-6))};
}

AxisModel to_axis_model(const AxisSpec& axis) {
  return {
      .gear_ratio = axis.gear_ratio,
      .pulses_per_rev = axis.pulses_per_rev,
      .counts_per_rev = axis.encoder_lines * kCountsPerLine,
      .min_rad = axis.min_deg * kRadPerDeg,
      .max_rad = axis.max_deg * kRadPerDeg,
      .max_speed_rad_s = axis.max_speed_deg_s * kRadPerDeg,
      .max_accel_rad_s2 = axis.max_accel_deg_s2 * kRadPerDeg,
      .max_jerk_rad_s3 = axis.max_jerk_deg_s3.value_or(0.0) * kRadPerDeg,
      .following_error_limit_rad = axis.following_error_deg * kRadPerDeg,
      .drive_natural_rad_s = axis.drive.natural_hz * (2.0 * std::numbers::pi),
      .drive_damping = axis.drive.damping,
      .dir_setup_cycles = cycles_of_ns(axis.drive.dir_setup_ns),
      .dir_hold_cycles = cycles_of_ns(axis.drive.dir_hold_ns),
      .min_step_high_cycles = cycles_of_ns(axis.drive.min_step_high_ns),
      .min_step_low_cycles = cycles_of_ns(axis.drive.min_step_low_ns),
  };
}

ArmGeometry to_arm_geometry(const KinematicsSpec& kinematics) {
  return {
      .family = kinematics.family == kFiveRFamily ? ArmFamily::kFiveR : ArmFamily::kSixR,
      .a1_mm = kinematics.a1_mm,
      .a2_mm = kinematics.a2_mm,
      .a3_mm = kinematics.a3_mm,
      .a4_mm = kinematics.a4_mm,
      .d1_mm = kinematics.d1_mm,
      .d4_mm = kinematics.d4_mm,
      .d5_mm = kinematics.d5_mm,
      .d6_mm = kinematics.d6_mm,
      .sign = kinematics.sign,
      .offset_rad = make_per_axis([&](std::size_t i) { return kinematics.offset_deg[i] * kRadPerDeg; }),
      .max_projection_rad = kinematics.family == kFiveRFamily ? kinematics.max_projection_deg * kRadPerDeg : 0.0,
  };
}

Eigen::Vector3d to_vector(const std::array<double, 3>& mm) {
  return {mm[0], mm[1], mm[2]};
}

ProfileKind to_profile_kind(const MoveSpec& move) {
  return move.profile == "scurve" ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
}

FramedPose to_framed_pose(const MoveSpec& move) {
  FramedPose pose;
  pose.frame = FrameId{static_cast<std::uint8_t>(move.frame)};
  pose.position_mm = to_vector(move.xyz_mm.value());
  if (move.rpy_deg) pose.rotation = to_transform({.xyz_mm = {}, .rpy_deg = *move.rpy_deg}).rotation;
  return pose;
}

Command joint_command(const MoveSpec& move) {
  const double speed = move.speed_percent / 100.0;
  if (move.xyz_mm)
    return PoseMove{
        .target = to_framed_pose(move), .speed = speed, .profile = to_profile_kind(move), .tag = move.index};
  JointMove joint;
  for (std::size_t i = 0; i < kAxes; ++i) joint.target[i] = Radians{move.target_deg.value()[i] * kRadPerDeg};
  joint.speed = speed;
  joint.profile = to_profile_kind(move);
  joint.tag = move.index;
  return joint;
}

CartesianMove to_cartesian_move(const MoveSpec& move) {
  using Kind = SegmentRequest::Kind;
  return {
      .kind = move.type == MoveType::kArc      ? Kind::kArc
              : move.type == MoveType::kCircle ? Kind::kCircle
                                               : Kind::kLine,
      .target = to_framed_pose(move),
      .via_mm = to_vector(move.via_mm),
      .limits = {.speed_mm_s = move.speed_mm_s,
                 .accel_mm_s2 = move.accel_mm_s2,
                 .jerk_mm_s3 = move.jerk_mm_s3,
                 .turn_speed_rad_s = move.turn_speed_deg_s * kRadPerDeg,
                 .turn_accel_rad_s2 = move.turn_accel_deg_s2 * kRadPerDeg,
                 .turn_jerk_rad_s3 = move.turn_jerk_deg_s3 * kRadPerDeg},
      .profile = to_profile_kind(move),
      .blend_mm = move.blend_mm,
      .tag = move.index,
  };
}

}  // namespace

RobotModel to_robot_model(const RobotSpec& robot) {
  RobotModel model;
  for (std::size_t i = 0; i < kAxes; ++i) model.axes[i] = to_axis_model(robot.axes[i]);
  model.axis_count = robot.axis_count;
  for (std::size_t i = robot.axis_count; i < kAxes; ++i) model.axes[i].min_rad = model.axes[i].max_rad = 0.0;
  if (robot.kinematics) model.arm = to_arm_geometry(*robot.kinematics);
  return model;
}

ControllerConfig to_controller_config(const Scenario& scenario) {
  const ControllerSpec& controller = scenario.controller;
  ControllerConfig config;
  config.feedback = controller.feedback;
  config.sync = controller.sync == "const_acc"    ? SyncRule::kConstAcc
                : controller.sync == "time_scale" ? SyncRule::kTimeScale
                                                  : SyncRule::kFig9;
  if (scenario.variant == Variant::kPaper) {
    config.paper = {.axis = static_cast<std::size_t>(scenario.paper.encoder_axis - 1),
                    .switch_every = Ticks{scenario.paper.switch_every_ticks.value_or(0)}};
  }
  config.max_stretch = controller.max_stretch;
  config.flange_T_tool = to_transform(scenario.tool);
  for (std::size_t i = 0; i < scenario.frames.size(); ++i) {
    config.base_T_user.at(i) = to_transform(scenario.frames[i].pose);
  }
  return config;
}

Transform to_transform(const PoseSpec& pose) {
  const auto& [roll, pitch, yaw] = pose.rpy_deg;
  return {rotation_from_rpy(roll * kRadPerDeg, pitch * kRadPerDeg, yaw * kRadPerDeg), to_vector(pose.xyz_mm)};
}

Command to_command(const MoveSpec& move) {
  switch (move.type) {
    case MoveType::kJoint:
      return joint_command(move);
    case MoveType::kLine:
    case MoveType::kArc:
    case MoveType::kCircle:
      return to_cartesian_move(move);
    case MoveType::kHold:
      return Hold{};
    case MoveType::kResume:
      return Resume{};
    case MoveType::kOverride:
      return SetOverride{.share = move.speed_percent / 100.0, .tag = move.index};
    case MoveType::kStop:
      return Stop{};
    case MoveType::kDout:
      return SetOutput{.pin = static_cast<std::uint8_t>(move.pin), .level = move.level, .tag = move.index};
    case MoveType::kWaitDin:
      return WaitInput{.pin = static_cast<std::uint8_t>(move.pin),
                       .level = move.level,
                       .timeout = at_least_ticks(move.timeout_s),
                       .tag = move.index};
    case MoveType::kClearFault:
      break;
  }
  return ClearFault{.tag = move.index};
}

}  // namespace armature::cosim
