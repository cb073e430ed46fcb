// The data that the motion loop publishes once per tick, for recorders and the other core. Only core 0 writes it.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/units.hpp"
#include "controller/message/fault.hpp"

namespace armature {

enum class MotionState : std::uint8_t {
  kIdle,
  kMoving,
  kStopping,
  kFault,
  kHolding,  // braking to, or standing in, a Hold with a move to continue or to begin
};

struct Telemetry {
  Ticks tick{-1};  // ticks since the loop started; -1 before the first
  MotionState state = MotionState::kIdle;
  FaultCause fault = FaultCause::kNone;
  std::uint8_t fault_axis = 0;            // 1..6, or 0 when no single axis caused it
  std::uint8_t referenced = 0;            // mask of axes whose joint angles are known, bit 0 for axis 1
  std::uint16_t sequence = 0;             // commit sequence of this tick's counts
  std::uint32_t underruns = 0;            // as counted by the logic
  double rate = 0.0;                      // path time per time: 1 as planned, less under an override, 0 without a plan
  PerAxis<Radians> reference{};           // set-point of the next tick
  PerAxis<Pulses> reference_pulses{};     // round_half_away(reference / resolution)
  PerAxis<Pulses> correction{};           // feedback correction contained in the commanded pulses
  PerAxis<Pulses> commanded{};            // sum of all committed counts minus the pulses not emitted
  PerAxis<Counts> encoder{};              // position read in this tick, unwrapped to 64 bits
  PerAxis<Radians> actual{};              // encoder as a joint angle
  std::uint32_t solved_poses = 0;         // set-points that the logic has solved since the start (InverseCheck)
  double solver_difference_pulses = 0.0;  // their largest difference from software
  ARMATURE_MEMBERS(Telemetry, tick, state, fault, fault_axis, referenced, sequence, underruns, rate, reference,
                   reference_pulses, correction, commanded, encoder, actual, solved_poses, solver_difference_pulses)
};

}  // namespace armature
