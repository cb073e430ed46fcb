// Strong types for physical quantities, so that the compiler finds a mix-up.
//
// Each unit is a Quantity with its own tag. Values of one unit add, subtract and compare; there is no implicit
// conversion. Only robot/axis_units.hpp converts between units. Inside a formula a plain double with a suffix (_rad
// _rad_s _s) is used.
#pragma once

#include <compare>
#include <cstdint>

namespace armature {

template <class Tag, class Rep>
class Quantity {
 public:
  using rep = Rep;

  constexpr Quantity() noexcept = default;
  constexpr explicit Quantity(Rep value) noexcept : value_{value} {}

  [[nodiscard]] constexpr Rep value() const noexcept { return value_; }

  constexpr Quantity& operator+=(Quantity other) noexcept { return value_ += other.value_, *this; }
  constexpr Quantity& operator-=(Quantity other) noexcept { return value_ -= other.value_, *this; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) noexcept { return Quantity{a.value_ + b.value_}; }
  friend constexpr Quantity operator-(Quantity a, Quantity b) noexcept { return Quantity{a.value_ - b.value_}; }
  friend constexpr Quantity operator-(Quantity a) noexcept { return Quantity{-a.value_}; }
  friend constexpr auto operator<=>(Quantity, Quantity) noexcept = default;

 private:
  Rep value_{};
};

template <class T>
concept Unit = requires(const T& value) {
  typename T::rep;
  value.value();
};

using Radians = Quantity<struct RadiansTag, double>;      // joint side, user sign convention
using Pulses = Quantity<struct PulsesTag, std::int64_t>;  // commands to a drive, absolute or per tick
using Counts = Quantity<struct CountsTag, std::int64_t>;  // encoder counts, four per line, motor side
using Cycles = Quantity<struct CyclesTag, std::int64_t>;  // programmable-logic clock cycles, 20 ns
using Ticks = Quantity<struct TicksTag, std::int64_t>;    // control periods, 50 us

}  // namespace armature
