// The five-axis arm where it is singular, out of reach or asked for what it cannot do.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;

TEST(FiveREdges, FreeAnglesAreThePreviousOnesWithWholeTurnsRemoved) {
  const FiveR arm{hu_arm()};
  Transform pose;
  pose.rotation << 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0;
  pose.position_mm << 0.0, 0.0, -32.5;
  for (const double theta1 : {-3.0, -0.2, 0.0, 1.0, 2.0 * kPi + 1.0, -4.0 * kPi - 2.0}) {
    const RawSolutions solutions = arm.inverse(pose, Theta{theta1, 0.0, 0.0, 0.0, 0.0, 0.0});
    ASSERT_EQ(solutions.count, 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const RawBranch& branch = solutions.branches[i];
      const double expected = std::remainder(theta1 + (i < 2 ? 0.0 : kPi), 2.0 * kPi);
      EXPECT_NEAR(branch.theta[0], expected, 1e-15);
      EXPECT_EQ(branch.singular, kShoulderSingular);
      EXPECT_EQ(status_of(branch), IkStatus::kSingular);
      EXPECT_LT(test::rotation_difference(arm.forward(branch.theta), pose), 1e-15);
      EXPECT_LT(test::position_difference_mm(arm.forward(branch.theta), pose), 1e-14);
    }
  }
}

TEST(FiveREdges, RefusesOrientationsBeyondTheLimitAndSaysByHowMuch) {
  const double limit = 0.01 * kPi / 180.0;
  const FiveR arm{hu_arm(1.1, limit)};
  const FiveR strict{hu_arm()};
  const Theta theta{0.4, -0.9, 1.1, 0.3, 0.7, 0.0};
  const Transform reachable = arm.forward(theta);
  const Eigen::Vector3d outwards{std::cos(0.4), std::sin(0.4), 0.0};
  const Eigen::Vector3d approach = reachable.rotation.col(2);
  const Eigen::Vector3d normal{-std::sin(0.4), std::cos(0.4), 0.0};
  const Eigen::Vector3d tilt = approach.cross(normal);
  for (const double angle : {1e-12, 0.999 * limit, 1.001 * limit, 0.1, -0.5, 1.5}) {
    Transform pose = reachable;
    pose.rotation = test::turn_about(tilt, angle) * reachable.rotation;
    const bool accepted = std::fabs(angle) <= limit;
    const RawSolutions solutions = arm.inverse(pose, theta);
    EXPECT_EQ(solutions.status, accepted ? IkStatus::kOk : IkStatus::kOrientation) << angle;
    EXPECT_EQ(solutions.count > 0, accepted) << angle;
    EXPECT_NEAR(solutions.residual_rad, std::fabs(angle), 3e-16) << angle;
    const RawTracking tracking = arm.track(pose, theta);
    EXPECT_EQ(tracking.status, solutions.status) << angle;
    EXPECT_EQ(tracking.residual_rad, solutions.residual_rad);
    EXPECT_EQ(strict.inverse(pose, theta).status, std::fabs(angle) < 1e-9 ? IkStatus::kOk : IkStatus::kOrientation);
  }
  // Turning inside the plane, about its normal, and about the approach is what the arm can do.
  for (const Eigen::Vector3d& axis : {normal, approach}) {
    Transform pose = reachable;
    pose.rotation = test::turn_about(axis, 0.2) * reachable.rotation;
    EXPECT_LT(strict.inverse(pose, theta).residual_rad, 1e-15);
  }
}

TEST(FiveREdges, RefusesAnApproachNormalToThePlaneWhateverTheLimit) {
  const FiveR arm{hu_arm(1.1, kPi)};
  Transform pose;
  pose.rotation << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;  // approach along y
  pose.position_mm << 12.0, 0.0, 3.0;
  for (const IkStatus status : {arm.inverse(pose, Theta{}).status, arm.track(pose, Theta{}).status}) {
    EXPECT_EQ(status, IkStatus::kOrientation);
  }
  EXPECT_DOUBLE_EQ(arm.inverse(pose, Theta{}).residual_rad, kPi / 2);
  EXPECT_EQ(arm.inverse(pose, Theta{}).count, 0u);
}

