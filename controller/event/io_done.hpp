// A command for a pin of the tool was executed.
#pragma once

#include <cstdint>

#include "controller/core/tag.hpp"

namespace armature {

struct IoDone {
  Tag tag{};             // of the command
  std::uint8_t pin = 0;  // 1..16
  bool level = false;    // that the output was given, or that the input was seen to have
};

}  // namespace armature
