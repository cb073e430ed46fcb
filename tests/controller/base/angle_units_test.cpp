#include "controller/base/angle_units.hpp"

#include <gtest/gtest.h>

namespace armature {
namespace {

TEST(DirectionRad, IsTheProductBelowATurn) {
  for (const double deg : {0.0, 1e-300, 0.1, 30.0, 359.999999, -0.1, -359.999999}) {
    EXPECT_EQ(direction_rad(deg), deg * kRadPerDeg) << deg;
  }
}

TEST(DirectionRad, LeavesTheRestOfWholeTurnsExactly) {
  EXPECT_EQ(direction_rad(360.0), 0.0);
  EXPECT_EQ(direction_rad(-450.0), -90.0 * kRadPerDeg);
  EXPECT_EQ(direction_rad(1e22), 280.0 * kRadPerDeg);    // 10^22 = 360 n + 280
  EXPECT_EQ(direction_rad(0x1p70), 304.0 * kRadPerDeg);  // 2^70 = 360 n + 304
}

}  // namespace
}  // namespace armature
