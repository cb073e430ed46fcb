// ik_cordic where an angle is free, where a vector has no direction, and at the limits of the reach.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "tests/support/ik_jobs.hpp"

namespace armature::test {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;

TEST(IkCordicEdges, WithoutAnyLengthEveryAngleIsFree) {
  ik::Job job;
  job.previous1 = 1'000'000;
  job.previous2 = 2'000'000;
  job.previous4 = 4'000'000;
  const ik::Solved solved = solve(job);
  EXPECT_FALSE(solved.exceeded);
  EXPECT_EQ(solved.valid, 0b0101'0101);
  EXPECT_EQ(solved.wrist_singular, 0b1111);
  EXPECT_TRUE(solved.shoulder_singular);
  EXPECT_EQ(solved.folded, 0b11);
  EXPECT_EQ(solved.elbow_singular, 0b11);
  EXPECT_EQ(solved.clamped, 0);
  for (const std::size_t branch : {0u, 2u}) {
    // atan2(0, 0) is 0.
    EXPECT_EQ(solved.theta[branch], (std::array<std::int32_t, 6>{1'000'000, 2'000'000, 0, 4'000'000, 0, 0}));
  }
  for (const std::size_t branch : {4u, 6u}) EXPECT_EQ(solved.theta[branch][0], INT32_MIN + 1'000'000);
}

TEST(IkCordicEdges, ReachEndsWhereRoundingDoes) {
  struct Case {
    std::int32_t beyond;  // of 2^-24 units
    bool reached, singular, clamped;
  };
  for (const Case& c : {Case{-1000, true, false, false}, Case{-2, true, true, false}, Case{20, true, true, true},
                        Case{40, false, false, false}, Case{1'000'000, false, false, false}}) {
    SCOPED_TRACE(c.beyond);
    for (const bool far : {true, false}) {
      ik::Job job = six_r_job();
      // The inner limit is a tenth as far away, so its tolerance is ten times as wide.
      job.position = {0, 0, far ? 20 * kUnit + c.beyond : 2 * kUnit - 10 * c.beyond};
      const ik::Solved solved = solve(job);
      EXPECT_EQ(solved.valid, c.reached ? 0xFF : 0);
      EXPECT_EQ(solved.elbow_singular, c.singular ? 0b11 : 0);
      EXPECT_EQ(solved.clamped, c.clamped ? 0b11 : 0);
      EXPECT_FALSE(solved.exceeded);
    }
  }
}

TEST(IkCordicEdges, StretchedArmHasBothElbowsInOne) {
  ik::Job job = six_r_job();
  job.position = {12 * kUnit, 0, 16 * kUnit};
  const ik::Solved solved = solve(job);
  EXPECT_EQ(solved.valid, 0xFF);
  for (const std::size_t branch : {0u, 2u}) {
    // 1e-3 pulses for 2^-24 units: the square root of the rounding.
    EXPECT_NEAR(radians_of(solved.theta[branch][1]), std::atan2(16, 12), 3e-4);
    EXPECT_NEAR(radians_of(solved.theta[branch][2]), kHalfTurn_rad / 2, 6e-4);
  }
}

TEST(IkCordicEdges, FoldedArmKeepsThePreviousTheta2) {
  ik::Job job = six_r_job();
  job.upper = job.fore - 1000;  // equal, but for the rounding
  job.a1 = 3 * kUnit;
  job.position = {3 * kUnit, 0, 0};
  const ik::Solved solved = solve(job);
  EXPECT_EQ(solved.folded, 0b01);
  EXPECT_EQ(solved.elbow_singular, 0b01);
  EXPECT_EQ(solved.theta[0][1], job.previous2);
  EXPECT_EQ(solved.theta[2][1], job.previous2);
  EXPECT_NE(solved.theta[4][1], job.previous2);
}

TEST(IkCordicEdges, WristIsSingularWithinItsZone) {
  // The forearm points along x, and so does the hand; the back shoulder has the same posture, turned by half a turn.
  ik::Job job = six_r_job();
  job.position = {11 * kUnit, 0, 9 * kUnit};
  ik::Solved solved = solve(job);
  EXPECT_EQ(solved.wrist_singular, 0b1001);
  EXPECT_EQ(solved.valid, 0b0111'1101);
  for (const std::size_t branch : {0u, 6u}) {
    EXPECT_EQ(solved.theta[branch][3], job.previous4);
    EXPECT_LT(pulses_between(radians_of(solved.theta[branch][4]), 0.0), 0.05);
  }

  job.rotation[7] = 2000;  // a_y: sin(theta_5) = 1.9e-6
  solved = solve(job);
  EXPECT_EQ(solved.wrist_singular, 0);
  EXPECT_EQ(solved.valid, 0xFF);
}

// Five joints: the approach says the heading of a tool point near axis 1, and the tool point which side is the front.
TEST(IkCordicEdges, FiveRFindsItsHeadingNearAxis1) {
  ik::Job job = six_r_job();
  job.five_r = true;
  job.phi = 0;
  job.rotation = {0, 0, -kOne, -kOne, 0, 0, 0, kOne, 0};  // the approach along y
  job.position = {0, 5, 10 * kUnit};
  EXPECT_NEAR(radians_of(solve(job).theta[0][0]), kHalfTurn_rad / 2, 1e-7);
  job.position[1] = -5;
  EXPECT_NEAR(radians_of(solve(job).theta[0][0]), -kHalfTurn_rad / 2, 1e-7);
  job.position[1] = 0;
  EXPECT_NEAR(radians_of(solve(job).theta[0][0]), kHalfTurn_rad / 2, 1e-7);

  job.rotation = {kOne, 0, 0, 0, -kOne, 0, 0, 0, -kOne};  // the approach downwards
  const ik::Solved solved = solve(job);
  EXPECT_TRUE(solved.shoulder_singular);
  EXPECT_EQ(solved.valid, 0b0101'0101);
  EXPECT_EQ(solved.theta[0][0], job.previous1);
  EXPECT_EQ(solved.theta[4][0], INT32_MIN + job.previous1);
}

}  // namespace
}  // namespace armature::test
