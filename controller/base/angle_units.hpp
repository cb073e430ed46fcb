// Between the degrees of files, programs and messages and the radians of the controller.
#pragma once

#include <cmath>
#include <numbers>

namespace armature {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

// The direction of an angle [deg], in radians: its whole turns are removed without an error. So math::sin() accepts
// each finite angle that a program can write. For |deg| < 360 it is deg * kRadPerDeg, bit for bit.
[[nodiscard]] inline double direction_rad(double deg) noexcept {
  return std::fmod(deg, 360.0) * kRadPerDeg;
}

}  // namespace armature
