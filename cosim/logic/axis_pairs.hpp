// A number of each axis, so that one instruction computes two axes (the vectors of GCC and Clang). Each is computed as
// a double alone, so the bits do not depend on the processor.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "controller/base/axes.hpp"

namespace armature::cosim {

using Pair = double __attribute__((vector_size(16)));
// Whole numbers; of a comparison: all bits of a lane are 1 where it holds.
using WholePair = std::int64_t __attribute__((vector_size(16)));

inline constexpr std::size_t kAxisPairs = kAxes / 2;
static_assert(kAxes % 2 == 0);

template <class Lane>
struct PairOf;
template <>
struct PairOf<double> {
  using Type = Pair;
};
template <>
struct PairOf<std::int64_t> {
  using Type = WholePair;
};

// Lane: double or std::int64_t.
template <class Lane>
class alignas(16) AxisLanes {
 public:
  using PairOfLanes = typename PairOf<Lane>::Type;

  constexpr AxisLanes() = default;

  [[nodiscard]] constexpr Lane operator[](std::size_t axis) const { return lanes_[axis]; }
  [[nodiscard]] constexpr Lane& operator[](std::size_t axis) { return lanes_[axis]; }
  constexpr void fill(Lane lane) { lanes_.fill(lane); }

  // Axes 2 i + 1 and 2 i + 2 of the user.
  [[nodiscard]] PairOfLanes pair(std::size_t i) const {
    PairOfLanes pair;
    std::memcpy(&pair, std::assume_aligned<16>(&lanes_[2 * i]), sizeof pair);
    return pair;
  }
  void set_pair(std::size_t i, PairOfLanes pair) {
    std::memcpy(std::assume_aligned<16>(&lanes_[2 * i]), &pair, sizeof pair);
  }

 private:
  PerAxis<Lane> lanes_{};
};
using AxisNumbers = AxisLanes<double>;
using AxisIntegers = AxisLanes<std::int64_t>;

[[nodiscard]] inline Pair both(double number) {
  return Pair{number, number};
}
[[nodiscard]] inline WholePair bits_of(Pair pair) {
  return std::bit_cast<WholePair>(pair);
}
// The lanes of the mask, 0 elsewhere.
[[nodiscard]] inline Pair only(WholePair mask, Pair pair) {
  return std::bit_cast<Pair>(bits_of(pair) & mask);
}
[[nodiscard]] inline Pair magnitude(Pair pair) {
  constexpr std::int64_t kNoSign = 0x7FFF'FFFF'FFFF'FFFF;
  return only(WholePair{kNoSign, kNoSign}, pair);
}
// The largest power of two that is not above the magnitude; 0 of 0.
[[nodiscard]] inline Pair power_of_two(Pair pair) {
  constexpr std::int64_t kExponent = 0x7FF0'0000'0000'0000;
  return only(WholePair{kExponent, kExponent}, pair);
}
[[nodiscard]] inline Pair smaller(Pair a, Pair b) {
  return a < b ? a : b;
}
[[nodiscard]] inline Pair larger(Pair a, Pair b) {
  return a > b ? a : b;
}
[[nodiscard]] inline bool any(WholePair mask) {
  return (mask[0] | mask[1]) != 0;
}

// ---- lanes from 0 to below 2^31

// Rounded down to whole numbers.
[[nodiscard]] inline Pair without_fraction(Pair pair) {
  using Integers = std::int32_t __attribute__((vector_size(8)));
  return __builtin_convertvector(__builtin_convertvector(pair, Integers), Pair);
}

// ---- lanes below 2^51 in magnitude

inline constexpr double kWholeUnits = 0x1.8p52;  // numbers around it are whole, and their lowest bits count them

// Rounded down to whole numbers.
[[nodiscard]] inline Pair rounded_down(Pair pair) {
  const Pair nearest = (pair + both(kWholeUnits)) - both(kWholeUnits);
  return nearest - only(nearest > pair, both(1.0));
}
// Of whole numbers.
[[nodiscard]] inline WholePair whole_numbers(Pair pair) {
  return bits_of(pair + both(kWholeUnits)) - bits_of(both(kWholeUnits));
}

}  // namespace armature::cosim
