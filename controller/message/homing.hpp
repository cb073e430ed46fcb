// The events of homing, for each axis.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

struct HomingStarted {
  Tag tag{};              // of the command
  std::uint8_t axis = 0;  // 1..6
  Ticks tick{};           // that computes the first step
  ARMATURE_MEMBERS(HomingStarted, tag, axis, tick)
};

enum class HomingEnd : std::uint8_t {
  kHomed,        // the joint angle is known, and the axis stands at its home position
  kNoSwitch,     // no home switch between the limit switches, or within the travel of the axis
  kSwitchStuck,  // the home switch stayed active within the travel of the axis
  kNoIndex,      // no index pulse within a revolution of the motor
  kIndexAtEdge,  // the index pulse is so close to the edge of the home switch that the next run could find another one
  kLimit,        // a limit switch where none is expected
  kStop,         // a Stop or a Hold; or another axis has failed
  kFault,
};

// Which switch the axis met first.
enum class HomingSwitch : std::uint8_t {
  kNone,
  kHome,    // the home switch, in the direction of the search
  kOnHome,  // the axis stood on the home switch
  kLimit,   // a limit switch: the axis turned round
};

struct HomingEnded {
  Tag tag{};  // as in HomingStarted, like `axis`
  std::uint8_t axis = 0;
  HomingEnd how = HomingEnd::kHomed;
  HomingSwitch met = HomingSwitch::kNone;
  Ticks tick{};   // in which the axis stands, or the fault begins
  Ticks taken{};  // from the first step
  // kHomed only. Distance from the edge of the switch to the index, without sign, and what the counts of the encoder
  // had to be raised by.
  Counts edge_to_index{};
  Counts shift{};
  ARMATURE_MEMBERS(HomingEnded, tag, axis, how, met, tick, taken, edge_to_index, shift)
};

}  // namespace armature
