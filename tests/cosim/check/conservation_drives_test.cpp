// Pins against drives: every pulse on a pin is counted, lost by the fault script, or ignored for a reason.
#include <gtest/gtest.h>

#include "tests/cosim/support/conservation_bench.hpp"

namespace armature::cosim {
namespace {

TEST(Conservation, CatchesADriveThatMissesAPulse) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(with(kNone, 1, 2));
  bench.plant_sees_steps = false;
  bench.begin_tick(with(kNone, 1, 2), 100);
  bench.plant_sees_steps = true;
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(
      bench,
      "conservation: tick 2, axis 2, cycle 8500: 2 pulses on the pins, the drive counted 1, lost 0 and ignored 0");
}

TEST(Conservation, AcceptsPulsesIgnoredWithTheServoOff) {
  ConservationBench bench;
  bench.set_servo(0b111101);
  bench.begin_tick(kNone);
  bench.commit(with(kNone, 1, 2));
  bench.begin_tick(with(kNone, 1, 2), 300);
  bench.set_servo(0x3F);
  bench.begin_tick(kNone);
  EXPECT_EQ(bench.plant.ignored_pulses(1).value(), 2);
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, AcceptsPulsesIgnoredWhileTheRelayIsOpen) {
  ConservationBench bench{{}, Cycles{2 * ConservationBench::kTick + 1000}};
  bench.begin_tick(kNone);
  bench.commit(with(kNone, 4, 200));
  bench.begin_tick(with(kNone, 4, 200));  // the relay opens within this tick
  bench.commit(with(kNone, 4, 2));
  bench.begin_tick(with(kNone, 4, 2));
  bench.begin_tick(kNone);
  EXPECT_GT(bench.plant.drive_pulses(4), Pulses{0});
  EXPECT_GT(bench.plant.ignored_pulses(4), Pulses{2});
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, CatchesADriveThatIgnoresPulsesWithItsServoOn) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.servo_wires = 0b101111;
  bench.commit(with(kNone, 4, 2));
  bench.begin_tick(with(kNone, 4, 2));
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 3, axis 5, cycle 11000: the drive ignored 2 pulses with its servo on");
}

}  // namespace
}  // namespace armature::cosim
