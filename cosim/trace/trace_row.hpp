// One row of the trace: all data of one tick that goldens and expectations use.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/message/telemetry.hpp"

namespace armature::cosim {

// Position of the tool centre point in the base frame.
struct ToolPoint {
  Eigen::Vector3d reference_mm = Eigen::Vector3d::Zero();          // of the set-point of the next tick
  Eigen::Vector3d encoder_mm = Eigen::Vector3d::Zero();            // of the encoder position as the controller read it
  Eigen::Matrix3d encoder_rotation = Eigen::Matrix3d::Identity();  // of the tool at that position
};

// What a core did in a tick.
struct CoreLoad {
  std::int64_t awake_cycles = 0;  // computing or on the bus
  std::int64_t bus_cycles = 0;    // an access of this core was under way
  std::int64_t instructions = 0;  // executed, if the processor counts them
};

struct TraceRow {
  Telemetry telemetry;                           // of the controller, as of this trigger
  std::int64_t tick = 0;                         // number of the trigger that ends this row's tick, from 0
  std::int64_t cycle = 0;                        // clock cycle of that trigger
  PerAxis<std::int64_t> pin_pulses{};            // net rising edges on the step pins since reset
  PerAxis<std::int64_t> pulses_to_drop{};        // pulses that a fault has still to drop
  PerAxis<std::int64_t> motor_counts{};          // true motor position in encoder counts
  PerAxis<std::int64_t> first_rise{};            // cycle of the first rising step edge of this tick; 0: none
  PerAxis<std::int64_t> turned{};                // cycle of the latest change of dir in this tick; 0: none
  PerAxis<std::int64_t> motor_from{};            // where the step of the motor before this trigger began [2^-24 counts]
  PerAxis<std::int64_t> motor_to{};              // and where it ends
  std::optional<PerAxis<double>> load_lead_deg;  // joints less motors; none: the gears are rigid
  std::optional<ToolPoint> tool_point;           // none: not requested, or the robot has no kinematics
  std::array<CoreLoad, 2> load{};                // of the tick that this trigger ends
  bool stopped = false;                          // a servo enable is low after it was high
};

}  // namespace armature::cosim
