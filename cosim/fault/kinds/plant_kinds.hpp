// Faults of drives and mechanics.
#pragma once

#include <cstdint>

namespace armature::cosim {

// The drive of an axis does not see its next pulses. Ends by itself when they are lost.
struct PulseLoss {
  int axis = 1;            // 1..6
  std::int64_t count = 0;  // pulses, at least 1

  friend bool operator==(const PulseLoss&, const PulseLoss&) = default;
};

// The drive of an axis counts each of its next pulses twice. Ends by itself after these pulses.
struct ExtraPulses {
  int axis = 1;            // 1..6
  std::int64_t count = 0;  // pulses, at least 1

  friend bool operator==(const ExtraPulses&, const ExtraPulses&) = default;
};

// The drive of an axis has an internal fault for this time. Its alarm stays until the servo is off and the fault over.
struct DriveAlarm {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const DriveAlarm&, const DriveAlarm&) = default;
};

// The motor shaft of an axis cannot turn for this time: the arm has hit something.
struct AxisBlocked {
  int axis = 1;           // 1..6
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const AxisBlocked&, const AxisBlocked&) = default;
};

// The brake of an axis holds less, for this time.
struct BrakeSlip {
  int axis = 1;           // 1..6
  double share = 0;       // of its torque that is left, 0..1
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const BrakeSlip&, const BrakeSlip&) = default;
};

// Something pushes against a joint, behind its gear, for this time: a person, or an obstacle that gives way.
struct CollisionTorque {
  int axis = 1;           // 1..6
  double torque_nm = 0;   // not 0; positive in the positive direction of the joint
  double duration_s = 0;  // a cycle of the clock or longer

  friend bool operator==(const CollisionTorque&, const CollisionTorque&) = default;
};

}  // namespace armature::cosim