TEST(FiveREdges, RoundingBeyondTheReachIsClampedAndMoreIsRefusedWithItsSize) {
  const FiveR arm{hu_arm()};
  const Theta stretched{0.5, -0.4, 0.0, 0.9, 0.2, 0.0};
  const Transform limit = arm.forward(stretched);
  const Eigen::Vector3d away{std::cos(0.5) * std::cos(-0.4), std::sin(0.5) * std::cos(-0.4), -std::sin(-0.4)};
  for (const double beyond : {1e-12, 1e-9, 1.9e-8}) {
    Transform pose = limit;
    pose.position_mm += beyond * away;
    const RawSolutions solutions = arm.inverse(pose, stretched);
    ASSERT_EQ(solutions.count, 2u) << beyond;
    EXPECT_TRUE(solutions.branches[0].clamped);
    EXPECT_EQ(solutions.branches[0].singular, kElbowSingular);
    EXPECT_LT(test::position_difference_mm(arm.forward(solutions.branches[0].theta), pose), 2e-8);
    EXPECT_EQ(arm.track(pose, stretched).status, IkStatus::kClamped);
  }
  for (const double beyond : {2.1e-8, 1e-3, 5.0, 1e6}) {
    Transform pose = limit;
    pose.position_mm += beyond * away;
    const RawSolutions solutions = arm.inverse(pose, stretched);
    EXPECT_EQ(solutions.status, IkStatus::kUnreachable) << beyond;
    EXPECT_EQ(solutions.count, 0u);
    EXPECT_NEAR(solutions.margin_mm, beyond, 1e-14 + 1e-9 * beyond);
    EXPECT_EQ(arm.track(pose, stretched).status, IkStatus::kUnreachable);
    EXPECT_EQ(arm.track(pose, stretched).margin_mm, solutions.margin_mm);
  }
}

TEST(FiveREdges, TooNearIsRefusedWithTheDistanceToTheInnerLimit) {
  const FiveR arm{hu_arm()};
  const Theta folded{0.5, -0.4, kPi, 0.9, 0.2, 0.0};  // joint 4 is 0.5 mm from joint 2
  Transform pose = arm.forward(folded);
  const RawSolutions at_the_limit = arm.inverse(pose, folded);
  ASSERT_GE(at_the_limit.count, 2u);
  EXPECT_TRUE(std::any_of(at_the_limit.branches.begin(), at_the_limit.branches.begin() + at_the_limit.count,
                          [](const RawBranch& branch) { return branch.singular == kElbowSingular; }));
  const Eigen::Vector3d inwards{-std::cos(0.5) * std::cos(-0.4), -std::sin(0.5) * std::cos(-0.4), std::sin(-0.4)};
  pose.position_mm += 0.3 * inwards;
  const RawTracking tracking = arm.track(pose, folded);
  EXPECT_EQ(tracking.status, IkStatus::kUnreachable);
  EXPECT_NEAR(tracking.margin_mm, 0.3, 1e-13);
}

TEST(FiveREdges, EqualLinksFoldedOnEachOtherKeepThePreviousTheta2) {
  ArmGeometry geometry = hu_arm();
  geometry.a3_mm = geometry.a2_mm;
  const FiveR arm{geometry};
  const Theta folded{0.5, -0.4, kPi, 0.9, 0.2, 0.0};
  const Transform pose = arm.forward(folded);
  const RawSolutions solutions = arm.inverse(pose, folded);
  ASSERT_GE(solutions.count, 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(solutions.branches[i].singular, kElbowSingular | kFoldedSingular);
    EXPECT_EQ(status_of(solutions.branches[i].singular, false), IkStatus::kSingular);
    EXPECT_EQ(solutions.branches[i].theta[1], -0.4);
    EXPECT_LT(test::rotation_difference(arm.forward(solutions.branches[i].theta), pose), 1e-14);
    EXPECT_LT(test::position_difference_mm(arm.forward(solutions.branches[i].theta), pose), 1e-7);
  }
}

