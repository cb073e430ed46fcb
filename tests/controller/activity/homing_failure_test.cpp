// How the homing of an axis fails, and what follows.
#include <gtest/gtest.h>

#include <vector>

#include "tests/controller/support/homing_rig.hpp"

namespace armature {
namespace {

using test::HomingRig;
using test::kCountDeg;

TEST(HomingFails, WithoutASwitchBetweenTheLimitSwitches) {
  HomingRig homing;
  homing.worlds[0].home = {100.0, 101.0};
  homing.home(2.0, 1, 4 * HomingRig::kSecond);
  EXPECT_EQ(homing.how(0), HomingEnd::kNoSwitch);
  EXPECT_EQ(homing.end(0)->met, HomingSwitch::kLimit);
  EXPECT_TRUE(homing.rig.faults.empty());
}

TEST(HomingFails, WithoutAnySwitchAfterTheTravelOfTheAxis) {
  HomingRig homing;
  homing.worlds[0].home = {500.0, 501.0};
  homing.worlds[0].limits = {-500.0, 500.0};
  homing.home(2.0, 1, 4 * HomingRig::kSecond);
  EXPECT_EQ(homing.how(0), HomingEnd::kNoSwitch);
  EXPECT_EQ(homing.end(0)->met, HomingSwitch::kNone);
  EXPECT_NEAR(homing.joint_deg(0), 2.0 - 1.25 * 80.0, 0.01) << "1.25 times the range";
}

TEST(HomingFails, WhenTheSwitchIsStuck) {
  HomingRig homing;
  homing.worlds[0].home = {-500.0, 500.0};
  homing.home(2.0, 1, 4 * HomingRig::kSecond);
  EXPECT_EQ(homing.how(0), HomingEnd::kSwitchStuck);
}

TEST(HomingFails, WithoutAnIndexWithinARevolution) {
  HomingRig homing;
  homing.worlds[0].has_index = false;
  homing.home(2.0);
  EXPECT_EQ(homing.how(0), HomingEnd::kNoIndex);
  EXPECT_NEAR(homing.joint_deg(0), -15.5 + 1.125 * test::kIndexDeg, 0.3);
}

// An index 0.1 degrees to either side of the edge: 2 % of a revolution are 0.144 degrees.
TEST(HomingFails, WhenTheIndexIsAtTheEdgeOfTheSwitch) {
  for (const double beside : {-0.1, 0.1}) {
    SCOPED_TRACE(beside);
    HomingRig homing;
    homing.worlds[0].home.to_deg = -14.4 + beside;
    homing.home(2.0);
    EXPECT_EQ(homing.how(0), HomingEnd::kIndexAtEdge);
  }
  HomingRig homing;
  homing.worlds[0].home.to_deg = -14.4 - 0.2;
  homing.home(2.0);
  EXPECT_EQ(homing.how(0), HomingEnd::kHomed);
}

TEST(HomingFails, AtALimitSwitchBesideTheHomeSwitch) {
  HomingRig homing;
  homing.worlds[0].limits.to_deg = -15.0;
  homing.home(-17.0);
  EXPECT_EQ(homing.how(0), HomingEnd::kLimit);
  EXPECT_TRUE(homing.rig.faults.empty());
}

TEST(HomingFails, ByAStopOrAHoldAndTheArmBrakesAtOnce) {
  for (const Command& command : std::vector<Command>{Stop{}, Stop{.kind = Stop::Kind::kSoft}, Hold{}}) {
    SCOPED_TRACE(command.index());
    HomingRig homing;
    homing.rig.submit_at(2'000, command);
    homing.home(20.0, 0, HomingRig::kSecond);
    EXPECT_EQ(homing.rig.homings_ended.size(), 2u) << "the axes that had begun";
    EXPECT_EQ(homing.how(0), HomingEnd::kStop);
    // 40 deg/s at 600 deg/s^2 take 67 ms, the lag of the drive less than 20 ms, and the rest 20 ms.
    EXPECT_LT(homing.end(0)->tick, Ticks{2'000 + 2'300});
    EXPECT_EQ(homing.rig.last().state, MotionState::kIdle);
  }
}

TEST(HomingFails, ByAFaultAndWorksAfterIt) {
  HomingRig homing;
  homing.rig.at(2'000, [&] { homing.rig.logic.pins.estop_n = false; });
  homing.rig.at(2'100, [&] { homing.rig.logic.pins.estop_n = true; });
  homing.rig.submit_at(5'000, ClearFault{});
  homing.rig.move_at(6'000, {});
  homing.rig.submit_at(7'000, Home{.axes = 1});
  homing.home(20.0, 1, 3 * HomingRig::kSecond);
  ASSERT_EQ(homing.rig.homings_ended.size(), 2u);
  EXPECT_EQ(homing.rig.homings_ended[0].how, HomingEnd::kFault);
  EXPECT_EQ(homing.rig.homings_ended[1].how, HomingEnd::kHomed);
  ASSERT_EQ(homing.rig.refusals.size(), 1u);
  EXPECT_EQ(homing.rig.refusals[0].reason, Refusal::kNotReferenced);
  EXPECT_NEAR(homing.joint_deg(0), -10.0, 1.01 * kCountDeg);
}

TEST(HomingFails, ForTheOtherAxesOfItsOrderAndThoseBehindIt) {
  HomingRig homing;
  homing.worlds[1].has_index = false;
  homing.worlds[1].start_deg = -15.0;
  homing.rig.move_at(20, {});
  homing.rig.submit_at(10, Home{});
  homing.rig.run(4 * HomingRig::kSecond);
  EXPECT_EQ(homing.how(1), HomingEnd::kNoIndex);
  EXPECT_EQ(homing.how(0), HomingEnd::kHomed) << "its start is nearer: it was over before";
  EXPECT_EQ(homing.rig.homings.size(), 2u);
  ASSERT_EQ(homing.rig.refusals.size(), 1u) << "the move that waits";
  EXPECT_EQ(homing.rig.refusals[0].reason, Refusal::kNotReferenced);
}

}  // namespace
}  // namespace armature
