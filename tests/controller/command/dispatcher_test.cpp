#include "controller/command/dispatcher.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <iterator>

#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;

TEST(Dispatcher, RefusesBeforeAnythingMoves) {
  ControllerRig rig;
  rig.move_at(5, {10, 0, 0, 0, 0, 171});
  rig.run(1'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kOutsideLimits);
  EXPECT_EQ(rig.refusals[0].axis, 6);
  EXPECT_TRUE(rig.moves.empty());
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rig.logic.emitted(axis), 0);
}

TEST(Dispatcher, ARefusedMoveDoesNotDisturbThoseAroundIt) {
  ControllerRig rig;
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  rig.move_at(5, {999, 0, 0, 0, 0, 0});
  rig.move_at(5, {0, 10, 0, 0, 0, 0});
  rig.run(15'000);
  EXPECT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.moves_finished(), 2);
  rig.expect_at({0, 10, 0, 0, 0, 0});
}

TEST(Dispatcher, PlansTheNextMoveFromTheEndOfTheOneBefore) {
  ControllerRig rig;
  rig.move_at(0, {30, 0, 0, 0, 0, 0});
  rig.move_at(100, {60, 0, 0, 0, 0, 0});  // the first is still running
  rig.run(25'000);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves[0].duration, rig.moves[1].duration);
  rig.expect_at({60, 0, 0, 0, 0, 0});
}

TEST(Dispatcher, RefusesAMoveWhenItsQueueIsFull) {
  ControllerRig rig;
  constexpr int kMoves = static_cast<int>(PlanStore::kPlans + MoveQueue::kMoves) + 10;
  for (int i = 0; i < kMoves; ++i) rig.move_at(10 + i, {i % 2 == 0 ? 20.0 : 0.0, 0, 0, 0, 0, 0});
  rig.run(220'000);
  // One is being executed, the others wait.
  EXPECT_EQ(rig.moves.size(), PlanStore::kPlans + MoveQueue::kMoves);
  EXPECT_EQ(rig.moves.size() + rig.refusals.size(), static_cast<std::size_t>(kMoves));
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kQueueFull);
  EXPECT_EQ(rig.moves_finished(), static_cast<std::int64_t>(rig.moves.size()));
}

TEST(Dispatcher, MovesThatArriveBeforeTheStartAreExecutedAfterIt) {
  ControllerRig rig;
  rig.submit(JointMove{.target = degrees({1, 2, 3, 4, 5, 6})});
  rig.run(10'000);
  rig.expect_at({1, 2, 3, 4, 5, 6});
}

TEST(Dispatcher, ReportsWhenTheHostMemoryIsFull) {
  host_memory::HostMemory memory;
  host_memory::HostSide host{memory};
  for (std::size_t i = 0; i < kInboxCommands; ++i) EXPECT_TRUE(host.submit(Source::kScenario, Stop{}));
  EXPECT_FALSE(host.submit(Source::kScenario, Stop{}));
}

TEST(Dispatcher, ClearFaultOutsideFaultChangesNothing) {
  ControllerRig rig;
  rig.move_at(0, {10, 0, 0, 0, 0, 0});
  rig.submit_at(1'000, ClearFault{});
  rig.run(10'000);
  EXPECT_EQ(rig.moves_finished(), 1);
  EXPECT_TRUE(rig.refusals.empty());
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(Dispatcher, ClearFaultIsRefusedOnHardwareThatIsNotItsOwn) {
  ControllerRig rig;
  rig.logic.planted.plant(test::ModelLogic::kPulses, 0);
  rig.run(1);  // the trigger never starts: commands come after the notice
  for (const Command& command : {Command{ClearFault{}}, Command{JointMove{}}, Command{ClearFault{}}}) {
    rig.submit(command);
    rig.serve_core1();
  }
  ASSERT_EQ(rig.refusals.size(), 3u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
}

// What would take too long, be it beyond what a tick counter can hold.
TEST(Dispatcher, RefusesAMoveOfMoreThanADay) {
  ControllerRig rig;
  const double speeds[] = {7e-6, 1e-6, 1e-8, 1e-16, 1e-22, 1e-100, 1e-310, 5e-324};
  for (const double speed : speeds) rig.move_at(5, {80, 0, 0, 0, 0, 0}, speed);
  rig.move_at(6, {0, 10, 0, 0, 0, 0});  // planned from where the arm stands
  rig.run(10'000);
  ASSERT_EQ(rig.refusals.size(), std::size(speeds));
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kInvalidTarget);
  EXPECT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(rig.logic.emitted(0), 0);
  rig.expect_at({0, 10, 0, 0, 0, 0});
}

TEST(Dispatcher, AcceptsAMoveOfAlmostADay) {
  ControllerRig rig;
  rig.move_at(5, {80, 0, 0, 0, 0, 0}, 8e-6);  // 80 deg at 9.6e-4 deg/s: 83'333 s
  rig.run(1'000);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(rig.moves[0].duration.value() / 20'000, 83'333);
}

TEST(Dispatcher, HearsEverythingThatHappenedWhileItSlept) {
  ControllerRig rig;
  rig.core1_awake = [&] { return rig.logic.triggers() > 200; };
  rig.at(100, [&] { rig.logic.pins.drive_alarm = 1; });  // the start and a fault: as many notices as there can be
  rig.at(102, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(400, ClearFault{});
  rig.run(1'000);
  EXPECT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
}

TEST(Dispatcher, AStopThatMeetsAFaultLeavesRoomForTheClearFault) {
  ControllerRig rig;
  rig.at(100, [&] {
    rig.submit(Stop{});
    rig.logic.pins.drive_alarm = 1;
  });
  rig.at(101, [&] {
    rig.submit(ClearFault{});  // two unread orders: as many as there can be
    rig.logic.pins.drive_alarm = 0;
  });
  rig.submit_at(400, ClearFault{});
  rig.run(1'000);
  EXPECT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
}

// Under stops, faults and a core 1 that sleeps now and then, which also fills the queues between the cores.
TEST(Dispatcher, EveryMoveIsStartedOrReportedAsRefused) {
  constexpr std::uint64_t kSeed = 83;
  constexpr std::int64_t kRounds = 40, kRound = 2'000;
  test::Random random{kSeed};
  ControllerRig rig;
  std::int64_t percent = 100;
  rig.core1_awake = [&] { return random.integer(0, 99) < percent; };
  std::size_t submitted = 0;
  for (std::int64_t round = 0; round < kRounds; ++round) {
    const std::int64_t start = round * kRound;
    rig.at(start, [&] { percent = random.integer(0, 1) == 0 ? 100 : 4; });
    for (auto moves = random.integer(0, 40); moves > 0; --moves, ++submitted) {
      rig.move_at(start + random.integer(0, 1'400), {random.real(-0.1, 0.1), 0, 0, 0, 0, 0});
    }
    for (auto stops = random.integer(0, 3); stops > 0; --stops) {
      rig.submit_at(start + random.integer(0, 1'400), Stop{});
    }
    if (random.integer(0, 1) == 0) {
      const std::int64_t fault = start + random.integer(100, 1'300);
      if (random.integer(0, 1) == 0) rig.submit_at(fault - random.integer(0, 60), Stop{});
      rig.at(fault, [&] { rig.logic.pins.drive_alarm = 1; });
      rig.at(fault + 2, [&] { rig.logic.pins.drive_alarm = 0; });
    }
    rig.submit_at(start + 1'800, ClearFault{});
  }
  rig.at(kRounds * kRound, [&] { percent = 100; });
  rig.run(kRounds * kRound + 20'000);
  EXPECT_GT(rig.faults.size(), 10u) << "seed " << kSeed;
  EXPECT_GT(rig.moves.size(), 50u) << "seed " << kSeed;
  EXPECT_GT(rig.refusals.size(), 50u) << "seed " << kSeed;
  EXPECT_EQ(rig.moves.size() + rig.refusals.size(), submitted) << "seed " << kSeed;
  EXPECT_EQ(rig.last().state, MotionState::kIdle) << "seed " << kSeed;
  EXPECT_EQ(rig.logic.emitted(0), rig.last().commanded[0].value()) << "seed " << kSeed;
}

TEST(Dispatcher, AFaultDropsTheMovesThatWait) {
  ControllerRig rig;
  for (int i = 0; i < 14; ++i) rig.move_at(0, {i % 2 == 0 ? 30.0 : 0.0, 0, 0, 0, 0, 0});
  rig.at(1'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(1'100, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(5'000, ClearFault{});
  rig.run(10'000);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.moves.size(), 1u);
  ASSERT_EQ(rig.refusals.size(), 13u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
}

TEST(Dispatcher, AMoveAndAStopInOneGoLeaveTheArmWhereItIs) {
  ControllerRig rig;
  rig.at(100, [&] {
    rig.submit(JointMove{.target = degrees({10, 0, 0, 0, 0, 0})});
    rig.submit(Stop{});
    rig.submit(JointMove{.target = degrees({0, 5, 0, 0, 0, 0})});
  });
  rig.run(10'000);
  EXPECT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(rig.refusals.size(), 1u);
  rig.expect_at({0, 5, 0, 0, 0, 0});
}

TEST(Dispatcher, AxesThatTheRobotHasNotAreNeverMoved) {
  RobotModel robot = test::paper_robot();
  robot.axis_count = 5;
  AxisModel& none = robot.axes[5];
  none.min_rad = none.max_rad = none.max_speed_rad_s = none.max_accel_rad_s2 = 0.0;
  ControllerRig rig{robot};
  rig.move_at(0, {5, -5, 5, -5, 5, 0});
  rig.move_at(0, {5, -5, 5, -5, 5, 1});
  rig.submit_at(2'000, Hold{});
  rig.submit_at(4'000, Resume{});
  rig.run(12'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kInvalidTarget);
  EXPECT_EQ(rig.refusals[0].axis, 6);
  EXPECT_EQ(rig.logic.emitted(5), 0);
  EXPECT_TRUE(rig.faults.empty());
  rig.expect_at({5, -5, 5, -5, 5, 0});
}

}  // namespace
}  // namespace armature
