#include "controller/pendant/parts/arm_view.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

class ArmViewTest : public testing::Test {
 protected:
  test::PartsBench bench;
  ArmView& arm = bench.parts.arm;
  const Tag ours{Source::kPendant, 1};
};

TEST_F(ArmViewTest, TheStateIsTheWorstThatIsTrue) {
  EXPECT_EQ(bench.state(), State::kOff);
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  EXPECT_EQ(bench.state(), State::kIdle);
  EXPECT_FALSE(arm.drives_on());
  bench.notify(FaultCleared{});
  EXPECT_EQ(bench.state(), State::kReady);
  EXPECT_TRUE(arm.drives_on());
  bench.notify(MoveStarted{});
  EXPECT_EQ(bench.state(), State::kMove);
  bench.notify(JogStarted{});
  EXPECT_EQ(bench.state(), State::kJog);
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_TRUE(bench.program.run());
  EXPECT_EQ(bench.state(), State::kRun);
  EXPECT_TRUE(bench.program.hold());
  EXPECT_EQ(bench.state(), State::kHold);
  bench.notify(Faulted{.cause = FaultCause::kDriveAlarm});
  EXPECT_EQ(bench.state(), State::kAlarm);
  arm.latch_estop();
  EXPECT_EQ(bench.state(), State::kEstop);
}

TEST_F(ArmViewTest, APressedKeyIsAJogUntilTheDeadMansTime) {
  bench.switch_on();
  bench.parts.manual.press(2, 0.5, Cycles{100});
  const Cycles end{100 + kDeadMan.value() * kTickCycles.value()};
  EXPECT_EQ(bench.state(end - Cycles{1}), State::kJog);
  EXPECT_TRUE(arm.moves(end - Cycles{1}));
  EXPECT_EQ(bench.state(end), State::kReady);
}

TEST_F(ArmViewTest, AnAlarmIsAcknowledgedByTheOperatorAndItsCauseStaysUntilTheDrivesAreOn) {
  bench.switch_on();
  bench.notify(Faulted{.cause = FaultCause::kDriveAlarm, .axis = 3});
  EXPECT_EQ(kAlarmCause.of(arm.alarm()), static_cast<int>(FaultCause::kDriveAlarm));
  EXPECT_EQ(kAlarmAxis.of(arm.alarm()), 3);
  arm.reset_alarm();
  EXPECT_EQ(bench.state(), State::kIdle);
  EXPECT_NE(arm.alarm(), 0);
  bench.notify(FaultCleared{});
  EXPECT_EQ(arm.alarm(), 0);
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  EXPECT_EQ(arm.alarm(), 0);
  EXPECT_EQ(bench.state(), State::kIdle);
}

TEST_F(ArmViewTest, AnEmergencyStopNeedsItsResetAndThatOfTheAlarm) {
  bench.switch_on();
  bench.notify(Faulted{.cause = FaultCause::kEstop});
  bench.notify(FaultCleared{});
  EXPECT_EQ(bench.state(), State::kEstop);
  arm.reset_estop();
  EXPECT_EQ(bench.state(), State::kAlarm);
  arm.reset_alarm();
  EXPECT_EQ(bench.state(), State::kReady);
}

TEST_F(ArmViewTest, BetweenTheAxesOfAHomingItMovesAsLongAsAnAxisIsLeft) {
  bench.switch_on();
  arm.expect_homing(0b101);
  EXPECT_EQ(bench.state(), State::kReady);
  bench.notify(HomingStarted{.tag = ours, .axis = 1});
  bench.notify(HomingEnded{.tag = ours, .axis = 1});
  EXPECT_EQ(bench.state(), State::kMove);
  bench.notify(HomingStarted{.tag = ours, .axis = 3});
  bench.notify(HomingEnded{.tag = ours, .axis = 3});
  EXPECT_EQ(bench.state(), State::kReady);
}

TEST_F(ArmViewTest, AFailedAxisEndsTheHomingOfTheOthers) {
  bench.switch_on();
  arm.expect_homing(0b11);
  bench.notify(HomingStarted{.tag = ours, .axis = 1});
  bench.notify(HomingEnded{.tag = ours, .axis = 1, .how = HomingEnd::kNoSwitch});
  EXPECT_EQ(bench.state(), State::kReady);
}

TEST_F(ArmViewTest, TheHomingOfAnotherSourceLeavesNoFurtherAxes) {
  bench.switch_on();
  arm.expect_homing(0b11);
  bench.notify(HomingStarted{.tag = Tag{5}, .axis = 1});
  bench.notify(HomingEnded{.tag = Tag{5}, .axis = 1});
  EXPECT_EQ(bench.state(), State::kReady);
}

}  // namespace
}  // namespace armature::pendant
