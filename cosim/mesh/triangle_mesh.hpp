// The surface of a part as triangles, for pictures of the arm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace armature::cosim {

struct TriangleMesh {
  static constexpr int kDigits = 2;  // of mm: corners are rounded to 0.01 mm

  std::vector<std::array<std::int32_t, 3>> corners;     // x, y, z [0.01 mm], each place once
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of three corners, counterclockwise from outside
};

}  // namespace armature::cosim
