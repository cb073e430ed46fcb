// The offsets between the coordinates of a program and those of the machine.
#pragma once

#include <bitset>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/language/gcode/reader/axes6.hpp"

namespace armature::gcode {

inline constexpr int kMaxTools = 64;
using ToolNumbers = std::bitset<kMaxTools>;  // 0 is no tool

// machine = g5x + tool + R(place + g92), where R turns X and Y by the rotation of the coordinate system.
struct Offsets {
  Axes6 g5x{};
  Axes6 g92{};
  Axes6 tool{};
  double rotation_deg = 0.0;

  [[nodiscard]] Axes6 machine(Axes6 place) const noexcept {
    for (std::size_t i = 0; i < kAxes; ++i) place[i] += g92[i];
    place = turned(place, rotation_deg);
    for (std::size_t i = 0; i < kAxes; ++i) place[i] += g5x[i] + tool[i];
    return place;
  }
  [[nodiscard]] Axes6 place(Axes6 machine) const noexcept {
    for (std::size_t i = 0; i < kAxes; ++i) machine[i] -= g5x[i] + tool[i];
    machine = turned(machine, -rotation_deg);
    for (std::size_t i = 0; i < kAxes; ++i) machine[i] -= g92[i];
    return machine;
  }

 private:
  static Axes6 turned(Axes6 axes, double deg) noexcept {
    if (deg == 0.0) return axes;
    const math::SinCos by = math::sin_cos(direction_rad(deg));
    const double x = axes[0];
    axes[0] = x * by.cos - axes[1] * by.sin;
    axes[1] = x * by.sin + axes[1] * by.cos;
    return axes;
  }
};

}  // namespace armature::gcode
