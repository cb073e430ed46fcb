#include <gtest/gtest.h>

#include <cmath>

#include "tests/cosim/support/driven_motor.hpp"

namespace armature::cosim {
namespace {

// A drive on a bench: pulses with generous timing, steps on demand.
class Bench {
 public:
  explicit Bench(const AxisSpec& spec = {}) : motor{spec} {}

  void servo(bool on) { motor.on_pins(now_ += Cycles{1000}, false, dir_, servo_ = on); }

  void pulses(int count) {
    const bool dir = count > 0;
    if (dir != dir_) motor.on_pins(now_ += Cycles{1000}, false, dir_ = dir, servo_);
    now_ += Cycles{1000};
    for (int i = 0; i < std::abs(count); ++i) {
      motor.on_pins(now_ += Cycles{10}, true, dir_, servo_);
      motor.on_pins(now_ += Cycles{10}, false, dir_, servo_);
    }
  }

  void settle() {
    for (int i = 0; i < 200'000 && !drive.idle(); ++i) motor.step();
    EXPECT_TRUE(drive.idle());
  }

  [[nodiscard]] double position() const {
    return static_cast<double>(motor.position().value()) / static_cast<double>(kSubcountsPerCount);
  }

  test::DrivenMotor motor;
  ServoDrive& drive = motor.drive;

 private:
  Cycles now_{};
  bool dir_ = false;
  bool servo_ = false;
};

TEST(ServoDrive, MovesTheMotorByItsPulses) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+300);
  bench.settle();
  EXPECT_EQ(bench.position(), 300.0);
  bench.pulses(-450);
  bench.settle();
  EXPECT_EQ(bench.position(), -150.0);
  EXPECT_EQ(bench.drive.counted_pulses().value(), -150);
  EXPECT_FALSE(bench.drive.violation());
}

TEST(ServoDrive, TurnsPulsesIntoCountsByItsElectronicGear) {
  AxisSpec spec;
  spec.pulses_per_rev = 3000;
  spec.encoder_lines = 2500;
  Bench bench{spec};
  bench.servo(true);
  bench.pulses(+100);
  bench.settle();
  EXPECT_NEAR(bench.position(), 1000.0 / 3.0, 1.0 / static_cast<double>(kSubcountsPerCount));
  bench.pulses(-100);
  bench.settle();
  EXPECT_EQ(bench.position(), 0.0);
}

TEST(ServoDrive, DoesNotSeeDroppedPulses) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+10);
  bench.drive.drop_pulses(5);
  bench.pulses(+3);
  bench.pulses(-4);
  bench.settle();
  EXPECT_EQ(bench.drive.counted_pulses().value(), 10 - 2);
  EXPECT_EQ(bench.drive.dropped_pulses().value(), 3 - 2);
  EXPECT_EQ(bench.position(), 8.0);
}

TEST(ServoDrive, CountsTheNextPulsesTwice) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+10);
  bench.drive.double_pulses(5);
  bench.pulses(+3);
  bench.pulses(-4);
  bench.settle();
  EXPECT_EQ(bench.drive.counted_pulses().value(), 10 + 6 - 4 - 2);
  EXPECT_EQ(bench.drive.dropped_pulses().value(), -(3 - 2)) << "so the sum is that of the pins";
  EXPECT_EQ(bench.position(), 10.0);
}

TEST(ServoDrive, KeepsItsAlarmUntilTheFaultIsOverAndTheServoWasOff) {
  Bench bench;
  bench.servo(true);
  bench.drive.trip();
  EXPECT_TRUE(bench.drive.alarm());
  EXPECT_FALSE(bench.drive.enabled());
  bench.pulses(+3);
  EXPECT_EQ(bench.drive.ignored_pulses().value(), 3);
  bench.servo(false);
  bench.servo(true);
  EXPECT_TRUE(bench.drive.alarm()) << "the fault is not over";
  bench.drive.repair();
  bench.settle();
  EXPECT_TRUE(bench.drive.alarm()) << "the servo was not off";
  bench.servo(false);
  EXPECT_FALSE(bench.drive.alarm());
  bench.drive.trip();
  bench.drive.repair();
  EXPECT_FALSE(bench.drive.alarm());
}

