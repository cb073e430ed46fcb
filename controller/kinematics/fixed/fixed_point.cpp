#include "controller/kinematics/fixed/fixed_point.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {
namespace {

constexpr double kLongestLinks = 32.0;  // a2 + forearm, in units
constexpr double kLongest = 128.0;      // any other length
constexpr double kBinaryTurn = 0x1p32;

double rounded(double value) {
  return std::floor(value + 0.5);
}

// std::ldexp and std::frexp are functions of the C library, which differs from processor to processor.
constexpr int kFractionBits = 52, kBias = 1023;  // of a double
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kBias) << kFractionBits);
}
// e of value = m * 2^e with m in [0.5, 1), of a normal value above 0.
int exponent_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> kFractionBits) - kBias + 1;
}

std::int32_t fixed_length(double length_mm, int unit_exponent) {
  return static_cast<std::int32_t>(rounded(length_mm * power_of_two(kLengthBits - unit_exponent)));
}

}  // namespace

std::optional<FixedArm> fixed_arm(const ArmGeometry& arm) noexcept {
  if (arm.family == ArmFamily::kNone) return std::nullopt;
  FixedArm fixed;
  fixed.five_r = arm.family == ArmFamily::kFiveR;
  const double forearm_mm = fixed.five_r ? arm.a3_mm : math::hypot(arm.a3_mm, arm.d4_mm);
  const double hand_mm = fixed.five_r ? arm.d5_mm : arm.d6_mm;
  const double longest_mm = std::max({std::fabs(arm.a1_mm), std::fabs(arm.d1_mm), std::fabs(arm.a4_mm),
                                      std::fabs(hand_mm), (arm.a2_mm + forearm_mm) * (kLongest / kLongestLinks)});
  // longest = m * 2^(e + 7) with m in [0.5, 1): 128 units of 2^e mm are longer, by more than the rounding unless m is
  // nearly 1.
  const int exponent = exponent_of(longest_mm);
  const double mantissa = longest_mm * power_of_two(-exponent);
  fixed.unit_exponent = exponent - 7 + (mantissa > 1.0 - 0x1p-24 ? 1 : 0);

  fixed.a1 = fixed_length(arm.a1_mm, fixed.unit_exponent);
  fixed.d1 = fixed_length(arm.d1_mm, fixed.unit_exponent);
  fixed.a4 = fixed_length(arm.a4_mm, fixed.unit_exponent);
  fixed.a2 = fixed_length(arm.a2_mm, fixed.unit_exponent);
  fixed.forearm = fixed_length(forearm_mm, fixed.unit_exponent);
  fixed.hand = fixed_length(hand_mm, fixed.unit_exponent);
  fixed.phi = fixed.five_r ? 0 : binary_angle(math::atan2(arm.d4_mm, arm.a3_mm));
  return fixed;
}

std::optional<FixedPose> fixed_pose(const Transform& base_T_flange, const FixedArm& arm) noexcept {
  FixedPose fixed;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const auto index = static_cast<std::size_t>(row);
    const double units = base_T_flange.position_mm(row) * power_of_two(-arm.unit_exponent);
    if (!(std::fabs(units) < kLongest - 0x1p-24)) return std::nullopt;
    fixed.position[index] = fixed_length(base_T_flange.position_mm(row), arm.unit_exponent);
    for (Eigen::Index column = 0; column < 3; ++column) {
      fixed.rotation[3 * static_cast<std::size_t>(column) + index] =
          static_cast<std::int32_t>(rounded(base_T_flange.rotation(row, column) * power_of_two(kEntryBits)));
    }
  }
  return fixed;
}

std::int32_t binary_angle(double angle_rad) noexcept {
  const auto steps = static_cast<std::int64_t>(rounded(angle_rad / kTurn_rad * kBinaryTurn));
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(steps)));
}

double radians_of(std::int32_t binary_angle) noexcept {
  return static_cast<double>(binary_angle) * (kTurn_rad / kBinaryTurn);
}

}  // namespace armature
