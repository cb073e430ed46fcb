// A request of core 1 to home axes, or to stop this.
#pragma once

#include <cstdint>

#include "controller/base/tag.hpp"

namespace armature {

struct HomingRequest {
  std::uint8_t axes = 0;  // mask, bit 0 for axis 1; 0: come to rest
  Tag tag{};              // of the command
};

}  // namespace armature