TEST(FiveREdges, RefusesWhatIsNoPoseAndPreviousAnglesThatAreNone) {
  const FiveR arm{hu_arm(1.1, kPi)};
  const Theta theta{0.4, -0.9, 1.1, 0.3, 0.7, 0.0};
  const Transform good = arm.forward(theta);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 2e6}) {
    for (std::size_t joint = 0; joint < 6; ++joint) {
      Theta previous = theta;
      previous[joint] = bad;
      EXPECT_EQ(arm.inverse(good, previous).status, IkStatus::kInvalidInput);
      EXPECT_EQ(arm.track(good, previous).status, IkStatus::kInvalidInput);
    }
    for (Eigen::Index element = 0; element < 9; ++element) {
      Transform pose = good;
      pose.rotation(element / 3, element % 3) = bad;
      EXPECT_EQ(arm.inverse(pose, theta).status, IkStatus::kInvalidInput);
      EXPECT_EQ(arm.track(pose, theta).status, IkStatus::kInvalidInput);
    }
  }
  Transform mirrored = good;
  mirrored.rotation.col(0) = -mirrored.rotation.col(0);
  EXPECT_EQ(arm.inverse(mirrored, theta).status, IkStatus::kInvalidInput);
}

// Poses of all sizes, many of them exactly at an edge: zeros, vertical approaches, huge and tiny tool points.
TEST(FiveREdges, NeverAnswersANumberThatIsNone) {
  constexpr std::uint64_t kSeed = 24;
  test::Random random{kSeed};
  const double halfway = std::sqrt(0.5);
  for (int i = 0; i < 20'000; ++i) {
    const FiveR arm{hu_arm(random.integer(0, 1) ? 0.0 : 1.1, kPi)};
    Transform pose;
    if (random.integer(0, 2) == 0) {
      pose.rotation = test::turn_about(test::random_direction(random), random.real(-kPi, kPi));
    } else {
      Eigen::Matrix3d vertical;
      vertical << 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0;
      Eigen::Matrix3d half;
      half << halfway, -halfway, 0.0, halfway, halfway, 0.0, 0.0, 0.0, 1.0;
      pose.rotation = half * vertical;
      if (random.integer(0, 1)) pose.rotation.col(0).swap(pose.rotation.col(2)), pose.rotation.col(1) *= -1.0;
    }
    for (Eigen::Index row = 0; row < 3; ++row) {
      const double magnitude = std::pow(10.0, static_cast<double>(random.integer(-20, 3)));
      pose.position_mm[row] = random.integer(0, 2) == 0 ? 0.0 : random.real(-1.0, 1.0) * magnitude;
      if (random.integer(0, 50) == 0) pose.position_mm[row] = 1.7e308 * random.real(-1.0, 1.0);
    }
    const Theta previous = test::random_theta(random);
    const RawSolutions solutions = arm.inverse(pose, previous);
    ASSERT_FALSE(std::isnan(solutions.residual_rad) || std::isnan(solutions.margin_mm)) << "seed " << kSeed << " " << i;
    ASSERT_EQ(solutions.status == IkStatus::kOk, solutions.count > 0) << "seed " << kSeed << " " << i;
    ASSERT_EQ(solutions.status == IkStatus::kUnreachable, solutions.margin_mm > 0.0) << "seed " << kSeed << " " << i;
    for (std::size_t b = 0; b < solutions.count; ++b) {
      for (const double angle : solutions.branches[b].theta) {
        ASSERT_LE(std::fabs(angle), kPi) << "seed " << kSeed << " " << i;
      }
      ASSERT_LT(test::position_difference_mm(arm.forward(solutions.branches[b].theta), pose), 5e-8)
          << "seed " << kSeed << " " << i;
    }
    const RawTracking tracking = arm.track(pose, previous);
    ASSERT_FALSE(std::isnan(tracking.residual_rad) || std::isnan(tracking.margin_mm)) << "seed " << kSeed << " " << i;
    for (std::size_t joint = 0; solved(tracking.status) && joint < 5; ++joint) {
      ASSERT_LE(std::fabs(tracking.theta[joint] - previous[joint]), kPi + 1e-15) << "seed " << kSeed << " " << i;
    }
  }
}

}  // namespace
}  // namespace armature
