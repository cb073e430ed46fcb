// The checks of a value that has come as bytes: which of its members has a value that must not be. A type that has such
// checks has a member function:
//
//   [[nodiscard]] constexpr const void* misfit() const noexcept {
//     return first_misfit({{&count, count <= kMax}, {&mm_per_count, is_positive(mm_per_count)}});
//   }
#pragma once

#include <algorithm>
#include <initializer_list>

namespace armature {

struct MemberCheck {
  const void* member;
  bool fits;
};

// Null: all members fit.
[[nodiscard]] constexpr const void* first_misfit(std::initializer_list<MemberCheck> checks) noexcept {
  for (const MemberCheck& check : checks) {
    if (!check.fits) return check.member;
  }
  return nullptr;
}

// All false for infinities and for what is no number.
[[nodiscard]] constexpr bool is_within(double value, double low, double high) noexcept {
  return value >= low && value <= high;
}
[[nodiscard]] constexpr bool is_finite(double value) noexcept {
  return value - value == 0.0;
}
[[nodiscard]] constexpr bool is_positive(double value) noexcept {
  return value > 0.0 && is_finite(value);
}
[[nodiscard]] constexpr bool is_at_least_0(double value) noexcept {
  return value >= 0.0 && is_finite(value);
}

template <class Array>
[[nodiscard]] constexpr bool are_finite(const Array& values) noexcept {
  return std::all_of(values.begin(), values.end(), is_finite);
}

}  // namespace armature
