// What the motion loop publishes once per tick, for recorders and the other core. Plain data; core 0 is the only
// writer.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class MotionState : std::uint8_t {
  kIdle,
  kMoving,
  kStopping,
  kFault,
  kHolding,  // braking to, or standing in, a Hold with a move to go on with or to begin
};

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

struct Telemetry {
  Ticks tick{-1};  // ticks since the loop started; -1 before the first
  MotionState state = MotionState::kIdle;
  FaultCause fault = FaultCause::kNone;
  std::uint8_t fault_axis = 0;         // 1..6, 0 when no single axis is to blame
  std::uint16_t sequence = 0;          // commit sequence of this tick's counts
  std::uint32_t underruns = 0;         // as counted by the logic
  std::int64_t moves_finished = 0;     // whose end was reached, each segment of a chain counted
  double rate = 0.0;                   // path time per time: 1 as planned, less under an override, 0 without a plan
  PerAxis<Radians> reference{};        // set-point of the next tick
  PerAxis<Pulses> reference_pulses{};  // round_half_away(reference / resolution)
  PerAxis<Pulses> correction{};        // feedback correction that is in the commanded pulses
  PerAxis<Pulses> commanded{};         // sum of all committed counts, less what the logic did not emit
  PerAxis<Counts> encoder{};           // snapshot read in this tick, unwrapped to 64 bits
  PerAxis<Radians> actual{};           // encoder as a joint angle
};

enum class MoveKind : std::uint8_t { kJoint, kLine, kArc };

// One accepted move, reported when it starts; each segment of a chain is a move.
struct MoveReport {
  MoveKind kind = MoveKind::kJoint;
  std::uint32_t tag = 0;  // of the command
  Ticks start_tick{};
  Ticks duration{};  // as planned: a stop shortens it, a hold or an override lengthens it, so does every underrun
  PerAxis<ProfileShape> shape{};
  PerAxis<double> peak_speed_rad_s{};
  PerAxis<double> accel_rad_s2{};
  // kLine, kArc: shapes, speeds and accelerations above are empty.
  PositionPath path{};             // ideal path of the tool centre point in the base frame, corners not rounded
  double stretch = 1.0;            // by how much the joints made it slower than asked for
  std::uint8_t stretched_for = 0;  // joint 1..6 that asked for most of it; 0: none, or the tool in a rounded corner
  bool continues = false;          // blended with the move before
  // kJoint to a pose, kLine, kArc: the most by which the tool misses the orientation that was asked for, because five
  // joints cannot take it; at most ArmGeometry::max_projection_rad. 0 for six joints.
  double residual_rad = 0.0;
};

// A command that will not be carried out and moved nothing: a move or a command for a pin that was not accepted, one
// that was and is dropped before it begins or while it waits for an input, an override out of range, or a ClearFault
// whose fault stays.
enum class Refusal : std::uint8_t {
  kOutsideLimits,
  kNotReady,  // in Fault; dropped by a Stop or a fault; the cause of the fault is still there
  kQueueFull,
  kInvalidTarget,  // not a number, no rotation, a frame that is not known, a speed, limit, share, blend radius, pin or
                   // time-out out of its range, an axis that the robot has not, a joint move of more than 24 h
                   // (kLongestMove), or a path of more than 600 s (kLongestSegment)
  kNoKinematics,   // a pose for a robot whose geometry is not known
  kNoJerkLimit,    // an S-curve for a robot without jerk limits
  kUnreachable,
  kOrientation,   // a five-joint arm cannot take this orientation there
  kSingular,      // the path passes a singularity too close: the joints would need too much time
  kTooFast,       // the same without a singularity nearby
  kNoCircle,      // the points of an arc do not determine a circle
  kChainRefused,  // another segment of the same chain was refused
  kInputTimeout,  // an input did not get its level in time: that command, and all that waited behind it
};
struct MoveRefusal {
  Refusal reason = Refusal::kNotReady;
  std::uint8_t axis = 0;  // 1..6, 0 when no single axis is to blame
  // Of a move to a pose or along a path: where on the path and by how much; `path.kind` is kNone otherwise.
  PathProblem path{};
  std::uint32_t tag = 0;  // of the command
};

// A command for a pin of the tool that was carried out.
struct IoReport {
  std::uint32_t tag = 0;  // of the command
  std::uint8_t pin = 0;   // 1..16
  bool level = false;     // that the output was given, or that the input was seen to have
};

}  // namespace armature
