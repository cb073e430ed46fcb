// The events of a jog: it starts with the first command that finds the arm at rest, and ends at rest without a command.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

struct JogStarted {
  Tag tag{};     // of the command
  Ticks tick{};  // that computes the first step
  ARMATURE_MEMBERS(JogStarted, tag, tick)
};

// The reason why a jog ended.
enum class JogEnd : std::uint8_t {
  kDuration,      // the duration of its only command had passed
  kTimeOut,       // it had several commands, and the duration of the last one passed without another one
  kReleased,      // the last command had no velocity
  kLimit,         // a joint with a velocity stood at its soft limit until the duration of the last command had passed
  kCannotFollow,  // the joints could not move the tool on: a singularity, or the limit of the reach
  kStop,          // Stop
  kHold,          // Hold
  kFault,
};

struct JogEnded {
  Tag tag{};  // as in JogStarted
  JogEnd how = JogEnd::kDuration;
  std::uint8_t axis = 0;       // kLimit: 1..6; otherwise 0
  Ticks tick{};                // of the last step; kFault: in which the fault began
  Ticks taken{};               // from the first step to the last, both included
  std::uint32_t commands = 1;  // that core 0 received; core 1 sends only the latest of those that come together
  ARMATURE_MEMBERS(JogEnded, tag, how, axis, tick, taken, commands)
};

}  // namespace armature
