// A command for a pin of the tool was executed.
#pragma once

#include <cstdint>

namespace armature {

struct IoDone {
  std::uint32_t tag = 0;  // of the command
  std::uint8_t pin = 0;   // 1..16
  bool level = false;     // that the output was given, or that the input was seen to have
};

}  // namespace armature
