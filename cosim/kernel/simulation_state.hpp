// What is seen of a simulation between two of its steps: time, pins, drives, motors, and what the controller publishes.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/telemetry.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

struct SimulationState {
  Cycles now{};
  bool over = false;
  std::int64_t triggers = 0;  // that have come
  std::int64_t bus_reads = 0, bus_writes = 0;
  SocInputs inputs;
  SocOutputs outputs;
  Telemetry telemetry;  // of the latest tick
  PerAxis<Pulses> drive_pulses{};
  PerAxis<Counts> motor_counts{};
  PerAxis<double> motor_deg{};               // as a joint angle
  PerAxis<double> following_error_counts{};  // in the drive
};

}  // namespace armature::cosim