TEST(ServoDrive, IgnoresPulsesWhileTheServoIsOff) {
  Bench bench;
  bench.drive.drop_pulses(1);
  bench.pulses(+7);
  bench.settle();
  EXPECT_EQ(bench.drive.ignored_pulses().value(), 7);
  EXPECT_EQ(bench.drive.counted_pulses().value(), 0);
  EXPECT_EQ(bench.drive.dropped_pulses().value(), 0);
  EXPECT_EQ(bench.position(), 0.0);
}

TEST(ServoDrive, StandsStillAfterServoOffAndHoldsThereAfterServoOn) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+5000);
  for (int i = 0; i < 2000; ++i) bench.motor.step();
  ASSERT_GT(bench.motor.speed(), 1000.0);
  bench.servo(false);
  bench.settle();
  const double stood = bench.position();
  EXPECT_EQ(bench.motor.speed(), 0.0);
  EXPECT_LT(stood, 5000.0);
  EXPECT_FALSE(bench.drive.in_position());
  EXPECT_EQ(bench.motor.following_error(), 0.0);

  // The reference starts at the count under the motor, so it moves by less than one count.
  bench.servo(true);
  bench.settle();
  EXPECT_EQ(bench.position(), std::floor(stood + 0.5));
  EXPECT_TRUE(bench.drive.in_position());
  bench.pulses(-10);
  bench.settle();
  EXPECT_EQ(bench.position(), std::floor(stood + 0.5) - 10.0);
}

TEST(ServoDrive, IsInPositionWithinFiveCounts) {
  Bench bench;
  bench.servo(true);
  bench.motor.step();
  EXPECT_TRUE(bench.drive.in_position());
  bench.pulses(+100);
  bool was_in_position = true;
  int changes = 0;
  for (int i = 0; i < 100'000 && !bench.drive.idle(); ++i) {
    bench.motor.step();
    EXPECT_EQ(bench.drive.in_position(), std::fabs(bench.motor.following_error()) < 5.0);
    changes += bench.drive.in_position() != was_in_position;
    was_in_position = bench.drive.in_position();
  }
  EXPECT_EQ(changes, 2);
}

TEST(ServoDrive, AlarmsAndBrakesOnAnExcessiveErrorUntilTheServoIsSwitchedOff) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+30'050);  // 3 revolutions are 30000 counts
  bench.motor.step();
  EXPECT_TRUE(bench.drive.alarm());
  EXPECT_FALSE(bench.drive.in_position());
  bench.settle();
  EXPECT_TRUE(bench.drive.alarm());
  const double stood = bench.position();
  EXPECT_LT(stood, 100.0);
  bench.pulses(+10);
  bench.settle();
  EXPECT_EQ(bench.position(), stood);
  EXPECT_EQ(bench.drive.ignored_pulses().value(), 10);

  bench.servo(false);
  EXPECT_FALSE(bench.drive.alarm());
  bench.servo(true);
  bench.pulses(+10);
  bench.settle();
  EXPECT_EQ(bench.position(), std::floor(stood + 0.5) + 10.0);
}

TEST(ServoDrive, DoesNotAlarmJustInsideTheLimit) {
  Bench bench;
  bench.servo(true);
  bench.pulses(+29'990);
  bench.motor.step();
  EXPECT_FALSE(bench.drive.alarm());
}

TEST(ServoDrive, ReportsInputViolationsOnlyWithTheServoOn) {
  ServoDrive drive{4, AxisSpec{}};
  Shaft shaft;
  drive.on_pins(Cycles{100}, true, false, false, shaft);
  drive.on_pins(Cycles{101}, false, false, false, shaft);
  EXPECT_FALSE(drive.violation());
  drive.on_pins(Cycles{200}, false, false, true, shaft);
  drive.on_pins(Cycles{300}, true, false, true, shaft);
  drive.on_pins(Cycles{304}, false, false, true, shaft);
  ASSERT_TRUE(drive.violation());
  EXPECT_EQ(drive.violation()->axis, 4u);
  EXPECT_EQ(drive.violation()->required.value(), 5);
}

TEST(ServoDrive, NeedsNoStepsWhenNothingHappens) {
  Bench bench;
  EXPECT_TRUE(bench.drive.idle());
  bench.servo(true);
  bench.settle();
  EXPECT_TRUE(bench.drive.idle());
  bench.pulses(+1);
  EXPECT_FALSE(bench.drive.idle());
}

}  // namespace
}  // namespace armature::cosim
