// Following paths with the five-axis arm.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;

Theta nearest_of_inverse(const RawSolutions& solutions, const Theta& previous) {
  Theta best{};
  double least = 1e9;
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const double distance = test::angle_distance(solutions.branches[i].theta, previous);
    if (distance < least) {
      least = distance;
      best = solutions.branches[i].theta;
    }
  }
  return best;
}

TEST(FiveRTrack, IsTheNearestBranchOfTheInverseOnSmoothPaths) {
  constexpr std::uint64_t kSeed = 40;
  test::Random random{kSeed};
  const FiveR arm{hu_arm()};
  for (int path = 0; path < 200; ++path) {
    Theta from = test::random_theta(random);
    for (std::size_t joint = 0; joint < 5; ++joint)
      from[joint] += 2.0 * kPi * static_cast<double>(random.integer(-2, 2));
    const Theta speed = test::random_theta(random);
    Theta followed = from;
    bool lost = false;  // near a double root either branch is right: the path is followed no further
    for (int step = 1; step <= 100 && !lost; ++step) {
      Theta theta = from;
      for (std::size_t joint = 0; joint < 5; ++joint) theta[joint] += 0.01 * step * speed[joint];
      const Manipulability far = arm.manipulability(theta);
      lost = far.elbow < 0.1 || far.shoulder < 0.1;
      if (lost) break;
      const Transform pose = arm.forward(theta);
      const RawTracking tracking = arm.track(pose, followed);
      ASSERT_EQ(tracking.status, IkStatus::kOk) << "seed " << kSeed << " path " << path << " step " << step;
      const Theta nearest = nearest_of_inverse(arm.inverse(pose, followed), followed);
      ASSERT_LT(test::angle_distance(tracking.theta, nearest), 1e-15) << "seed " << kSeed << " path " << path;
      for (std::size_t joint = 0; joint < 5; ++joint) {  // whole turns are kept, too
        ASSERT_NEAR(tracking.theta[joint], theta[joint], 1e-10) << "seed " << kSeed << " path " << path;
      }
      followed = tracking.theta;
    }
  }
}

TEST(FiveRTrack, AVerticalToolCrossesAxis1WithoutTurning) {
  const FiveR arm{hu_arm()};
  Transform pose;
  pose.rotation << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0;
  pose.position_mm << 1.0, 0.0, -30.0;
  Theta previous = arm.inverse(pose, Theta{}).branches[0].theta;
  const double theta1 = previous[0];
  bool crossed = false;
  for (int step = 100; step >= -100; --step) {
    pose.position_mm.x() = 0.01 * step;
    const RawTracking tracking = arm.track(pose, previous);
    ASSERT_TRUE(solved(tracking.status)) << step;
    EXPECT_EQ(tracking.singular == kShoulderSingular, step == 0) << step;
    EXPECT_EQ(tracking.status, step == 0 ? IkStatus::kSingular : IkStatus::kOk) << step;
    EXPECT_NEAR(tracking.theta[0], theta1, 1e-12) << step;
    EXPECT_LT(test::angle_distance(tracking.theta, previous), 0.01) << step;
    EXPECT_LT(test::position_difference_mm(arm.forward(tracking.theta), pose), 1e-12) << step;
    crossed = crossed || step < 0;
    previous = tracking.theta;
  }
  EXPECT_TRUE(crossed);
}

TEST(FiveRTrack, ATiltedToolCrossesAxis1WithoutTurningThoughTheInverseChangesItsShoulder) {
  const FiveR arm{hu_arm()};
  const Pose5 start{.x_mm = 1.0, .y_mm = 0.0, .z_mm = -25.0, .pitch_rad = -0.4, .roll_rad = 0.3, .heading_rad = 0.0};
  Transform pose = arm.to_transform(start);
  Theta previous = arm.inverse(pose, Theta{}).branches[0].theta;
  ASSERT_EQ(arm.inverse(pose, Theta{}).branches[0].shoulder, 1);
  for (int step = 100; step >= -100; --step) {
    pose.position_mm.x() = 0.01 * step;
    const RawTracking tracking = arm.track(pose, previous);
    ASSERT_EQ(tracking.status, IkStatus::kOk) << step;
    EXPECT_LT(test::angle_distance(tracking.theta, previous), 0.02) << step;
    EXPECT_NEAR(tracking.theta[0], 0.0, 1e-12) << step;
    previous = tracking.theta;
  }
}

// Slower than any arm and hardly tilted: many samples in the zone where the heading is taken as free.
TEST(FiveRTrack, CrossesTheZoneOfTheFreeHeadingWithoutRefusingOrTurning) {
  const FiveR arm{hu_arm()};
  for (const double tilt : {0.0, 3e-9, 5e-8, 9e-8}) {
    Theta previous{0.8, 0.0, 0.9, 0.0, 0.0, 0.0};
    previous = arm.inverse(arm.to_transform({.z_mm = -30.0, .heading_rad = 0.8}), previous).branches[0].theta;
    for (int step = 20; step >= -20; --step) {
      // The plane of the approach is a quarter turn away from where the arm looks.
      const Transform pose = arm.to_transform({.x_mm = 0.0,
                                               .y_mm = 0.0,
                                               .z_mm = -30.0 + 1e-9 * step,
                                               .pitch_rad = tilt * step / 20.0,
                                               .roll_rad = 0.0,
                                               .heading_rad = 0.8 + kPi / 2});
      const RawTracking tracking = arm.track(pose, previous);
      ASSERT_EQ(tracking.status, IkStatus::kSingular) << "tilt " << tilt << " step " << step;
      ASSERT_EQ(tracking.theta[0], previous[0]);
      ASSERT_NEAR(tracking.residual_rad, std::fabs(tilt * step / 20.0), 1e-15);
      if (step < 20) {
        ASSERT_LT(test::angle_distance(tracking.theta, previous), 1e-7);
      }
      ASSERT_LT(test::rotation_difference(arm.forward(tracking.theta), pose), 1e-7);
      previous = tracking.theta;
    }
  }
}

TEST(FiveRTrack, StopsAtTheReachInsteadOfChangingTheShoulder) {
  const FiveR arm{hu_arm(8.0)};  // both shoulders reach behind axis 1, the one in front farther
  Theta previous{0.0, -0.2, 0.1, 0.1, 0.0, 0.0};
  Transform pose = arm.forward(previous);
  RawTracking tracking;
  for (int step = 0; step < 2000; ++step) {
    pose.position_mm.x() += 0.01;
    tracking = arm.track(pose, previous);
    if (!solved(tracking.status)) break;
    ASSERT_LT(std::fabs(tracking.theta[0]), 1e-12);
    previous = tracking.theta;
  }
  EXPECT_EQ(tracking.status, IkStatus::kUnreachable);
  EXPECT_GT(tracking.margin_mm, 0.0);
  EXPECT_LT(tracking.margin_mm, 0.011);
}

}  // namespace
}  // namespace armature
