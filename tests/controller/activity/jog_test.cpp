// Jogging: velocities of the joints and of the tool, between moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/activity/move_checks.hpp"
#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/dispatcher_bench.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::kDeg;

constexpr std::int64_t kSecond = 20'000;

Jog joints(const PerAxis<double>& deg_s, std::int64_t ticks) {
  return {.joint_rad_s = make_per_axis([&](std::size_t axis) { return deg_s[axis] * kDeg; }), .duration = Ticks{ticks}};
}

Jog tool(FrameId frame, const Eigen::Vector3d& mm_s, std::int64_t ticks) {
  return {.kind = Jog::Kind::kTool, .frame = frame, .move_mm_s = mm_s, .duration = Ticks{ticks}};
}

double degrees_of(const Telemetry& row, std::size_t axis) {
  return row.reference[axis].value() / kDeg;
}

TEST(Jog, KeepsItsVelocityForItsDurationAndComesToRest) {
  ControllerRig rig;
  rig.submit_at(10, joints({0, 10, 0, 0, 0, 0}, kSecond));
  rig.run(2 * kSecond);
  EXPECT_TRUE(rig.refusals.empty());
  const double step_deg = degrees_of(rig.row(kSecond), 1) - degrees_of(rig.row(kSecond - 1), 1);
  EXPECT_NEAR(step_deg / kTickSeconds, 10.0, 1e-6);
  EXPECT_NEAR(degrees_of(rig.last(), 1), 10.0, 0.02);
  EXPECT_EQ(rig.row(kSecond).state, MotionState::kMoving);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  rig.expect_pulses_conserved();
}

TEST(Jog, AMoveThatComesMeanwhileBeginsWhereTheJogEnds) {
  ControllerRig rig;
  rig.submit_at(10, joints({10, 0, 0, 0, 0, 0}, kSecond));
  rig.move_at(100, {0, 5, 0, 0, 0, 0});
  rig.run(3 * kSecond);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_GT(rig.moves[0].start_tick, Ticks{kSecond});
  EXPECT_EQ(rig.moves_finished(), 1);
  rig.expect_at({0, 5, 0, 0, 0, 0});
  rig.expect_pulses_conserved();
}

