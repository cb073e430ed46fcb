// The state of the arm as the pendant sees it, derived from what is true of the arm.
#pragma once

#include "controller/pendant/frame_table.hpp"

namespace armature::pendant {

struct ArmFacts {
  bool started = false;  // the controller has started the drives once
  bool estop = false;    // an emergency stop is latched
  bool alarm = false;    // the arm is in Fault for another cause
  bool servo_on = false;
  bool program = false;  // a program runs or is held
  bool held = false;
  bool jog = false;   // a jog is under way
  bool move = false;  // something else is under way
};

// What is worse comes first.
[[nodiscard]] constexpr State state_of(const ArmFacts& facts) noexcept {
  if (facts.estop) return State::kEstop;
  if (!facts.started) return State::kOff;
  if (facts.alarm) return State::kAlarm;
  if (!facts.servo_on) return State::kIdle;
  if (facts.program) return facts.held ? State::kHold : State::kRun;
  if (facts.jog) return State::kJog;
  return facts.move ? State::kMove : State::kReady;
}

}  // namespace armature::pendant
