// What homing begins with.
#pragma once

#include <cstdint>

#include "controller/base/tag.hpp"

namespace armature {

struct HomingRequest {
  std::uint8_t axes = 0;  // mask, bit 0 for axis 1; not 0
  Tag tag{};              // of the command
};

}  // namespace armature
