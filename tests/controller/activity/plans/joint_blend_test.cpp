// Joint moves with a blend: which of them are joined, and what interrupts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "controller/activity/move_checks.hpp"
#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::kDeg;

constexpr std::int64_t kTicksInSecond = 20'000;

JointMove blended(const PerAxis<double>& deg, double blend_deg, std::uint32_t tag = 0) {
  return {.target = degrees(deg), .blend = {.rad = blend_deg * kDeg}, .tag = tag};
}

// Whether the reference rests at this place in any tick.
bool rests_at(const ControllerRig& rig, const PerAxis<double>& deg) {
  return std::ranges::any_of(rig.rows, [&](const Telemetry& row) { return row.reference == degrees(deg); });
}

double nearest_deg(const ControllerRig& rig, const PerAxis<double>& deg) {
  double least = 1e9;
  for (const Telemetry& row : rig.rows) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      most = std::max(most, std::fabs(row.reference[axis].value() / kDeg - deg[axis]));
    }
    least = std::min(least, most);
  }
  return least;
}

void expect_accelerations(const ControllerRig& rig, const std::string& what) {
  for (std::size_t k = 2; k < rig.rows.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto q = [&](std::size_t back) { return rig.rows[k - back].reference[axis].value(); };
      const AxisModel& model = rig.robot.axes[axis];
      ASSERT_LE(std::fabs(q(0) - q(1)), model.max_speed_rad_s * kTickSeconds * (1 + 1e-5)) << what << " tick " << k;
      ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)), model.max_accel_rad_s2 * kTickSeconds * kTickSeconds * (1 + 1e-5))
          << what << " tick " << k << " axis " << axis;
    }
  }
}

TEST(JointBlend, PassesThePointWithinTheBlendWithoutAStop) {
  ControllerRig rig;
  rig.submit_at(10, blended({40, 0, 0, 0, 0, 0}, 5, 1));
  rig.submit_at(10, blended({40, 40, 0, 0, 0, 0}, 2, 2));
  rig.submit_at(10, blended({0, 40, 30, 0, 0, 0}, 0, 3));
  rig.run(4 * kTicksInSecond);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_FALSE(rig.moves[0].continues);
  EXPECT_TRUE(rig.moves[1].continues);
  EXPECT_TRUE(rig.moves[2].continues);
  EXPECT_EQ(rig.moves_finished(), 3);
  EXPECT_NEAR(nearest_deg(rig, {40, 0, 0, 0, 0, 0}), 5.0, 0.05);
  EXPECT_LE(nearest_deg(rig, {40, 0, 0, 0, 0, 0}), 5.0);
  EXPECT_NEAR(nearest_deg(rig, {40, 40, 0, 0, 0, 0}), 2.0, 0.05);
  EXPECT_LE(nearest_deg(rig, {40, 40, 0, 0, 0, 0}), 2.0);
  rig.expect_at({0, 40, 30, 0, 0, 0});
  expect_accelerations(rig, "three moves");
  rig.expect_pulses_conserved();
}

TEST(JointBlend, InPercentIsAShareOfHalfTheShorterMove) {
  ControllerRig rig;
  JointMove first = blended({40, 0, 0, 0, 0, 0}, 0);
  first.blend.share = 0.2;
  rig.submit_at(10, first);
  rig.submit_at(10, blended({40, 20, 10, 0, 0, 0}, 0));
  rig.run(2 * kTicksInSecond);
  EXPECT_LE(nearest_deg(rig, {40, 0, 0, 0, 0, 0}), 2.0);
  EXPECT_GT(nearest_deg(rig, {40, 0, 0, 0, 0, 0}), 1.9);
}

