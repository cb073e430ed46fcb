// The motion loop on register level: what stops the arm, what is true afterwards, and what ends the stop.
#include "controller/motion/motion_loop.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

struct FaultCase {
  const char* name;
  FaultCause cause;
  std::uint8_t axis;
  void (*provoke)(test::ModelLogic&);
  void (*remove)(test::ModelLogic&);
  bool unhomed = false;  // the axis is not referenced afterwards
};

constexpr RegAddr kEncoderFault = test::ModelLogic::kEncoder + regs::encoder::kFaultOffset;
void nothing(test::ModelLogic&) {}
// A write that the controller has not made.
void enable(test::ModelLogic& logic, std::uint32_t axes) {
  logic.write({regs::soc::kPulseTrainBase + regs::pulse_train::kCtrlOffset}, axes | regs::pulse_train::kCtrlRunMask);
}

const FaultCase kFaultCases[] = {
    {"EmergencyStop", FaultCause::kEstop, 0, [](test::ModelLogic& logic) { logic.pins.estop_n = false; },
     [](test::ModelLogic& logic) { logic.pins.estop_n = true; }},
    {"DriveAlarm", FaultCause::kDriveAlarm, 4, [](test::ModelLogic& logic) { logic.pins.drive_alarm = 0b001000; },
     [](test::ModelLogic& logic) { logic.pins.drive_alarm = 0; }},
    {"IllegalTransition", FaultCause::kEncoder, 2,
     [](test::ModelLogic& logic) { logic.planted.plant(kEncoderFault, 0b000010); }, nothing, true},
    {"IndexMismatch", FaultCause::kEncoder, 6,
     [](test::ModelLogic& logic) { logic.planted.plant(kEncoderFault, 0b100000 << 8); }, nothing, true},
    {"PositiveLimit", FaultCause::kLimitSwitch, 1, [](test::ModelLogic& logic) { logic.pins.limit_pos = 0b000001; },
     nothing},
    {"NegativeLimit", FaultCause::kLimitSwitch, 2, [](test::ModelLogic& logic) { logic.pins.limit_neg = 0b000010; },
     nothing},
    {"FollowingError", FaultCause::kFollowingError, 3, [](test::ModelLogic& logic) { logic.drives[2].stuck = true; },
     [](test::ModelLogic& logic) { logic.drives[2].stuck = false; }, true},
    {"OneServoEnable", FaultCause::kServoEnable, 5, [](test::ModelLogic& logic) { enable(logic, 0b101111); }, nothing},
    {"AllServoEnables", FaultCause::kServoEnable, 0, [](test::ModelLogic& logic) { enable(logic, 0); }, nothing},
};

class MotionLoopFaults : public testing::TestWithParam<FaultCase> {};

