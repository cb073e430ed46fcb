// What the machine knows of the robot, the cell and the settings of a user.
#pragma once

#include <array>

#include "controller/command/robot_cell.hpp"

namespace armature::job {

// The settings of a user: [job] of a scenario.
struct MachineSettings {
  // The radius of the rounded corner of a path for PL=0..8. Joint moves pass at PL eighths of half their way.
  std::array<double, 9> pl_radius_mm{0.0, 12.5, 25.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0};
  // Of moves without a speed, before the first SPEED.
  double joint_speed = 0.1;  // share of the limits: 10 %
  double speed_mm_s = 100.0;
  double turn_speed_rad_s = 1.5707963267948966;
  // ACC=100.
  double accel_mm_s2 = 1'000.0;
  double turn_accel_rad_s2 = 15.707963267948966;
};

struct MachineSetup {
  RobotCell cell;
  MachineSettings settings{};
};

}  // namespace armature::job
