// A stream of set-points that began is over: the arm stands.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

struct StreamEnded {
  enum class How : std::uint8_t {
    kComplete,  // at its last set-point
    kLate,      // the next set-point was not there in time: the axes braked
    kStopped,   // by a Stop, a Hold, or a set-point that was refused
    kFault,
  };
  Tag tag{};  // of the stream
  How how = How::kComplete;
  Ticks tick{};                     // the tick in which the arm stands
  std::int64_t followed = 0;        // ticks of the stream
  PerAxis<double> deviation_rad{};  // largest distance of the commanded joints from the stream
  ARMATURE_MEMBERS(StreamEnded, tag, how, tick, followed, deviation_rad)
};

}  // namespace armature
