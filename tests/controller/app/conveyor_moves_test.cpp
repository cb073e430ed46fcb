// Paths in the frame of a part on a conveyor, from the commands to the set-points.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/controller/support/conveyor_rig.hpp"

namespace armature {
namespace {

using namespace test::conveyor;

// As conveyor_belt.hpp states it, and a count.
double deviation_after_jump_mm(double accel_mm_s2) {
  return 2.5 * accel_mm_s2 / (200.0 * 200.0) + kCount_mm;
}

TEST(Conveyor, TheToolStaysOnItsLineInTheFrameOfThePart) {
  ConveyorRig conveyor{hundred};
  conveyor.pick();
  conveyor.leave();
  conveyor.rig.run(4 * kSecond);
  EXPECT_TRUE(conveyor.rig.refusals.empty());
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  EXPECT_EQ(conveyor.rig.moves_finished(), 5);
  // One count of the encoder.
  EXPECT_LT(conveyor.tracking_error_mm(conveyor.tick_of(PartPhase::kLeaving)), kCount_mm);
  conveyor.expect_limits_kept();
  // The gripper closes at the part.
  ASSERT_EQ(conveyor.rig.io.size(), 1u);
  EXPECT_LT(distance(conveyor.on_part(conveyor.rig.io[0].first - 1), kSyncPoint), 0.02L);
  conveyor.rig.expect_at({60, 20, 10, 5, 40, -20});
  conveyor.rig.expect_pulses_conserved();
}

TEST(Conveyor, ADwellIsSpentOnThePart) {
  ConveyorRig conveyor{hundred};
  conveyor.line_at(10, 0.0, 1u);
  conveyor.rig.submit_at(10, Dwell{.duration = Ticks{4'000}, .tag = 2u});
  conveyor.line_at(10, -60.0, 3u);
  conveyor.leave();
  conveyor.rig.run(4 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  ASSERT_EQ(conveyor.rig.moves.size(), 5u);
  const MoveStarted& dwell = conveyor.rig.moves[2];
  EXPECT_EQ(dwell.kind, MoveKind::kDwell);
  for (std::int64_t tick = 0; tick < 4'000; tick += 100) {
    EXPECT_LT(distance(conveyor.on_part(dwell.start_tick.value() + tick), kSyncPoint), 0.015L) << tick;
  }
  EXPECT_EQ(conveyor.rig.finished[2].taken, Ticks{4'000});
  conveyor.expect_limits_kept();
}

TEST(Conveyor, ThePartIsFollowedThroughAChangeOfTheSpeed) {
  ConveyorRig conveyor{changing(2.0L, 140.0L, 400.0L)};
  conveyor.pick();
  conveyor.leave();
  conveyor.rig.run(4 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  EXPECT_LT(conveyor.tick_of(PartPhase::kSynchronised), 2 * kSecond);
  EXPECT_GT(conveyor.tick_of(PartPhase::kLeaving), 2 * kSecond);
  EXPECT_LT(conveyor.tracking_error_mm(conveyor.tick_of(PartPhase::kLeaving)), deviation_after_jump_mm(400.0));
  conveyor.expect_limits_kept();
}

TEST(Conveyor, ThePartIsFollowedWhereTheBeltStops) {
  ConveyorRig conveyor{changing(2.0L, 0.0L, 1'000.0L)};
  conveyor.pick();
  conveyor.leave();
  conveyor.rig.run(4 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  EXPECT_LT(conveyor.tracking_error_mm(conveyor.tick_of(PartPhase::kLeaving)), deviation_after_jump_mm(1'000.0));
  conveyor.expect_limits_kept();
}

TEST(Conveyor, TheArmStopsWhereThePartLeavesTheWindow) {
  ConveyorRig conveyor{hundred};
  conveyor.line_at(10, -40.0, 1u);
  conveyor.line_at(10, 0.0, 2u);
  conveyor.rig.submit_at(10, WaitInput{.pin = 3, .level = true, .tag = 3u});
  conveyor.line_at(10, -60.0, 4u);
  conveyor.leave();
  conveyor.rig.run(6 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kWindow});
  ASSERT_EQ(conveyor.rig.refusals.size(), 3u);
  for (const MoveRefused& refusal : conveyor.rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kPartLost);
  const std::int64_t end = conveyor.tick_of(PartPhase::kEnded);
  EXPECT_NEAR(static_cast<double>(end), kPartTrigger + kTo_mm / 100.0 * kSecond - 2, 3.0);
  EXPECT_LT(conveyor.tracking_error_mm(end), kCount_mm);
  EXPECT_EQ(conveyor.rig.last().state, MotionState::kIdle);
  conveyor.expect_limits_kept();
  conveyor.rig.expect_pulses_conserved();
}

TEST(Conveyor, APathThatEndsBehindTheWindowIsRefusedBeforeAnyMotion) {
  ConveyorRig conveyor{hundred};
  conveyor.line_at(10, -40.0, 1u, 10.0);
  conveyor.leave();
  conveyor.rig.run(2 * kSecond);
  ASSERT_EQ(conveyor.rig.refusals.size(), 2u);
  EXPECT_EQ(conveyor.rig.refusals[0].reason, Refusal::kPartLost);
  EXPECT_TRUE(conveyor.rig.parts.empty());
  EXPECT_EQ(conveyor.rig.moves.size(), 1u);
}

TEST(Conveyor, ABeltThatIsTooFastIsNotFollowed) {
  ConveyorRig conveyor{[](Real t_s) { return 250.0L * t_s; }};
  conveyor.line_at(10, -40.0, 1u);
  conveyor.rig.run(2 * kSecond);
  ASSERT_EQ(conveyor.rig.refusals.size(), 1u);
  EXPECT_EQ(conveyor.rig.refusals[0].reason, Refusal::kBeltTooFast);
  EXPECT_TRUE(conveyor.rig.parts.empty());
}

TEST(Conveyor, TheArmStopsWhenTheBeltBecomesTooFast) {
  ConveyorRig conveyor{changing(2.0L, 250.0L, 500.0L)};
  conveyor.pick();
  conveyor.rig.submit_at(10, WaitInput{.pin = 3, .level = true, .tag = 6u});
  conveyor.rig.run(4 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kTooFast});
  conveyor.expect_limits_kept();
  EXPECT_EQ(conveyor.rig.last().state, MotionState::kIdle);
}

TEST(Conveyor, AStopAndAHoldEndTheFollowing) {
  for (const Command& command : {Command{Stop{}}, Command{Hold{}}}) {
    ConveyorRig conveyor{hundred};
    conveyor.pick();
    conveyor.leave();
    conveyor.rig.submit_at(2 * kSecond, command);
    conveyor.rig.submit_at(3 * kSecond, Resume{});
    conveyor.rig.move_at(3 * kSecond, {10, 0, 0, 0, 0, 0});
    conveyor.rig.run(5 * kSecond);
    EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kStopped});
    EXPECT_EQ(conveyor.rig.io.size() + conveyor.rig.refusals.size() + conveyor.rig.finished.size(), 7u);
    conveyor.expect_limits_kept();
    conveyor.rig.expect_at({10, 0, 0, 0, 0, 0});
  }
}

TEST(Conveyor, AJogAndAMoveThatBeginsAtOnceAreRefusedOnThePart) {
  ConveyorRig conveyor{hundred};
  conveyor.pick();
  conveyor.leave();
  conveyor.rig.submit_at(2 * kSecond, Jog{.duration = Ticks{100}, .tag = 11u});
  conveyor.rig.submit_at(2 * kSecond, JointMove{.target = test::degrees({10, 0, 0, 0, 0, 0}), .now = true, .tag = 12u});
  conveyor.rig.run(4 * kSecond);
  ASSERT_EQ(conveyor.rig.refusals.size(), 2u);
  for (const MoveRefused& refusal : conveyor.rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
  EXPECT_LT(conveyor.tick_of(PartPhase::kBegun), 2 * kSecond);
  EXPECT_GT(conveyor.tick_of(PartPhase::kLeaving), 2 * kSecond);
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  conveyor.rig.expect_at({60, 20, 10, 5, 40, -20});
}

TEST(Conveyor, AFaultEndsTheFollowingAndTheNextPartIsPicked) {
  ConveyorRig conveyor{hundred};
  conveyor.pick();
  conveyor.rig.at(2 * kSecond, [&] { conveyor.rig.logic.pins.drive_alarm = 1; });
  conveyor.rig.at(2 * kSecond + 4'000, [&] { conveyor.rig.logic.pins.drive_alarm = 0; });
  conveyor.rig.submit_at(2 * kSecond + 8'000, ClearFault{});
  conveyor.part_at(3 * kSecond);
  conveyor.rig.submit_at(3 * kSecond, PoseMove{.target = {.position_mm = {380, -60, 260}}});
  conveyor.line_at(3 * kSecond + 10, -40.0, 11u);
  conveyor.rig.submit_at(3 * kSecond + 10, JointMove{.target = test::degrees({60, 20, 10, 5, 40, -20})});
  conveyor.rig.run(6 * kSecond);
  EXPECT_EQ(conveyor.ends(), (std::vector{PartEnd::kFault, PartEnd::kReleased}));
  conveyor.rig.expect_at({60, 20, 10, 5, 40, -20});
}

TEST(Conveyor, APartThatHasPassedIsMissedAndTheNextOneIsPicked) {
  ConveyorRig conveyor{hundred};
  conveyor.part_at(3 * kSecond);
  conveyor.line_at(5 * kSecond, -40.0, 1u);
  conveyor.leave();
  conveyor.rig.submit_at(5 * kSecond + 10, JointMove{.target = test::degrees({10, 0, 0, 0, 0, 0})});
  conveyor.rig.run(9 * kSecond);
  ASSERT_FALSE(conveyor.rig.parts.empty());
  EXPECT_EQ(conveyor.rig.parts[0].phase, PartPhase::kMissed);
  EXPECT_EQ(conveyor.rig.parts[0].part, 0u);
}

TEST(Conveyor, APathAtTheLimitsOfTheJointsIsSlowedDownForTheBelt) {
  ConveyorRig conveyor{hundred};
  for (const auto& [z_mm, tag] : {std::pair{-40.0, Tag{1u}}, std::pair{0.0, Tag{2u}}}) {
    conveyor.rig.submit_at(
        10,
        CartesianMove{
            .target = {.frame = kConveyorFrame, .position_mm = {0, 0, z_mm}},
            .limits = {.speed_mm_s = 5'000.0, .accel_mm_s2 = 1e6, .turn_speed_rad_s = 100.0, .turn_accel_rad_s2 = 1e4},
            .tag = tag});
  }
  conveyor.leave();
  conveyor.rig.run(4 * kSecond);
  EXPECT_TRUE(conveyor.rig.refusals.empty());
  EXPECT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  conveyor.expect_limits_kept();
}

TEST(Conveyor, OnlyPathsOfASixAxisArmMoveWithIt) {
  ConveyorRig conveyor{hundred};
  conveyor.rig.submit_at(10, PoseMove{.target = {.frame = kConveyorFrame}});
  conveyor.rig.submit_at(kSecond, Jog{.kind = Jog::Kind::kTool, .frame = kConveyorFrame, .duration = Ticks{10}});
  conveyor.rig.run(kSecond + 100);
  ASSERT_EQ(conveyor.rig.refusals.size(), 2u);
  for (const MoveRefused& refusal : conveyor.rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kInvalidTarget);

  ControllerConfig config = with_conveyor();
  config.conveyor.reset();
  ConveyorRig without{hundred, config};
  without.line_at(10, -40.0, 1u);
  without.rig.run(100);
  ASSERT_EQ(without.rig.refusals.size(), 1u);
  EXPECT_EQ(without.rig.refusals[0].reason, Refusal::kInvalidTarget);
}

}  // namespace
}  // namespace armature
