// Two doubles that are computed together, in the two lanes of a vector. The operations on a lane are those of plain
// doubles, so a result does not depend on its neighbour. For code whose branches are not predictable: here both sides
// are computed, and masks select.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "controller/base/double_bits.hpp"

namespace armature::math {

// An extension that g++ and clang++ have for every processor.
using Lanes = double __attribute__((vector_size(16)));
using Masks = std::int64_t __attribute__((vector_size(16)));

// Whether the processor computes both at once. If not, one after the other with branches takes fewer instructions.
#ifdef __arm__
inline constexpr bool kComputesLanes = false;
#else
inline constexpr bool kComputesLanes = true;
#endif

[[nodiscard]] inline Lanes all_lanes(double value) noexcept {
  return Lanes{value, value};
}
[[nodiscard]] inline Masks all_lanes(std::uint64_t bits) noexcept {
  return Masks{} + static_cast<std::int64_t>(bits);
}
[[nodiscard]] inline Masks bits_of(Lanes v) noexcept {
  return std::bit_cast<Masks>(v);
}
[[nodiscard]] inline Lanes masked(Lanes v, Masks bits) noexcept {
  return std::bit_cast<Lanes>(bits_of(v) & bits);
}
[[nodiscard]] inline Lanes flip_signs(Lanes v, Masks sign_bits) noexcept {
  return std::bit_cast<Lanes>(bits_of(v) ^ sign_bits);
}
[[nodiscard]] inline Lanes magnitude(Lanes v) noexcept {
  return masked(v, ~all_lanes(kSignBit));
}
[[nodiscard]] inline Lanes high_part(Lanes v) noexcept {
  return masked(v, all_lanes(kHighBits));
}
// Of conditions: all bits of a lane are 1 (true) or 0.
[[nodiscard]] inline Lanes select(Masks condition, Lanes yes, Lanes no) noexcept {
  return std::bit_cast<Lanes>((condition & bits_of(yes)) | (~condition & bits_of(no)));
}
[[nodiscard]] inline bool both(Masks condition) noexcept {
  return (condition[0] & condition[1]) != 0;
}

}  // namespace armature::math
