// The number of axes and the per-axis array that all parts use. Axis 1 of the user is index 0.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace armature {

inline constexpr std::size_t kAxes = 6;

template <class T>
using PerAxis = std::array<T, kAxes>;

// The array of make(axis) for each axis. Works for types without a default constructor.
template <class Make>
[[nodiscard]] constexpr auto make_per_axis(Make make) {
  return [&]<std::size_t... kAxis>(std::index_sequence<kAxis...>) {
    return PerAxis<decltype(make(std::size_t{0}))>{make(kAxis)...};
  }
  (std::make_index_sequence<kAxes>{});
}

}  // namespace armature