TEST(JointBlend, StopsExactlyWhereNoJointMoveFollowsInTime) {
  for (const int follower : {0, 1, 2, 3}) {
    ControllerRig rig;
    rig.submit_at(10, blended({20, 0, 0, 0, 0, 0}, 5));
    if (follower == 1) rig.submit_at(5'000, blended({20, 20, 0, 0, 0, 0}, 0));  // too late
    if (follower == 2) rig.submit_at(10, SetOutput{.pin = 1, .level = true});
    if (follower == 3) rig.submit_at(10, blended({500, 0, 0, 0, 0, 0}, 0));  // refused
    if (follower >= 2) rig.submit_at(10, blended({20, 20, 0, 0, 0, 0}, 0));
    rig.run(3 * kTicksInSecond);
    EXPECT_TRUE(rests_at(rig, {20, 0, 0, 0, 0, 0})) << "follower " << follower;
    for (const MoveStarted& move : rig.moves) EXPECT_FALSE(move.continues);
    if (follower > 0) rig.expect_at({20, 20, 0, 0, 0, 0});
  }
}

TEST(JointBlend, AChainIsDividedWhereItIsFull) {
  ControllerRig rig;
  for (std::uint32_t i = 0; i < 9; ++i) rig.submit_at(10, blended({10.0 * (i + 1), 20.0 * (i % 2), 0, 0, 0, 0}, 3, i));
  rig.run(6 * kTicksInSecond);
  ASSERT_EQ(rig.moves.size(), 9u);
  EXPECT_EQ(rig.moves_finished(), 9);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(rig.moves[i].continues, i % JointChain::kMaxMoves != 0) << i;
  rig.expect_at({90, 0, 0, 0, 0, 0});
}

TEST(JointBlend, HoldsOverridesStopsAndNewTargetsKeepTheLimitsInACorner) {
  for (std::int64_t at = 3'000; at < 16'000; at += 3'100) {
    for (const int kind : {0, 1, 2, 3}) {
      ControllerRig rig;
      rig.submit_at(10, blended({40, 0, 0, 0, 0, 0}, 10, 1));
      rig.submit_at(10, blended({40, 40, 0, 0, 0, 0}, 10, 2));
      rig.submit_at(10, blended({0, 40, 30, 0, 0, 0}, 0, 3));
      if (kind == 0) rig.submit_at(at, Hold{});
      if (kind == 1) rig.submit_at(at, SetOverride{.share = 0.3});
      if (kind == 2) rig.submit_at(at, Stop{});
      if (kind == 3) rig.submit_at(at, JointMove{.target = degrees({0, 40, 30, 0, 0, 0}), .now = true, .tag = 4});
      rig.submit_at(at + 9'000, Resume{});
      rig.run(at + (kind == 1 ? 5 : 2) * kTicksInSecond);
      const std::string what = "kind " + std::to_string(kind) + " at " + std::to_string(at);
      expect_accelerations(rig, what);
      EXPECT_EQ(rig.moves.size() + rig.refusals.size(), kind == 3 ? 4u : 3u) << what;
      EXPECT_EQ(rig.moves.size(), rig.finished.size()) << what;
      if (kind != 2) rig.expect_at({0, 40, 30, 0, 0, 0});
      rig.expect_pulses_conserved();
      if (HasFatalFailure()) return;
    }
  }
}

TEST(JointBlend, OfMovesToPosesJoinsThemToo) {
  ControllerRig rig{test::robot_with(test::irb120_geometry())};
  rig.submit_at(10, blended({0, 20, -30, 0, 40, 0}, 3, 1));
  PoseMove pose{.target = {.frame = kToolFrame, .position_mm = {0, 60, 0}}, .blend = {.rad = 1 * kDeg}, .tag = 2};
  rig.submit_at(10, pose);
  rig.submit_at(10, blended({0, 0, 0, 0, 40, 0}, 0, 3));
  rig.run(3 * kTicksInSecond);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_TRUE(rig.moves[1].continues);
  EXPECT_TRUE(rig.moves[2].continues);
  rig.expect_at({0, 0, 0, 0, 40, 0});
}

TEST(JointBlend, OutOfItsRangeIsRefused) {
  const RobotModel robot = test::robot_with(test::irb120_geometry());
  const auto refused = [&](const JointBlend& blend) {
    return find_refusal(robot, JointMove{.blend = blend}).has_value() &&
           find_refusal(robot, {}, PoseMove{.blend = blend}).has_value();
  };
  EXPECT_FALSE(refused({.rad = 1.0}));
  EXPECT_FALSE(refused({.share = 1.0}));
  EXPECT_TRUE(refused({.rad = -1.0}));
  EXPECT_TRUE(refused({.rad = std::nan("")}));
  EXPECT_TRUE(refused({.share = 1.1}));
  EXPECT_TRUE(refused({.rad = 0.1, .share = 0.1}));
}

}  // namespace
}  // namespace armature
