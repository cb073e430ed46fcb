// The arm follows a part on the conveyor, or no longer follows it.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

enum class PartPhase : std::uint8_t {
  kBegun,         // the arm begins to take up the velocity of the belt
  kSynchronised,  // the frame of the moves is that of the part; later deviations are tracking errors
  kLeaving,       // the frame of the moves comes to rest, for a move in another frame
  kEnded,         // the joints stop, or the frame is at rest
  kMissed,        // the part had passed the window before a move waited for it
};

// Why it ended.
enum class PartEnd : std::uint8_t {
  kReleased,      // the next move is in another frame
  kWindow,        // the part left the window
  kTooFast,       // the belt was faster than its limit
  kCannotFollow,  // a set-point was out of reach or outside the limits of the joints
  kUnseen,        // the camera had no new sample
  kStopped,       // by a Stop or a Hold
  kFault,
};

struct PartFollowed {
  PartPhase phase = PartPhase::kBegun;
  PartEnd end = PartEnd::kReleased;  // kEnded
  std::uint8_t axis = 0;             // kCannotFollow: 1..6, or 0
  std::uint32_t part = 0;            // number of the part since the start of the controller, from 0
  Tag tag{};                         // of the first move; not for kMissed
  Ticks tick{};                      // not for kMissed
  double displacement_mm = 0.0;      // of the part, as measured
  // kEnded: the largest distance of the frame of the set-points from the measured belt after kSynchronised.
  double deviation_mm = 0.0;
  // kEnded, with a network (ConveyorConfig::policy): the ticks since the arm waited for the part in which it corrected
  // where the belt is expected; in which the belt was outside the ranges of training; in which it gave no result.
  std::uint32_t corrected = 0, out_of_range = 0, no_result = 0;
  ARMATURE_MEMBERS(PartFollowed, phase, end, axis, part, tag, tick, displacement_mm, deviation_mm, corrected,
                   out_of_range, no_result)
};

}  // namespace armature
