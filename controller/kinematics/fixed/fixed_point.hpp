// Arms, poses and angles as integers, for a block of the logic that solves the closed forms without floating point.
//
//   length          24 fraction bits of a unit of 2^e mm, which the arm determines; below 128 units
//   rotation entry  30 fraction bits
//   angle           binary: 2^32 is a turn, signed
//
// Each number is rounded to nearest. On a motor with 10 000 pulses per revolution and a gear of 50:1, a pulse is 8 590
// steps of a binary angle.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "controller/kinematics/transform.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

inline constexpr int kLengthBits = 24;
inline constexpr int kEntryBits = 30;

struct FixedArm {
  int unit_exponent = 0;  // e: the unit of length is 2^e mm
  bool five_r = false;
  std::int32_t a1 = 0, d1 = 0, a4 = 0;
  std::int32_t a2 = 0, forearm = 0;  // > 0; their sum is below 32 units. The forearm is hypot(a3, d4), or a3 (kFiveR)
  std::int32_t hand = 0;             // d6, or d5
  std::int32_t phi = 0;              // angle atan2(d4, a3); 0 for kFiveR
};

// The smallest unit in which a2 and the forearm together are below 32 and each other length is below 128. Nothing for
// kNone.
[[nodiscard]] std::optional<FixedArm> fixed_arm(const ArmGeometry& arm) noexcept;

struct FixedPose {
  std::array<std::int32_t, 9> rotation{};  // column by column
  std::array<std::int32_t, 3> position{};
};
// Nothing if a coordinate is 128 units or more, which no such arm reaches, or is no number. The pose must be rigid.
[[nodiscard]] std::optional<FixedPose> fixed_pose(const Transform& base_T_flange, const FixedArm& arm) noexcept;

// Whole turns are dropped. |angle_rad| <= kLargestTheta_rad.
[[nodiscard]] std::int32_t binary_angle(double angle_rad) noexcept;
// In [-pi, pi).
[[nodiscard]] double radians_of(std::int32_t binary_angle) noexcept;

}  // namespace armature
