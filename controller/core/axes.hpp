// The number of axes and the per-axis array that every part uses. Axis 1 of the user is index 0.
#pragma once

#include <array>
#include <cstddef>

namespace armature {

inline constexpr std::size_t kAxes = 6;

template <class T>
using PerAxis = std::array<T, kAxes>;

}  // namespace armature
