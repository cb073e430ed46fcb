// The six coordinates of a G-code program, X Y Z A B C.
#pragma once

#include <array>
#include <cstddef>

namespace armature::gcode {

inline constexpr std::size_t kAxes = 6;
inline constexpr std::array<char, kAxes> kAxisLetters{'x', 'y', 'z', 'a', 'b', 'c'};

// X Y Z in mm, A B C in degrees.
using Axes6 = std::array<double, kAxes>;

inline constexpr double kMmPerInch = 25.4;

// The plane of arcs and drilling cycles: G17, G18, G19.
enum class Plane : unsigned char { kXy, kXz, kYz };

// Indexes of the two axes in the plane, and of the axis that is perpendicular to it. First, second and normal are
// right-handed, so the plane of G18 is Z-X.
struct PlaneAxes {
  std::size_t first;
  std::size_t second;
  std::size_t normal;
};
[[nodiscard]] constexpr PlaneAxes axes_of(Plane plane) noexcept {
  if (plane == Plane::kXy) return {.first = 0, .second = 1, .normal = 2};
  if (plane == Plane::kXz) return {.first = 2, .second = 0, .normal = 1};
  return {.first = 1, .second = 2, .normal = 0};
}

}  // namespace armature::gcode
