// Words with one bit per axis; axis 1 is bit 0.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"

namespace armature::cosim {

inline constexpr std::uint8_t kAllAxes = (1u << kAxes) - 1;

[[nodiscard]] constexpr std::uint8_t bit_of(std::size_t axis) {
  return static_cast<std::uint8_t>(1u << axis);
}

[[nodiscard]] constexpr bool has_bit(std::uint32_t bits, std::size_t axis) {
  return (bits >> axis & 1u) != 0;
}

constexpr void set_bit(std::uint8_t& bits, std::size_t axis, bool level) {
  bits = static_cast<std::uint8_t>((bits & ~bit_of(axis)) | (level ? bit_of(axis) : 0));
}

// Calls `action` with the number of each bit that is set, the lowest one first.
template <class Action>
constexpr void for_each_bit(std::uint64_t bits, Action action) {
  for (; bits != 0; bits &= bits - 1) action(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace armature::cosim
