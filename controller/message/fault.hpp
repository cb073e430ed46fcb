// The events of the motion loop entering and leaving Fault.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/units.hpp"

namespace armature {

enum class FaultCause : std::uint8_t {
  kNone,
  kEstop,
  kWatchdog,        // the logic counted too many ticks without a commit
  kFollowingError,  // an axis is farther from its set-point, or from where its drive would be, than its limit
  kDriveAlarm,
  kEncoder,      // illegal transitions, an index mismatch, or lines that were never stable: the position is not valid
  kLimitSwitch,  // the axis moves towards an active limit switch
  kHardwareId,   // a block of the logic is not the one that this software supports
  kDrivesOff,    // no fault of the arm: a SwitchOff, or the controller starts with its drives off
  kClock,        // no trigger came for 1.5 ticks, or ticks have a wrong length: the timer of the logic, or its clock
  kInverseKinematics,  // the logic solved a pose, and its joint angles are not those of the software
  kEncoderSpeed,       // an encoder is faster than the limit of its axis
  kEncoderAccel,       // an encoder changes its speed faster than the limit of its axis
  kCore1Silent,        // core 1 has not answered for 0.25 s: nobody plans, and nobody listens to the pendant
  kServoEnable,        // the enable of a drive is low, although core 0 has set it and no stop is latched
  kCodeChanged,        // the code of the cores is not what it was at the start; only a new start helps
};

struct Faulted {
  FaultCause cause = FaultCause::kNone;
  std::uint8_t axis = 0;  // 1..6, or 0 when no single axis caused it
  Ticks tick{-1};         // -1: before the first tick
  ARMATURE_MEMBERS(Faulted, cause, axis, tick)
};

struct FaultCleared {
  Ticks tick{};
  ARMATURE_MEMBERS(FaultCleared, tick)
};

}  // namespace armature
