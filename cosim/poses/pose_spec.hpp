// A pose in the user's units.
#pragma once

#include <array>

namespace armature::cosim {

// A pose or a shift of the tool centre point, as rotations about the fixed x, then y, then z axis.
struct PoseSpec {
  std::array<double, 3> xyz_mm{};
  std::array<double, 3> rpy_deg{};
};

}  // namespace armature::cosim
