// A command for a pin of the tool was executed.
#pragma once

#include <cstdint>

#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"

namespace armature {

struct IoDone {
  Tag tag{};             // of the command
  std::uint8_t pin = 0;  // 1..16
  bool level = false;    // the level that was set or sampled
  ARMATURE_MEMBERS(IoDone, tag, pin, level)
};

}  // namespace armature
