// Angles modulo whole turns.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace armature {

inline constexpr double kTurn_rad = 2.0 * std::numbers::pi;

// std::floor(turns). Most processors have no instruction for it, and a call takes as long as the rest of a choice of
// turns.
[[nodiscard]] inline double whole_turns(double turns) noexcept {
  constexpr double kExact = 1e9;
  if (!(std::fabs(turns) < kExact)) return std::floor(turns);
  const double towards_zero = static_cast<double>(static_cast<std::int64_t>(turns));
  return towards_zero > turns ? towards_zero - 1.0 : towards_zero;
}

// angle_rad + n turns in [-pi, pi]. An angle already there is returned bit for bit.
[[nodiscard]] inline double wrapped(double angle_rad) noexcept {
  if (std::fabs(angle_rad) <= std::numbers::pi) return angle_rad;
  return angle_rad - kTurn_rad * whole_turns(angle_rad / kTurn_rad + 0.5);
}

// angle_rad + n turns nearest to reference_rad. An angle within half a turn of it is returned bit for bit.
[[nodiscard]] inline double nearest_turn(double angle_rad, double reference_rad) noexcept {
  if (std::fabs(angle_rad - reference_rad) <= std::numbers::pi) return angle_rad;
  return angle_rad + kTurn_rad * whole_turns((reference_rad - angle_rad) / kTurn_rad + 0.5);
}

// The angle half a turn away, for an angle in [-pi, pi], in the same range.
[[nodiscard]] inline double opposite(double angle_rad) noexcept {
  return angle_rad > 0.0 ? angle_rad - std::numbers::pi : angle_rad + std::numbers::pi;
}

}  // namespace armature
