// A command will not be executed. It has caused no motion.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/trajectory/path/path_problem.hpp"

namespace armature {

// The reason of a refusal. A move or pin command is refused when it is not accepted, or when it is dropped before it
// begins or while it waits for an input. An override or a ClearFault is refused when it has no effect.
enum class Refusal : std::uint8_t {
  kOutsideLimits,
  kNotReady,  // in Fault; dropped by a Stop or a fault; the cause of the fault persists; a jog beside moves or in a
              // Hold
  kQueueFull,
  kInvalidTarget,  // not finite; no rotation; an unknown frame; a speed, limit, share, blend radius, pin or time-out
                   // out of its range; an axis that the robot does not have or cannot home; a joint move of more than
                   // 24 h (kLongestMove); a path of more than 600 s (kLongestSegment)
  kNoKinematics,   // a pose for a robot without known geometry
  kNoJerkLimit,    // an S-curve for a robot without jerk limits
  kUnreachable,
  kOrientation,    // a five-joint arm cannot reach this orientation there, or jog its tool
  kSingular,       // the path passes too close to a singularity: the joints would need too much time
  kTooFast,        // the joints would need too much time, without a singularity nearby
  kNoCircle,       // the points of an arc do not determine a circle
  kChainRefused,   // another segment of the same chain was refused
  kReplaced,       // a joint move that begins at once replaced the motion before this move began
  kInputTimeout,   // an input did not reach its level in time; reported for that command and all behind it
  kConfiguration,  // a pose has no solution in the requested configuration, or a path ends with another one
  kNoSpline,       // the points of a spline are too close, or the curve would turn back on the spot
  kOutputOutside,  // an output of the move is before the start or behind the end of its chain
  kPartLost,       // the part leaves the window before the end of the move, or the arm no longer follows it; reported
                   // for all moves that wait
  kBeltTooFast,    // the belt is faster than ConveyorConfig::max_speed_mm_s
  kNotReferenced,  // the angle of a joint is not known: only Home moves the arm
};

struct MoveRefused {
  Refusal reason = Refusal::kNotReady;
  std::uint8_t axis = 0;  // 1..6, or 0 when no single axis caused it
  // Position and size of the problem, for a move to a pose or along a path; otherwise `path.kind` is kNone. A joint
  // move outside the limits has `angle_rad`, `limit_rad`, and `at`: 1 for its target, 0 for the way to brake before it.
  PathProblem path{};
  Tag tag{};  // of the command
  ARMATURE_MEMBERS(MoveRefused, reason, axis, path, tag)
};

// With nothing but the reason.
[[nodiscard]] inline MoveRefused refused(Refusal reason, Tag tag = {}) noexcept {
  return {.reason = reason, .tag = tag};
}

}  // namespace armature
