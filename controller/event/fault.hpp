// The motion loop enters Fault, and leaves it.
#pragma once

#include <cstdint>

#include "controller/core/units.hpp"

namespace armature {

enum class FaultCause : std::uint8_t {
  kNone,
  kEmergencyStop,
  kWatchdog,        // the logic saw too many ticks without a commit
  kFollowingError,  // an axis is farther from its reference than its limit
  kDriveAlarm,
  kEncoder,      // illegal transitions, an index mismatch, or lines that never settled: no position to be trusted
  kLimitSwitch,  // the axis moves towards a limit switch that is closed
  kHardwareId,   // a block of the logic is not the one this software was built for
};

struct Faulted {
  FaultCause cause = FaultCause::kNone;
  std::uint8_t axis = 0;  // 1..6, 0 when no single axis is to blame
  Ticks tick{-1};         // -1: before the first tick
};

struct FaultCleared {
  Ticks tick{};
};

}  // namespace armature
