// Between the degrees of files and messages and the radians of the controller.
#pragma once

#include <numbers>

namespace armature::cosim {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace armature::cosim
