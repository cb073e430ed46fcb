// Homing: where an arm of unknown joint angles ends, and what is reported and refused.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "controller/activity/move_checks.hpp"
#include "tests/controller/support/homing_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::homing_robot;
using test::HomingRig;
using test::kCountDeg;
using test::kDeg;

constexpr double kHomeDeg = -10.0;  // of homing_robot()

// The axis stands at its home position, and the controller knows the true angle.
void expect_homed(const HomingRig& homing, std::size_t axis) {
  ASSERT_NE(homing.end(axis), nullptr) << "axis " << axis + 1;
  EXPECT_EQ(homing.end(axis)->how, HomingEnd::kHomed) << "axis " << axis + 1;
  EXPECT_NEAR(homing.joint_deg(axis), kHomeDeg, 1.01 * kCountDeg) << "axis " << axis + 1;
  const Telemetry& last = homing.rig.last();
  EXPECT_NEAR(last.actual[axis].value() / kDeg, homing.joint_deg(axis), 0.51 * kCountDeg) << "axis " << axis + 1;
  EXPECT_NEAR(last.reference[axis].value() / kDeg, homing.joint_deg(axis), 0.51 * kCountDeg) << "axis " << axis + 1;
  EXPECT_EQ(last.state, MotionState::kIdle);
  EXPECT_TRUE(homing.rig.faults.empty());
}

TEST(Homing, FindsTheAngleFromTheSideOfTheSearch) {
  HomingRig homing;
  homing.home(10.0);
  expect_homed(homing, 0);
  const HomingEnded& end = *homing.end(0);
  EXPECT_EQ(end.met, HomingSwitch::kHome);
  EXPECT_EQ(end.tag, Tag{7});
  // The edge is at -15.5, the index at -14.4 degrees; sampled once per tick.
  EXPECT_NEAR(static_cast<double>(end.edge_to_index.value()) * kCountDeg, 1.1, 2 * kCountDeg);
  EXPECT_EQ(end.shift.value(), std::lround(10.0 / kCountDeg));
  ASSERT_EQ(homing.rig.homings.size(), 1u);
  EXPECT_EQ(homing.rig.homings[0].axis, 1);
  EXPECT_EQ(end.taken, end.tick - homing.rig.homings[0].tick);
}

TEST(Homing, BacksOffWhenItStandsOnTheSwitch) {
  HomingRig homing;
  homing.home(-17.0);
  expect_homed(homing, 0);
  EXPECT_EQ(homing.end(0)->met, HomingSwitch::kOnHome);
}

TEST(Homing, TurnsRoundAtTheLimitSwitchWhenItStandsBehindTheSwitch) {
  HomingRig homing;
  homing.home(-30.0);
  expect_homed(homing, 0);
  EXPECT_EQ(homing.end(0)->met, HomingSwitch::kLimit);
}

TEST(Homing, BeginsOnEitherLimitSwitch) {
  for (const double start_deg : {-43.0, 43.0}) {
    SCOPED_TRACE(start_deg);
    HomingRig homing;
    homing.home(start_deg);
    expect_homed(homing, 0);
    EXPECT_EQ(homing.end(0)->met, start_deg < 0.0 ? HomingSwitch::kLimit : HomingSwitch::kHome);
  }
}

TEST(Homing, PassesASwitchThatIsShorterThanItsBrakingDistance) {
  HomingRig homing;
  for (HomingRig::World& world : homing.worlds) world.home = {-15.6, -15.5};
  homing.home(0.0);
  expect_homed(homing, 0);
}

TEST(Homing, FindsTheSameAngleFromAnywhereWithEitherSignOfTheGear) {
  constexpr std::uint64_t kSeed = 11;
  test::Random random{kSeed};
  for (int i = 0; i < 8; ++i) {
    const double start_deg = random.real(-43.0, 43.0);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", run " << i << ", start " << start_deg);
    HomingRig homing{homing_robot(i % 2 == 0 ? 50.0 : -50.0)};
    homing.home(start_deg);
    expect_homed(homing, 0);
    EXPECT_EQ(homing.end(0)->shift.value(), std::lround(start_deg / kCountDeg) * (i % 2 == 0 ? 1 : -1));
  }
}

TEST(Homing, SearchesInThePositiveDirectionAsWell) {
  RobotModel robot = homing_robot();
  robot.axes[0].homing->direction = 1.0;
  robot.axes[0].homing->index_rad = -21.6 * kDeg;  // below the switch
  HomingRig homing{robot};
  homing.home(-30.0);
  expect_homed(homing, 0);
  EXPECT_EQ(homing.end(0)->met, HomingSwitch::kHome);
}