TEST(Jog, IsRefusedWhileAMoveRunsWhichGoesOn) {
  ControllerRig rig;
  rig.move_at(10, {10, 0, 0, 0, 0, 0});
  rig.submit_at(1'000, joints({0, 10, 0, 0, 0, 0}, kSecond));
  rig.run(kSecond);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  EXPECT_EQ(rig.moves_finished(), 1);
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(Jog, IsReplacedByTheNextOne) {
  ControllerRig rig;
  rig.submit_at(10, joints({10, 0, 0, 0, 0, 0}, kSecond));
  rig.submit_at(10 + kSecond / 2, joints({-10, 0, 0, 0, 0, 0}, kSecond / 2));
  rig.run(2 * kSecond);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_NEAR(degrees_of(rig.row(kSecond / 2), 0), 5.0, 0.1);
  EXPECT_NEAR(degrees_of(rig.last(), 0), 0.0, 0.2);
}

TEST(Jog, AStopEndsItAndTheNextOneIsAcceptedAtRest) {
  ControllerRig rig;
  rig.submit_at(10, joints({10, 0, 0, 0, 0, 0}, 10 * kSecond));
  rig.submit_at(kSecond / 2, Stop{});
  rig.submit_at(kSecond / 2 + 1, joints({10, 0, 0, 0, 0, 0}, kSecond));  // still stopping
  rig.submit_at(kSecond, joints({0, 0, 10, 0, 0, 0}, kSecond / 2));
  rig.move_at(kSecond, {0, 0, 1, 0, 0, 0});
  rig.run(4 * kSecond);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  EXPECT_NEAR(degrees_of(rig.row(kSecond - 1), 0), 5.0, 0.1);
  EXPECT_EQ(rig.row(kSecond - 1).state, MotionState::kIdle);
  EXPECT_NEAR(degrees_of(rig.row(kSecond * 3 / 2), 2), 5.0, 0.1);
  rig.expect_at({0, 0, 1, 0, 0, 0});
}

TEST(Jog, AHoldEndsItAndMovesWaitForTheResume) {
  ControllerRig rig;
  rig.submit_at(10, joints({10, 0, 0, 0, 0, 0}, 10 * kSecond));
  rig.submit_at(kSecond / 2, Hold{});
  rig.move_at(kSecond / 2, {1, 0, 0, 0, 0, 0});
  rig.submit_at(2 * kSecond, Resume{});
  rig.run(4 * kSecond);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_NEAR(degrees_of(rig.row(2 * kSecond - 1), 0), 5.0, 0.1);
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_GE(rig.moves[0].start_tick, Ticks{2 * kSecond - 1});
  rig.expect_at({1, 0, 0, 0, 0, 0});
}

TEST(Jog, EndsInAFaultAndTheArmMovesAgainAfterIt) {
  ControllerRig rig;
  rig.submit_at(10, joints({10, 0, 0, 0, 0, 0}, 10 * kSecond));
  rig.at(kSecond / 2, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(kSecond, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(kSecond - 100, joints({10, 0, 0, 0, 0, 0}, kSecond));
  rig.submit_at(kSecond + 100, ClearFault{});
  rig.move_at(kSecond + 1'000, {2, 0, 0, 0, 0, 0});
  rig.run(4 * kSecond);
  EXPECT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults_cleared.size(), 1u);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  EXPECT_EQ(rig.moves_finished(), 1);
}

// Every command is either refused or followed, whatever comes when, and the arm can always move afterwards.
TEST(Jog, TheArmMovesAfterAnySequenceOfJogsStopsAndMoves) {
  for (int spacing = 1; spacing < 14; ++spacing) {
    ControllerRig rig;
    for (int i = 0; i < 40; ++i) {
      const std::int64_t at = 10 + i * spacing;
      if (i % 5 == 3) {
        rig.submit_at(at, Stop{});
      } else {
        rig.submit_at(at, joints({i % 2 == 0 ? 1.0 : -1.0, 0, 0, 0, 0, 0}, 1 + i % 7));
      }
    }
    rig.move_at(kSecond / 4, {1, 2, 0, 0, 0, 0});
    rig.run(kSecond);
    EXPECT_EQ(rig.moves_finished(), 1) << "spacing " << spacing;
    rig.expect_at({1, 2, 0, 0, 0, 0});
    rig.expect_pulses_conserved();
  }
}

// The first jog may end at the same time as core 1 sends the second one.
TEST(Jog, NoMoveIsPlannedBeforeCore0HasAnsweredTheLatestCommand) {
  test::DispatcherBench bench;
  bench.at_rest(0);
  bench.submit(joints({1, 0, 0, 0, 0, 0}, 1));
  bench.submit(joints({1, 0, 0, 0, 0, 0}, 1));
  bench.submit(JointMove{.target = degrees({1, 0, 0, 0, 0, 0})});
  bench.at_rest(1);
  EXPECT_TRUE(bench.channel->plan_store.plans.empty());
  bench.at_rest(2);
  EXPECT_FALSE(bench.channel->plan_store.plans.empty());
}

TEST(Jog, OfTheToolFollowsTheAxesOfItsFrame) {
  ControllerConfig config;
  config.base_T_user[0] = Transform{rotation_from_rpy(0, 0, std::numbers::pi / 2), {100, 0, 0}};
  for (const FrameId frame : {kBaseFrame, FrameId{1}, kToolFrame}) {
    ControllerRig rig{test::robot_with(test::irb120_geometry()), config};
    const Arm arm{rig.robot};
    rig.move_at(10, {10, 20, -30, 20, 40, 30});
    rig.submit_at(2 * kSecond, tool(frame, {20, 0, 0}, kSecond / 2));
    rig.run(4 * kSecond);
    ASSERT_TRUE(rig.refusals.empty());
    const Transform from = arm.forward(rig.row(2 * kSecond - 1).reference), to = arm.forward(rig.last().reference);
    const Eigen::Vector3d x = frame == kBaseFrame   ? Eigen::Vector3d::UnitX()
                              : frame == kToolFrame ? Eigen::Vector3d{from.rotation.col(0)}
                                                    : Eigen::Vector3d::UnitY();
    EXPECT_NEAR((to.position_mm - from.position_mm).dot(x), 10.0, 0.1);
    EXPECT_LT((to.position_mm - from.position_mm).cross(x).norm(), 1e-6);
    EXPECT_LT((to.rotation - from.rotation).norm(), 1e-9);
    rig.expect_pulses_conserved();
  }
}

TEST(Jog, OfTheToolNeedsSixJoints) {
  RobotModel five = test::paper_robot();
  five.arm.family = ArmFamily::kFiveR;
  const UserFrames none{};
  EXPECT_EQ(find_refusal(five, none, tool(kBaseFrame, {1, 0, 0}, 1))->reason, Refusal::kOrientation);
  five.arm.family = ArmFamily::kNone;
  EXPECT_EQ(find_refusal(five, none, tool(kBaseFrame, {1, 0, 0}, 1))->reason, Refusal::kNoKinematics);
}

TEST(Jog, IsRefusedWithoutADurationOrWithAVelocityThatIsNoNumber) {
  const RobotModel robot = test::robot_with(test::irb120_geometry());
  const UserFrames none{};
  EXPECT_FALSE(find_refusal(robot, none, joints({1, 0, 0, 0, 0, 0}, 1)));
  EXPECT_EQ(find_refusal(robot, none, joints({1, 0, 0, 0, 0, 0}, 0))->reason, Refusal::kInvalidTarget);
  EXPECT_EQ(find_refusal(robot, none, joints({0, 0, NAN, 0, 0, 0}, 1))->axis, 3);
  EXPECT_EQ(find_refusal(robot, none, tool(FrameId{1}, {1, 0, 0}, 1))->reason, Refusal::kInvalidTarget);
  EXPECT_EQ(find_refusal(robot, none, tool(kBaseFrame, {INFINITY, 0, 0}, 1))->reason, Refusal::kInvalidTarget);
}

}  // namespace
}  // namespace armature
