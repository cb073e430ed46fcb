// A move that started is over.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

struct MoveFinished {
  enum class How : std::uint8_t {
    kReachedEnd,
    kCutShort,  // by a stop, a fault, or a new target in motion
  };

  Tag tag{};  // of the command
  How how = How::kReachedEnd;
  // Of the last step; for kCutShort: the tick in which the stop is complete, or the fault or the new move begins.
  Ticks tick{};
  Ticks taken{};  // from the first step to the last, both included; holds and overrides count. 0: a move of no length
  ARMATURE_MEMBERS(MoveFinished, tag, how, tick, taken)
};

}  // namespace armature
