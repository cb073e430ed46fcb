// A robot as constant data: what the controller must know about each axis. Loaded from scenarios/robots/*.toml on the
// host, a constant table on the target.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

struct AxisModel {
  // Motor turns per joint turn; negative when the joint turns against the motor.
  double gear_ratio = 1.0;
  // Electronic gear of the drive: pulses that make one motor revolution.
  std::int32_t pulses_per_rev = 1;
  // Encoder counts (four per line) per motor revolution.
  std::int32_t counts_per_rev = 1;

  // Joint limits and rates, joint side.
  double min_rad = 0.0;
  double max_rad = 0.0;
  double max_speed_rad_s = 0.0;
  double max_accel_rad_s2 = 0.0;
  double max_jerk_rad_s3 = 0.0;  // 0: unknown, then no move can be an S-curve

  // Reference minus encoder position that makes the motion loop enter Fault (includes the drive's normal lag).
  double following_error_limit_rad = 0.0;

  // The drive's nominal position loop, for the feedback's model of its lag: natural frequency and damping ratio.
  double drive_natural_rad_s = 0.0;
  double drive_damping = 1.0;

  // What the drive's data sheet asks around a change of direction, in cycles of the logic (20 ns), 0..1023: direction
  // stable before the first rising step edge after the change, and after the last falling edge before it. The logic has
  // one setting for all axes and gets the largest. Beyond 1023 the model is wrong: the register cannot hold it.
  std::int32_t dir_setup_cycles = 25;
  std::int32_t dir_hold_cycles = 25;

  // What it asks of the step pulses, likewise. Generators of counts keep more than any drive needs; only those that are
  // sent half periods have to be told.
  std::int32_t min_step_high_cycles = 5;
  std::int32_t min_step_low_cycles = 5;
};

struct RobotModel {
  PerAxis<AxisModel> axes{};
  // Joints of the arm, 1..kAxes. The axes beyond them have no drive; their set-points stay 0.
  std::size_t axis_count = kAxes;
  ArmGeometry arm{};
};

}  // namespace armature
