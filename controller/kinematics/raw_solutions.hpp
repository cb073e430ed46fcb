// The results of the closed forms of both arm families: Denavit-Hartenberg angles, without limits, vendor's signs and
// selection. Arm converts them to IkSolutions and IkTracking; no other code should need them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/kinematics/ik_result.hpp"

namespace armature {

// theta_1 .. theta_6 [rad] of the Denavit-Hartenberg model. kFiveR: theta[5] is 0.
using Theta = PerAxis<double>;

// The largest angle that the kinematics accept, 16 000 turns: the sum of three is still in the range of base/math.hpp.
// Previous angles beyond it, or not finite, are refused as kInvalidInput.
inline constexpr double kLargestTheta_rad = 1e5;

[[nodiscard]] inline bool are_angles(const Theta& theta) noexcept {
  bool all = true;
  for (const double angle_rad : theta) all = all && std::fabs(angle_rad) <= kLargestTheta_rad;
  return all;
}

struct RawBranch {
  Theta theta{};             // each in [-pi, pi]
  std::int8_t shoulder = 1;  // flags as in IkBranch
  std::int8_t elbow = 1;
  std::int8_t flip = 1;
  std::uint8_t singular = 0;  // mask of Singularity
  bool clamped = false;       // beyond the reach by at most 1e-9 of it, and set to the limit
};

// All branches of one pose, in the order of IkSolutions.
struct RawSolutions {
  std::array<RawBranch, IkSolutions::kMax> branches{};
  std::size_t count = 0;

  IkStatus status = IkStatus::kUnreachable;  // kOk (count > 0), kUnreachable, kOrientation or kInvalidInput
  double margin_mm = 0.0;                    // kUnreachable: > 0, of the shoulder that misses by least
  double residual_rad = 0.0;                 // kFiveR: as in IkSolutions, also with kOrientation
};

// The branch nearest to the previous angles: theta[i] within pi of previous[i], whole turns kept.
struct RawTracking {
  Theta theta{};  // valid when found, see IkTracking
  bool found = false;
  IkStatus status = IkStatus::kUnreachable;  // kOk, kClamped, kSingular, kUnreachable, kOrientation or kInvalidInput
  std::uint8_t singular = 0;
  double margin_mm = 0.0;
  double residual_rad = 0.0;
};

// Positive and negative on the two sides of a singularity, 0 there; the signs are those of the flags of a branch.
struct RawSides {
  double shoulder = 0.0;  // distance from axis 1 as a share of the reach
  double elbow = 0.0;     // sine of the angle between the links
  double flip = 0.0;      // sin(theta_5); 0 for kFiveR
};

// The status of a branch that exists. If several apply, the most specific one.
[[nodiscard]] constexpr IkStatus status_of(std::uint8_t singular, bool clamped) noexcept {
  if (clamped) return IkStatus::kClamped;
  return (singular & ~kElbowSingular) != 0 ? IkStatus::kSingular : IkStatus::kOk;
}
[[nodiscard]] constexpr IkStatus status_of(const RawBranch& branch) noexcept {
  return status_of(branch.singular, branch.clamped);
}

}  // namespace armature