TEST(Homing, AxesOfAnOrderBeginTogetherAndTheNextOnesAfterThem) {
  HomingRig homing;
  homing.home(2.0, 0, 8 * HomingRig::kSecond);
  for (std::size_t axis = 0; axis < kAxes; ++axis) expect_homed(homing, axis);
  ASSERT_EQ(homing.rig.homings.size(), kAxes);
  const auto& started = homing.rig.homings;
  EXPECT_EQ(started[0].tick, started[1].tick);
  for (std::size_t axis = 2; axis < kAxes; ++axis) {
    EXPECT_EQ(started[axis].axis, axis + 1);
    EXPECT_EQ(started[axis].tick, homing.end(axis - 1)->tick + Ticks{1});
  }
}

TEST(Homing, AMoveAfterItEndsAtItsTrueTarget) {
  HomingRig homing;
  for (HomingRig::World& world : homing.worlds) world.start_deg = 2.0;
  homing.rig.submit_at(10, Home{});
  const PerAxis<double> target{0.0, 5.0, -5.0, 20.0, -20.0, 30.0};
  homing.rig.move_at(20, target);  // waits until the arm is homed
  homing.rig.run(9 * HomingRig::kSecond);
  EXPECT_TRUE(homing.rig.refusals.empty());
  EXPECT_EQ(homing.rig.moves_finished(), 1);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_NEAR(homing.joint_deg(axis), target[axis], 1.01 * kCountDeg) << "axis " << axis + 1;
  }
}

TEST(Homing, IsRepeatedByAnArmThatKnowsItsAngles) {
  HomingRig homing;
  homing.rig.submit_at(4 * HomingRig::kSecond, Home{.axes = 1});
  homing.home(2.0, 1, 8 * HomingRig::kSecond);
  ASSERT_EQ(homing.rig.homings_ended.size(), 2u);
  EXPECT_EQ(homing.rig.homings_ended[1].how, HomingEnd::kHomed);
  EXPECT_EQ(homing.rig.homings_ended[1].shift.value(), 0);
  EXPECT_NEAR(homing.joint_deg(0), kHomeDeg, 1.01 * kCountDeg);
}

TEST(Unreferenced, TheArmExecutesOnlyHome) {
  HomingRig homing;
  homing.rig.submit_at(10, JointMove{.tag = 1});
  homing.rig.submit_at(10, Dwell{.duration = Ticks{10}, .tag = 2});
  Jog jog{.duration = Ticks{100}, .tag = 3};
  jog.joint_rad_s[0] = 0.1;
  homing.rig.submit_at(11, jog);
  homing.rig.submit_at(12, StreamPoint{.first = true, .last = true, .delay = Ticks{1}, .tag = 4});
  homing.rig.submit_at(13, JointMove{.now = true, .tag = 5});
  homing.rig.run(1'000);
  ASSERT_EQ(homing.rig.refusals.size(), 5u);
  for (const MoveRefused& refused : homing.rig.refusals) EXPECT_EQ(refused.reason, Refusal::kNotReferenced);
  EXPECT_EQ(homing.rig.logic.emitted(0), 0);
}

TEST(Unreferenced, AMoveFromBeforeTheStartOfTheControllerIsRefused) {
  HomingRig homing;
  homing.rig.submit(JointMove{.tag = 1});
  homing.rig.run(1'000);
  ASSERT_EQ(homing.rig.refusals.size(), 1u);
  EXPECT_EQ(homing.rig.refusals[0].reason, Refusal::kNotReferenced);
}

TEST(Unreferenced, SomeAxesAreNotEnough) {
  HomingRig homing;
  homing.rig.move_at(4 * HomingRig::kSecond, {});
  homing.home(2.0, 0b111, 5 * HomingRig::kSecond);
  ASSERT_EQ(homing.rig.refusals.size(), 1u);
  EXPECT_EQ(homing.rig.refusals[0].reason, Refusal::kNotReferenced);
}

TEST(Home, IsRefusedForAxesThatCannotBeHomed) {
  RobotModel robot = homing_robot();
  robot.axes[3].homing.reset();
  ASSERT_TRUE(find_refusal(robot, Home{}));
  EXPECT_EQ(find_refusal(robot, Home{})->axis, 4);
  EXPECT_EQ(find_refusal(robot, Home{})->reason, Refusal::kInvalidTarget);
  EXPECT_FALSE(find_refusal(robot, Home{.axes = 0b110111}));
  EXPECT_EQ(find_refusal(robot, Home{.axes = 0b1000000})->axis, 7);
  robot.axis_count = 3;
  EXPECT_FALSE(find_refusal(robot, Home{}));
}

TEST(Home, IsRefusedWhileTheArmMoves) {
  test::ControllerRig rig{homing_robot()};
  rig.move_at(10, {20.0});
  rig.submit_at(1'000, Home{.tag = 9});
  rig.run(HomingRig::kSecond);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  EXPECT_EQ(rig.refusals[0].tag, Tag{9});
}

}  // namespace
}  // namespace armature
