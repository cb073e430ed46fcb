// A core that misses its triggers: no pulse may be lost, repeated or hurried, and the watchdog must win in the end.
#include <gtest/gtest.h>

#include <cstdlib>

#include "controller/base/timebase.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

constexpr std::int64_t kNormal = 250;

// One tick's computation takes `ticks` more than its budget.
void be_late_at(ControllerRig& rig, std::int64_t trigger, double ticks) {
  rig.at(trigger, [&rig, ticks] { rig.logic.tick_cycles = static_cast<std::int64_t>(ticks * 2'500.0); });
  rig.at(trigger + 1, [&rig] { rig.logic.tick_cycles = kNormal; });
}

class OneLateTick : public testing::TestWithParam<double> {};

TEST_P(OneLateTick, LosesNoPulseAndDoesNotHurry) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  be_late_at(rig, 8'700, GetParam());
  rig.run(25'000);
  EXPECT_GT(rig.logic.underruns(), 0u);
  EXPECT_EQ(rig.last().underruns, rig.logic.underruns());
  EXPECT_EQ(rig.logic.faults_read() & regs::pulse_train::kFaultRecommitMask, 0u);
  EXPECT_TRUE(rig.faults.empty());
  EXPECT_LE(rig.logic.largest_count(), 9);  // never two ticks' pulses in one
  rig.expect_pulses_conserved();
  rig.expect_at(kFigure9Deg);
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rig.last().correction[axis], Pulses{0});
}

INSTANTIATE_TEST_SUITE_P(Lateness, OneLateTick, testing::Values(0.85, 0.9, 0.95, 1.0, 1.1, 1.5, 1.9, 2.3, 2.9));

TEST(Lateness, OneLateTickIsOneUnderrun) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  be_late_at(rig, 8'700, 1.2);
  rig.run(25'000);
  EXPECT_EQ(rig.last().underruns, 1u);
}

TEST(Lateness, RandomLatenessLosesNoPulse) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random{seed};
    ControllerRig rig;
    rig.move_at(0, {20, -15, 10, 5, -5, 12});
    for (std::int64_t tick = 10; tick < 8'000; tick += random.integer(2, 200)) {
      be_late_at(rig, tick, random.real(0.7, 2.6));
    }
    rig.run(16'000);
    EXPECT_GT(rig.logic.underruns(), 5u);
    EXPECT_EQ(rig.last().underruns, rig.logic.underruns());
    EXPECT_EQ(rig.logic.faults_read() & regs::pulse_train::kFaultRecommitMask, 0u);
    EXPECT_TRUE(rig.faults.empty());
    EXPECT_EQ(rig.moves_finished(), 1);
    EXPECT_LE(rig.logic.largest_count(), 9);
    rig.expect_pulses_conserved();
    rig.expect_at({20, -15, 10, 5, -5, 12});
    for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rig.last().correction[axis], Pulses{0});
  }
}

TEST(Lateness, ASteadilySlowCoreSlowsTheArmDownAndTheFeedbackKnows) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.at(3'000, [&] { rig.logic.tick_cycles = 6'000; });  // every set is emitted two or three ticks late
  rig.at(20'000, [&] { rig.logic.tick_cycles = kNormal; });
  rig.run(40'000);
  EXPECT_GT(rig.last().underruns, 5'000u);
  EXPECT_TRUE(rig.faults.empty());
  for (const Telemetry& row : rig.rows) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) ASSERT_EQ(row.correction[axis], Pulses{0}) << row.tick.value();
  }
  rig.expect_pulses_conserved();
  rig.expect_at(kFigure9Deg);
}

TEST(Lateness, ACoreThatStaysTooSlowTripsTheWatchdogAndTheArmStaysStopped) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.at(8'700, [&] { rig.logic.tick_cycles = 6 * 2'500; });
  rig.run(20'000);
  EXPECT_NE(rig.logic.peek(test::ModelLogic::kPulses + regs::pulse_train::kStatusOffset) &
                regs::pulse_train::kStatusWatchdogMask,
            0u);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kWatchdog);
  EXPECT_GE(rig.last().underruns, 4u);
  EXPECT_EQ(rig.logic.servo_on(), 0u);
  EXPECT_EQ(rig.last().state, MotionState::kFault);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(rig.logic.emitted(axis), rig.last().commanded[axis].value());
    EXPECT_LT(std::llabs(rig.logic.emitted(axis)), std::llabs(rig.last().reference_pulses[axis].value()) + 10);
  }
}

TEST(Lateness, AfterTheWatchdogTheArmMovesAgainOnceCleared) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.at(8'700, [&] { rig.logic.tick_cycles = 6 * 2'500; });
  rig.at(9'000, [&] { rig.logic.tick_cycles = kNormal; });
  rig.submit_at(12'000, ClearFault{});
  rig.move_at(12'010, {});
  rig.run(40'000);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  rig.expect_at({});
}

}  // namespace
}  // namespace armature
