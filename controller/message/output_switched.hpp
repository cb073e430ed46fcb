// An output was switched at a place of a path or at a time of a joint move.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"

namespace armature {

struct OutputSwitched {
  Tag tag{};             // of the move with the output
  std::uint8_t pin = 0;  // 1..16
  bool level = false;
  Ticks tick{};  // in which it was written
  ARMATURE_MEMBERS(OutputSwitched, tag, pin, level, tick)
};

}  // namespace armature
