// The motion loop on register level: start, moves, stop. What stops it: motion_loop_faults_test.cpp, lateness_test.cpp.
#include "controller/motion/motion_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

TEST(MotionLoop, StartsIdleWithTheDrivesOn) {
  ControllerRig rig;
  rig.run(100);
  EXPECT_EQ(rig.rows.size(), 100u - 1u);  // the last trigger switches the core off
  EXPECT_EQ(rig.row(0).tick, Ticks{0});
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.logic.servo_on(), 0x3Fu);
  EXPECT_EQ(rig.logic.underruns(), 0u);
  EXPECT_EQ(rig.logic.faults_read() & regs::pulse_train::kFaultRecommitMask, 0u);
}

TEST(MotionLoop, AClockThatStoodStillIsAFaultAtRestAndInAMove) {
  for (const bool moving : {false, true}) {
    ControllerRig rig;
    if (moving) rig.move_at(100, kFigure9Deg);
    rig.at(500, [&] { rig.logic.stand_still(kTickCycles.value()); });
    rig.run(1'000);
    ASSERT_EQ(rig.faults.size(), 1u);
    EXPECT_EQ(rig.faults[0].cause, FaultCause::kClock);
    EXPECT_NEAR(static_cast<double>(rig.faults[0].tick.value()), 500, 2);
    EXPECT_EQ(rig.logic.servo_on(), 0u);
  }
}

// Of a late core, lateness_test.cpp.
TEST(MotionLoop, APauseOfAQuarterTickIsNoFaultOfTheClock) {
  ControllerRig rig;
  rig.at(500, [&] { rig.logic.stand_still(kTickCycles.value() / 4); });
  rig.run(1'000);
  EXPECT_TRUE(rig.faults.empty());
}

TEST(MotionLoop, AnotherBlockThanItsOwnKeepsItFromStarting) {
  for (const bool pulse_train : {true, false}) {
    ControllerRig rig;
    rig.logic.planted.plant(pulse_train ? test::ModelLogic::kPulses : test::ModelLogic::kEncoder, 0xBADA'CCE5);
    rig.move_at(0, kFigure9Deg);
    rig.submit(JointMove{});
    rig.run(100);
    ASSERT_EQ(rig.faults.size(), 1u);
    EXPECT_EQ(rig.faults[0].cause, FaultCause::kHardwareId);
    EXPECT_EQ(rig.faults[0].tick, Ticks{-1});
    EXPECT_EQ(rig.logic.triggers(), 0);
    EXPECT_EQ(rig.logic.servo_on(), 0u);
    ASSERT_EQ(rig.refusals.size(), 1u);
    EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  }
}

TEST(MotionLoop, AnEncoderThatNeverSettledKeepsTheDrivesOff) {
  ControllerRig rig;
  const RegAddr known = test::ModelLogic::kEncoder + regs::encoder::kKnownOffset;
  rig.logic.planted.plant(known, 0b101011);
  rig.move_at(500, {1, 1, 1, 1, 1, 1});  // in Fault: refused
  rig.at(900, [&] { EXPECT_EQ(rig.logic.servo_on(), 0u); });
  rig.submit_at(1'000, ClearFault{});
  rig.at(2'000, [&] { rig.logic.planted.remove(known); });
  rig.submit_at(2'100, ClearFault{});
  rig.move_at(2'200, {3, -3, 3, -3, 3, -3});
  rig.run(10'000);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kEncoder);
  EXPECT_EQ(rig.faults[0].axis, 3);
  EXPECT_EQ(rig.faults[0].tick, Ticks{-1});
  EXPECT_EQ(rig.row(2'050).state, MotionState::kFault);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.refusals.size(), 2u);  // the move and the first ClearFault
  EXPECT_EQ(rig.logic.faults_read() & regs::pulse_train::kFaultRecommitMask, 0u);
  EXPECT_EQ(rig.logic.underruns(), 0u);
  rig.expect_at({3, -3, 3, -3, 3, -3});
}

TEST(MotionLoop, Figure9EmitsThePulseTotalsOfThePaper) {
  ControllerRig rig;
  rig.move_at(9, kFigure9Deg);
  rig.run(20'000);
  const PerAxis<std::int64_t> totals{111'667, -83'333, 69'444, 24'167, -24'167, 97'222};
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rig.logic.emitted(axis), totals[axis]);
  rig.expect_pulses_conserved();
  rig.expect_at(kFigure9Deg);
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(rig.moves[0].duration, Ticks{17'400});
  EXPECT_EQ(rig.moves[0].start_tick, Ticks{9});
  EXPECT_EQ(rig.moves[0].shape[3], ProfileShape::kTriangle);
  EXPECT_NEAR(rig.moves[0].peak_speed_rad_s[3] / test::kDeg, 40.0, 1e-9);
  EXPECT_LE(rig.logic.largest_count(), 9);
}

TEST(MotionLoop, IsMovingForExactlyTheDurationOfTheMove) {
  ControllerRig rig;
  rig.move_at(9, kFigure9Deg);
  rig.run(20'000);
  const auto moving = std::count_if(rig.rows.begin(), rig.rows.end(),
                                    [](const Telemetry& row) { return row.state == MotionState::kMoving; });
  EXPECT_EQ(moving, 17'400);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.moves_finished(), 1);
}

TEST(MotionLoop, MovesFollowEachOtherWithoutAPause) {
  ControllerRig rig;
  for (const double target_deg : {5.0, 10.0, -3.0, 0.0}) rig.move_at(0, {target_deg, 0, 0, 0, 0, 0});
  rig.run(20'000);
  ASSERT_EQ(rig.moves.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(rig.moves[i].start_tick, rig.moves[i - 1].start_tick + rig.moves[i - 1].duration);
  }
  EXPECT_EQ(rig.moves_finished(), 4);
  rig.expect_at({});
  rig.expect_pulses_conserved();
}

TEST(MotionLoop, ZeroAndTinyMovesEmitWhatRoundingSays) {
  ControllerRig rig;
  constexpr double kPulseDeg = 7.2e-4;
  rig.move_at(0, {0, 0.4 * kPulseDeg, 0.6 * kPulseDeg, kPulseDeg, -0.6 * kPulseDeg, -kPulseDeg});
  rig.move_at(100, {0, 0.4 * kPulseDeg, 0.6 * kPulseDeg, kPulseDeg, -0.6 * kPulseDeg, -kPulseDeg});  // no way to go
  rig.run(2'000);
  const PerAxis<std::int64_t> totals{0, 0, 1, 1, -1, -1};
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rig.logic.emitted(axis), totals[axis]);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves[1].duration, Ticks{0});
  EXPECT_EQ(rig.moves_finished(), 2);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
}

TEST(MotionLoop, ReachesButNeverExceeds200PulsesATick) {
  ControllerRig rig{test::fine_robot()};
  const PerAxis<double> target_deg{60, -60, 60, -60, 60, -60};
  rig.move_at(0, target_deg);
  rig.move_at(0, {});  // back at once: a reversal at the end
  rig.run(25'000);
  EXPECT_EQ(rig.logic.largest_count(), 200);
  EXPECT_EQ(rig.moves_finished(), 2);
  EXPECT_TRUE(rig.faults.empty());
  rig.expect_at({});
  rig.expect_pulses_conserved();
}

TEST(MotionLoop, TheEncoderPositionSurvivesTheWrapOfItsRegister) {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_rad = 1e9;  // 2^31 counts are 1.5e6 degrees
  ControllerRig rig{robot};
  for (auto& drive : rig.logic.drives) drive.position = drive.reference = 0x7FFF'FFFF - 20'000.0;
  const double start_deg = (0x7FFF'FFFF - 20'000.0) * 7.2e-4;
  rig.move_at(10, {start_deg + 40, start_deg, start_deg, start_deg, start_deg, start_deg});
  rig.run(20'000);
  EXPECT_TRUE(rig.faults.empty());
  EXPECT_NEAR(static_cast<double>(rig.last().encoder[0].value()), (start_deg + 40) / 7.2e-4, 1.0);
  EXPECT_GT(rig.last().encoder[0], Counts{0x7FFF'FFFF});
}

TEST(MotionLoop, StopBrakesOnThePathAndTheNextMoveStartsThere) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.submit_at(8'000, Stop{});
  rig.move_at(8'001, {});  // arrives while the arm brakes
  rig.run(30'000);
  ASSERT_EQ(rig.moves.size(), 2u);
  const auto stopping = std::count_if(rig.rows.begin(), rig.rows.end(),
                                      [](const Telemetry& row) { return row.state == MotionState::kStopping; });
  EXPECT_NEAR(static_cast<double>(stopping), 0.2 / 50e-6, 20.0);
  for (std::int64_t tick = 1; tick < static_cast<std::int64_t>(rig.rows.size()) - 1; ++tick) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double bend = (rig.row(tick + 1).reference[axis] - rig.row(tick).reference[axis]).value() -
                          (rig.row(tick).reference[axis] - rig.row(tick - 1).reference[axis]).value();
      ASSERT_LE(std::fabs(bend) / (50e-6 * 50e-6), rig.robot.axes[axis].max_accel_rad_s2 * 1.001) << "tick " << tick;
    }
  }
  ASSERT_EQ(rig.finished.size(), 2u);
  const MoveFinished& stopped = rig.finished[0];
  EXPECT_EQ(stopped.how, MoveFinished::How::kCutShort);
  EXPECT_EQ(stopped.taken, stopped.tick - rig.moves[0].start_tick);
  EXPECT_EQ(rig.row(stopped.tick.value() - 1).state, MotionState::kStopping);
  EXPECT_NE(rig.row(stopped.tick.value()).state, MotionState::kStopping);
  EXPECT_EQ(rig.finished[1].how, MoveFinished::How::kReachedEnd);
  rig.expect_at({});
  rig.expect_pulses_conserved();
}

TEST(MotionLoop, StopDropsQueuedMoves) {
  ControllerRig rig;
  for (int i = 0; i < 12; ++i) rig.move_at(0, {i % 2 == 0 ? 30.0 : 0.0, 0, 0, 0, 0, 0});
  rig.submit_at(2'000, Stop{});
  rig.run(20'000);
  EXPECT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  ASSERT_EQ(rig.refusals.size(), 11u);  // eight of them were planned already
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
  rig.expect_pulses_conserved();
}

TEST(MotionLoop, StopWhileIdleChangesNothing) {
  ControllerRig rig;
  rig.submit_at(5, Stop{});
  rig.move_at(6, {10, 0, 0, 0, 0, 0});
  rig.run(10'000);
  EXPECT_EQ(rig.moves_finished(), 1);
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

}  // namespace
}  // namespace armature
