// Arms, poses and angles as integers.
#include "controller/kinematics/fixed/fixed_point.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature::test {
namespace {

TEST(FixedPoint, UnitIsTheSmallestThatHoldsTheArm) {
  const FixedArm hu = fixed_arm(hu_arm()).value();
  EXPECT_TRUE(hu.five_r);
  EXPECT_EQ(hu.unit_exponent, 0);  // 10 + 9.5 < 32
  EXPECT_EQ(hu.a1, std::lround(1.1 * (1 << 24)));
  EXPECT_EQ(hu.a2, 10 << 24);
  EXPECT_EQ(hu.forearm, std::lround(9.5 * (1 << 24)));
  EXPECT_EQ(hu.a4, std::lround(3.2 * (1 << 24)));
  EXPECT_EQ(hu.hand, std::lround(14.5 * (1 << 24)));
  EXPECT_EQ(hu.phi, 0);

  const FixedArm irb120 = fixed_arm(irb120_geometry()).value();
  EXPECT_FALSE(irb120.five_r);
  EXPECT_EQ(irb120.unit_exponent, 5);  // (270 + 310) mm < 32 * 32 mm
  EXPECT_EQ(irb120.a2, 270 << 19);
  EXPECT_EQ(irb120.d1, 290 << 19);
  EXPECT_EQ(irb120.hand, 72 << 19);
  EXPECT_EQ(irb120.forearm, std::lround(310.006451 * (1 << 19)));
  EXPECT_NEAR(radians_of(irb120.phi), std::atan2(302, 70), 1e-9);
}

TEST(FixedPoint, LinksStayBelow32UnitsAndLengthsBelow128) {
  for (const double d6 : {1.0, 79.0, 80.0, 127.99999999, 128.0, 500.0}) {
    for (const double a2 : {1.0, 15.0, 16.0, 16.9999999999, 17.0, 40.0}) {
      const ArmGeometry arm = six_r_geometry(0, a2, 0, 0, 15, d6);
      const FixedArm fixed = fixed_arm(arm).value();
      EXPECT_LT(fixed.a2 + fixed.forearm, 1 << 29);
      EXPECT_LT(std::abs(static_cast<std::int64_t>(fixed.hand)), std::int64_t{1} << 31);
      const double smaller = std::ldexp(1.0, fixed.unit_exponent - 1);
      EXPECT_TRUE(a2 + 15 >= 31.999 * smaller || d6 >= 127.999 * smaller) << a2 << ' ' << d6;
    }
  }
  EXPECT_FALSE(fixed_arm(ArmGeometry{}).has_value());
}

TEST(FixedPoint, PoseIsRoundedToNearestColumnByColumn) {
  const FixedArm arm = fixed_arm(hu_arm()).value();
  Transform pose;
  pose.rotation << 0.0, -1.0, 0x1.8p-31, 1.0, 0.0, 0x1.7p-31, -0x1.1p-31, 0.5, 1.0;
  pose.position_mm << 1.5, -127.5, 0x1p-25;
  const FixedPose fixed = fixed_pose(pose, arm).value();
  EXPECT_EQ(fixed.rotation, (std::array<std::int32_t, 9>{0, 1 << 30, -1, -(1 << 30), 0, 1 << 29, 1, 1, 1 << 30}));
  EXPECT_EQ(fixed.position, (std::array<std::int32_t, 3>{3 << 23, -255 * (1 << 23), 1}));
}

TEST(FixedPoint, PoseFarAwayIsRefused) {
  const FixedArm arm = fixed_arm(hu_arm()).value();
  for (const double far : {128.0, -128.0, 1e9, std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (int row = 0; row < 3; ++row) {
      Transform pose;
      pose.position_mm(row) = far;
      EXPECT_FALSE(fixed_pose(pose, arm).has_value()) << far;
      pose.position_mm(row) = std::copysign(127.999, far);
      EXPECT_TRUE(fixed_pose(pose, arm).has_value()) << far;
    }
  }
}

TEST(FixedPoint, AnglesLoseWholeTurnsOnly) {
  EXPECT_EQ(binary_angle(0.0), 0);
  EXPECT_EQ(binary_angle(kPi / 2), 1 << 30);
  EXPECT_EQ(binary_angle(kPi), INT32_MIN);
  EXPECT_EQ(binary_angle(-kPi), INT32_MIN);
  EXPECT_EQ(binary_angle(-kPi / 2 + 14'000 * kPi), -(1 << 30));
  EXPECT_EQ(radians_of(INT32_MIN), -kPi);
  Random random{5};
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.real(-1e5, 1e5);
    EXPECT_LT(std::fabs(std::remainder(radians_of(binary_angle(angle)) - angle, 2 * kPi)), 1e-9);
  }
}

}  // namespace
}  // namespace armature::test