TEST_P(MotionLoopFaults, StopsTheArmUntilClearedThenMovesAgainIfItsPositionIsTrue) {
  const FaultCase& param = GetParam();
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.move_at(0, {});  // queued: must not come to life again
  rig.at(6'000, [&] { param.provoke(rig.logic); });
  rig.move_at(14'000, {1, 1, 1, 1, 1, 1});  // in Fault: refused
  rig.at(15'000, [&] { param.remove(rig.logic); });
  rig.submit_at(15'100, ClearFault{});
  rig.move_at(15'200, {3, -3, 3, -3, 3, -3});
  rig.run(50'000);

  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, param.cause);
  EXPECT_EQ(rig.faults[0].axis, param.axis);
  ASSERT_EQ(rig.finished.size(), param.unhomed ? 1u : 2u);
  EXPECT_EQ(rig.finished[0].how, MoveFinished::How::kCutShort);
  EXPECT_EQ(rig.finished[0].tick, rig.faults[0].tick);
  ASSERT_EQ(rig.faults_cleared.size(), 1u);
  EXPECT_EQ(rig.row(rig.faults_cleared[0].tick.value()).state, MotionState::kIdle);
  EXPECT_EQ(rig.row(rig.faults_cleared[0].tick.value() - 1).state, MotionState::kFault);
  // No pulse later than the tick after the fault was found.
  const auto fault_tick = rig.faults[0].tick.value();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(rig.row(fault_tick + 3).commanded[axis], rig.row(14'500).commanded[axis]);
  }
  EXPECT_EQ(rig.row(14'500).state, MotionState::kFault);
  // The queued one, that in Fault, and with an axis that is not referenced any more that behind the reset.
  ASSERT_EQ(rig.refusals.size(), param.unhomed ? 3u : 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(rig.refusals[i].reason, Refusal::kNotReady);

  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.last().fault, FaultCause::kNone);
  EXPECT_EQ(rig.logic.servo_on(), 0x3Fu);
  EXPECT_EQ(rig.last().referenced, param.unhomed ? 0x3Fu & ~(1u << (param.axis - 1u)) : 0x3Fu);
  if (param.unhomed) {
    EXPECT_EQ(rig.refusals[2].reason, Refusal::kNotReferenced);
    return;
  }
  EXPECT_EQ(rig.finished[1].how, MoveFinished::How::kReachedEnd);
  EXPECT_EQ(rig.moves.size(), 2u);
  rig.expect_at({3, -3, 3, -3, 3, -3});
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(rig.logic.emitted(axis), rig.last().commanded[axis].value()) << "axis " << axis + 1;
    EXPECT_EQ(rig.last().correction[axis], Pulses{0}) << "axis " << axis + 1;
  }
}

INSTANTIATE_TEST_SUITE_P(Causes, MotionLoopFaults, testing::ValuesIn(kFaultCases),
                         [](const auto& fault) { return fault.param.name; });

TEST(MotionLoop, WhileTheLogicStandsStillEveryPositionMayBecomeFalse) {
  ControllerRig rig;
  rig.at(500, [&] { rig.logic.stand_still(kTickCycles.value()); });
  rig.submit_at(800, ClearFault{});
  rig.run(1'000);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.last().referenced, 0u);
}

// Another fault stops the arm before the following error is large enough.
TEST(MotionLoop, AnEncoderThatHasLeftItsDriveIsNotTrustedAfterAnyFault) {
  for (const bool stuck : {false, true}) {
    ControllerRig rig;
    rig.move_at(0, kFigure9Deg);
    if (stuck) rig.at(6'000, [&] { rig.logic.drives[2].stuck = true; });
    rig.at(6'300, [&] { rig.logic.pins.drive_alarm = 1; });
    rig.at(6'400, [&] { rig.logic.pins.drive_alarm = 0; });
    rig.submit_at(15'000, ClearFault{});
    rig.run(15'200);
    ASSERT_EQ(rig.faults.size(), 1u);
    EXPECT_EQ(rig.faults[0].cause, FaultCause::kDriveAlarm);
    EXPECT_EQ(rig.last().state, MotionState::kIdle);
    EXPECT_EQ(rig.last().referenced, stuck ? 0b111011u : 0b111111u);
  }
}

// The nominal drive is known: 1 deg beside its lag is found long before 5 deg, and the lag itself is none.
TEST(MotionLoop, TheFollowingErrorAtRestGrowsWithTheLagOfTheDrive) {
  for (const bool stuck : {false, true}) {
    RobotModel robot = test::paper_robot();
    for (AxisModel& axis : robot.axes) axis.following_error_at_rest_rad = 0.2 * test::kDeg;
    ControllerRig rig{robot};
    rig.move_at(0, kFigure9Deg);
    if (stuck) rig.at(6'000, [&] { rig.logic.drives[0].stuck = true; });
    rig.run(20'000);
    ASSERT_EQ(rig.faults.size(), stuck ? 1u : 0u);
    if (!stuck) continue;
    EXPECT_EQ(rig.faults[0].cause, FaultCause::kFollowingError);
    EXPECT_LT(rig.faults[0].tick, Ticks{6'300}) << "5 deg beside the lag would take 700 ticks";
  }
}

TEST(MotionLoop, AnEncoderBeyondTheLimitsOfItsMonitorIsAFault) {
  for (const bool speed : {false, true}) {
    RobotModel robot = test::paper_robot();
    robot.axes[1].encoder_speed_rad_s = speed ? 80 * test::kDeg : 0;
    robot.axes[1].encoder_accel_rad_s2 = speed ? 0 : 300 * test::kDeg;
    ControllerRig rig{robot};
    rig.move_at(0, kFigure9Deg);  // 90 deg/s, 450 deg/s^2
    rig.run(20'000);
    ASSERT_EQ(rig.faults.size(), 1u);
    EXPECT_EQ(rig.faults[0].cause, speed ? FaultCause::kEncoderSpeed : FaultCause::kEncoderAccel);
    EXPECT_EQ(rig.faults[0].axis, 2);
    EXPECT_EQ(rig.last().referenced, 0b111101u);
  }
}

TEST(MotionLoop, InFaultTheDrivesAreOff) {
  ControllerRig rig;
  rig.at(100, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(103, [&] { EXPECT_EQ(rig.logic.servo_on(), 0u); });
  rig.run(200);
  EXPECT_EQ(rig.last().state, MotionState::kFault);
}

TEST(MotionLoop, InFaultADriveThatSomethingElseEnablesIsSwitchedOffInTheNextTick) {
  ControllerRig rig;
  rig.at(100, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(200, [&] { enable(rig.logic, 0b000100); });
  rig.at(203, [&] { EXPECT_EQ(rig.logic.servo_on(), 0u); });
  rig.run(300);
  EXPECT_EQ(rig.last().state, MotionState::kFault);
  EXPECT_EQ(rig.faults.size(), 1u);
}

TEST(MotionLoop, FaultStaysWhileItsCauseIsThere) {
  ControllerRig rig;
  rig.at(100, [&] { rig.logic.pins.estop_n = false; });
  for (const std::int64_t at : {1'000, 2'000, 3'000}) rig.submit_at(at, ClearFault{});
  rig.at(2'500, [&] { rig.logic.pins.estop_n = true; });
  rig.run(4'000);
  EXPECT_EQ(rig.row(2'400).state, MotionState::kFault);
  EXPECT_EQ(rig.row(2'900).state, MotionState::kFault);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.faults.size(), 1u);
  ASSERT_EQ(rig.refusals.size(), 2u);  // the ClearFaults that came too early
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
}

TEST(MotionLoop, FaultIsNotLeftWhileTheArmStillMoves) {
  ControllerRig rig;
  rig.at(100, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(200, [&] { rig.logic.pins.drive_alarm = 0; });
  for (std::int64_t tick = 200; tick < 1'500; ++tick) {
    rig.at(tick, [&] { rig.logic.drives[5].position += 0.3; });  // sags
  }
  rig.submit_at(1'000, ClearFault{});
  rig.submit_at(2'000, ClearFault{});
  rig.run(3'000);
  EXPECT_EQ(rig.row(1'900).state, MotionState::kFault);
  EXPECT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  // The reference is where the arm has sagged to.
  EXPECT_NEAR(static_cast<double>(rig.last().reference_pulses[5].value()), 390.0, 1.0);
}

TEST(MotionLoop, TheArmMayLeaveALimitSwitch) {
  ControllerRig rig;
  rig.move_at(0, {10, 0, 0, 0, 0, 0});
  rig.at(1'000, [&] { rig.logic.pins.limit_pos = 0b000001; });
  rig.submit_at(5'000, ClearFault{});
  rig.move_at(5'100, {-10, 0, 0, 0, 0, 0});
  rig.move_at(5'101, {20, 0, 0, 0, 0, 0});
  rig.run(30'000);
  ASSERT_EQ(rig.faults.size(), 2u);  // towards the switch again
  EXPECT_EQ(rig.moves_finished(), 1);
}

}  // namespace
}  // namespace armature
