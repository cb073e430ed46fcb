// What the judge allows an arm, from the robot file alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

struct AxisLimits {
  double deg_per_count = 0;           // of the joint, signed
  double min_deg = 0, max_deg = 0;    // where the arm must have stopped: behind the range and its switches
  double max_counts_per_tick = 0;     // of the motor
  std::int64_t off_path_counts = 0;   // from its path, before something must have been detected
  std::int64_t run_out_counts = 0;    // of a motor without power
  std::int64_t tolerance_counts = 0;  // of a position at rest
  // Of a push on the joint, that brake and drive surely withstand beside the load of the axis. No push moves an axis
  // without dynamics.
  double withstood_nm = std::numeric_limits<double>::infinity();
};

struct JudgeLimits {
  std::size_t axis_count = kAxes;
  PerAxis<AxisLimits> axes{};
  Cycles brake_time{};  // of a stop on the path, after which the servo power must be away
};

[[nodiscard]] JudgeLimits judge_limits(const RobotSpec& robot);

}  // namespace armature::cosim
