// The lines before which the operator wants a program to pause.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "controller/language/program/program_port.hpp"

namespace armature {

class Breakpoints {
 public:
  static constexpr std::size_t kMax = 16;

  // No effect if the place has one. False: there are kMax already.
  [[nodiscard]] constexpr bool add(ProgramPlace place) noexcept {
    if (contains(place)) return true;
    if (count_ == kMax) return false;
    places_[count_++] = place;
    return true;
  }
  // No effect if the place has none.
  constexpr void remove(ProgramPlace place) noexcept {
    const auto end = places_.begin() + static_cast<std::ptrdiff_t>(count_);
    count_ = static_cast<std::size_t>(std::remove(places_.begin(), end, place) - places_.begin());
  }
  constexpr void clear() noexcept { count_ = 0; }

  [[nodiscard]] constexpr bool contains(ProgramPlace place) const noexcept {
    return std::ranges::count(std::span{places_}.first(count_), place) > 0;
  }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }

 private:
  std::array<ProgramPlace, kMax> places_{};
  std::size_t count_ = 0;
};

}  // namespace armature
