#include "controller/command/dispatcher.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/controller/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;

class FindRefusal : public testing::Test {
 protected:
  const RobotModel robot = test::paper_robot();

  void expect(const JointMove& move, Refusal reason, int axis) const {
    const auto refusal = find_refusal(robot, move);
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->reason, reason);
    EXPECT_EQ(refusal->axis, axis);
  }
};

TEST_F(FindRefusal, AcceptsTheLimitsThemselves) {
  JointMove move;
  move.target[0] = Radians{robot.axes[0].max_rad};
  move.target[1] = Radians{robot.axes[1].min_rad};
  EXPECT_FALSE(find_refusal(robot, move));
}

TEST_F(FindRefusal, NamesTheFirstAxisOutsideItsLimits) {
  expect({.target = degrees({0, 0, 170.001, -171, 0, 0})}, Refusal::kOutsideLimits, 3);
  expect({.target = degrees({0, 0, 0, 0, 0, -170.001})}, Refusal::kOutsideLimits, 6);
}

TEST_F(FindRefusal, RefusesWhatIsNoNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    JointMove move;
    move.target[4] = Radians{bad};
    expect(move, Refusal::kInvalidTarget, 5);
  }
}

TEST_F(FindRefusal, RefusesASpeedOutside0To1) {
  for (const double speed : {0.0, -0.5, 1.0000001, std::nan("")}) {
    expect({.target = {}, .speed = speed}, Refusal::kInvalidTarget, 0);
  }
  EXPECT_FALSE(find_refusal(robot, {.target = {}, .speed = 1.0}));
  EXPECT_FALSE(find_refusal(robot, {.target = {}, .speed = 1e-3}));
}

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
  EXPECT_EQ(rig.last().moves_finished, 2);
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
  constexpr int kMoves = static_cast<int>(MotionMailbox::kPlans + Dispatcher::kWaitingMoves) + 10;
  for (int i = 0; i < kMoves; ++i) rig.move_at(10 + i, {i % 2 == 0 ? 20.0 : 0.0, 0, 0, 0, 0, 0});
  rig.run(220'000);
  // One is being executed, the others wait.
  EXPECT_EQ(rig.moves.size(), 1 + MotionMailbox::kPlans + Dispatcher::kWaitingMoves);
  EXPECT_EQ(rig.moves.size() + rig.refusals.size(), static_cast<std::size_t>(kMoves));
  for (const MoveRefusal& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kQueueFull);
  EXPECT_EQ(rig.last().moves_finished, static_cast<std::int64_t>(rig.moves.size()));
}

TEST(Dispatcher, MovesThatArriveBeforeTheStartAreExecutedAfterIt) {
  ControllerRig rig;
  rig.submit(JointMove{.target = degrees({1, 2, 3, 4, 5, 6})});
  rig.run(10'000);
  rig.expect_at({1, 2, 3, 4, 5, 6});
}

TEST(Dispatcher, TheInboxReportsWhenItIsFull) {
  ControllerRig rig;
  Controller controller{rig.robot, {}, rig};
  for (std::size_t i = 0; i < Dispatcher::kInbox; ++i) EXPECT_TRUE(controller.submit(Stop{}));
  EXPECT_FALSE(controller.submit(Stop{}));
}

TEST(Dispatcher, ClearFaultOutsideFaultChangesNothing) {
  ControllerRig rig;
  rig.move_at(0, {10, 0, 0, 0, 0, 0});
  rig.submit_at(1'000, ClearFault{});
  rig.run(10'000);
  EXPECT_EQ(rig.last().moves_finished, 1);
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(Dispatcher, AFaultDropsTheMovesThatWait) {
  ControllerRig rig;
  for (int i = 0; i < 14; ++i) rig.move_at(0, {i % 2 == 0 ? 30.0 : 0.0, 0, 0, 0, 0, 0});
  rig.at(1'000, [&] { rig.logic.alarm = 1; });
  rig.at(1'100, [&] { rig.logic.alarm = 0; });
  rig.submit_at(5'000, ClearFault{});
  rig.run(10'000);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.moves.size(), 1u);
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
  rig.expect_at({0, 5, 0, 0, 0, 0});
}

}  // namespace
}  // namespace armature
