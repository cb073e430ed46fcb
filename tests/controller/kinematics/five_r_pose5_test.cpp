// The native pose of the five-axis arm.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;

TEST(Pose5, PitchAndRollAreSumsOfTheAnglesOfAnArmThatLooksAtItsToolPoint) {
  constexpr std::uint64_t kSeed = 30;
  test::Random random{kSeed};
  const FiveR arm{hu_arm()};
  int forwards = 0;
  for (int i = 0; i < 5000; ++i) {
    const Theta theta = test::random_theta(random);
    const Transform pose = test::product_of_links(hu_arm(), theta);
    const Eigen::Vector3d outwards{std::cos(theta[0]), std::sin(theta[0]), 0.0};
    const double r = outwards.dot(pose.position_mm);
    if (r < 0.1) continue;
    ++forwards;
    const NearestPose5 nearest = arm.from_transform(pose);
    const auto difference = [](double a, double b) { return std::fabs(std::remainder(a - b, 2.0 * kPi)); };
    ASSERT_LT(difference(nearest.pose.heading_rad, theta[0]), 2e-13) << "seed " << kSeed << " " << i;
    ASSERT_LT(difference(nearest.pose.pitch_rad, theta[1] + theta[2] + theta[3]), 2e-13) << "seed " << kSeed;
    ASSERT_LT(difference(nearest.pose.roll_rad, theta[4]), 2e-13) << "seed " << kSeed << " " << i;
    ASSERT_LT(nearest.residual_rad, 1e-15);
  }
  EXPECT_GT(forwards, 1500);
}

TEST(Pose5, ReachablePosesSurviveTheRoundTripExactly) {
  constexpr std::uint64_t kSeed = 31;
  test::Random random{kSeed};
  const FiveR arm{hu_arm()};
  for (int i = 0; i < 20'000; ++i) {
    const Transform pose = test::product_of_links(hu_arm(), test::random_theta(random));
    const Transform back = arm.to_transform(arm.from_transform(pose).pose);
    ASSERT_LT(test::rotation_difference(back, pose), 4e-15) << "seed " << kSeed << " " << i;
    ASSERT_EQ(back.position_mm, pose.position_mm) << "seed " << kSeed << " " << i;
  }
}

TEST(Pose5, TheHeadingIsReadOnAxis1Alone) {
  const FiveR arm{hu_arm()};
  Pose5 pose{.x_mm = 3.0, .y_mm = 4.0, .z_mm = 5.0, .pitch_rad = -0.7, .roll_rad = 0.4, .heading_rad = 0.0};
  const Transform off_axis = arm.to_transform(pose);
  pose.heading_rad = 2.0;
  EXPECT_EQ(arm.to_transform(pose).rotation, off_axis.rotation);
  EXPECT_NEAR(std::atan2(off_axis.rotation(1, 2), off_axis.rotation(0, 2)), std::atan2(4.0, 3.0), 1e-15);

  pose.x_mm = pose.y_mm = 0.0;
  const Transform on_axis = arm.to_transform(pose);
  EXPECT_NEAR(std::atan2(on_axis.rotation(1, 2), on_axis.rotation(0, 2)), 2.0, 1e-15);
  const NearestPose5 nearest = arm.from_transform(on_axis);
  EXPECT_NEAR(nearest.pose.heading_rad, 2.0, 1e-15);
  EXPECT_NEAR(nearest.pose.pitch_rad, -0.7, 1e-15);
  EXPECT_NEAR(nearest.pose.roll_rad, 0.4, 1e-15);
}

TEST(Pose5, AHeadingThatLooksAwayFromTheToolPointIsNotTaken) {
  const FiveR arm{hu_arm()};
  const Pose5 pose{.x_mm = 3.0, .y_mm = 0.0, .z_mm = 5.0, .pitch_rad = -0.7, .roll_rad = 0.4, .heading_rad = kPi};
  EXPECT_GT(arm.to_transform(pose).rotation(0, 2), 0.6);
}

TEST(Pose5, TheCallersHeadingIsUsedWhereNothingElseGivesOne) {
  const FiveR arm{hu_arm()};
  Transform pose;
  pose.rotation << 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0;
  pose.position_mm << 0.0, 0.0, -30.0;
  for (const double heading : {0.0, 1.3, -2.5}) {
    const NearestPose5 nearest = arm.from_transform(pose, heading);
    EXPECT_EQ(nearest.pose.heading_rad, heading);
    EXPECT_LT(test::rotation_difference(arm.to_transform(nearest.pose), pose), 1e-15);
  }
}

TEST(Pose5, PitchZeroLooksDownAndAQuarterTurnBackOutwards) {
  const FiveR arm{hu_arm()};
  const Pose5 down{.x_mm = 0.0, .y_mm = 12.0, .z_mm = 1.0};
  EXPECT_LT((arm.to_transform(down).rotation.col(2) - Eigen::Vector3d{0.0, 0.0, -1.0}).norm(), 1e-15);
  EXPECT_LT((arm.to_transform(down).rotation.col(1) - Eigen::Vector3d{1.0, 0.0, 0.0}).norm(), 1e-15);
  const Pose5 outwards{.x_mm = 0.0, .y_mm = 12.0, .z_mm = 1.0, .pitch_rad = -kPi / 2};
  EXPECT_LT((arm.to_transform(outwards).rotation.col(2) - Eigen::Vector3d{0.0, 1.0, 0.0}).norm(), 1e-15);
}

}  // namespace
}  // namespace armature
