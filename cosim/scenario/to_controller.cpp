#include "cosim/scenario/to_controller.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/synchronise.hpp"

namespace armature::cosim {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

// Whole cycles of the logic that last at least this long.
std::int32_t cycles_of_ns(double ns) {
  constexpr double kNsPerCycle = 1e9 / static_cast<double>(kClkFreqHz);
  return static_cast<std::int32_t>(std::ceil(ns / kNsPerCycle));
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
      .following_error_limit_rad = axis.following_error_deg * kRadPerDeg,
      .drive_natural_rad_s = axis.drive.natural_hz * (2.0 * std::numbers::pi),
      .drive_damping = axis.drive.damping,
      .dir_setup_cycles = cycles_of_ns(axis.drive.dir_setup_ns),
      .dir_hold_cycles = cycles_of_ns(axis.drive.dir_hold_ns),
  };
}

}  // namespace

RobotModel to_robot_model(const RobotSpec& robot) {
  RobotModel model;
  for (std::size_t i = 0; i < kAxes; ++i) model.axes[i] = to_axis_model(robot.axes[i]);
  return model;
}

ControllerConfig to_controller_config(const ControllerSpec& controller) {
  ControllerConfig config;
  config.feedback = controller.feedback;
  config.sync = controller.sync == "const_acc"    ? SyncRule::kConstAcc
                : controller.sync == "time_scale" ? SyncRule::kTimeScale
                                                  : SyncRule::kFig9;
  return config;
}

Command to_command(const MoveSpec& move) {
  switch (move.type) {
    case MoveType::kStop:
      return Stop{};
    case MoveType::kClearFault:
      return ClearFault{};
    default:
      break;
  }
  JointMove joint;
  for (std::size_t i = 0; i < kAxes; ++i) joint.target[i] = Radians{(*move.target_deg)[i] * kRadPerDeg};
  joint.speed = move.speed_percent / 100.0;
  return joint;
}

}  // namespace armature::cosim
