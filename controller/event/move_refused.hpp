// A command will not be executed and has moved nothing.
#pragma once

#include <cstdint>

#include "controller/core/tag.hpp"
#include "controller/trajectory/path/path_problem.hpp"

namespace armature {

// Why a move or a command for a pin is not accepted, or is dropped before it begins or while it waits for an input; why
// an override or a ClearFault is without effect.
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

struct MoveRefused {
  Refusal reason = Refusal::kNotReady;
  std::uint8_t axis = 0;  // 1..6, 0 when no single axis is to blame
  // Of a move to a pose or along a path: where on the path and by how much; `path.kind` is kNone otherwise.
  PathProblem path{};
  Tag tag{};  // of the command
};

}  // namespace armature
