// The clock of the logic stands still for a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/regs/pulse_width_regs.hpp"
#include "tests/cosim/support/conservation_bench.hpp"

namespace armature::cosim {
namespace {

using ::testing::HasSubstr;

constexpr CountSet kCruise{190, 0, 0, 0, 0, 0};

// Axis 1 has moved `lost` counts, more than the decoder could follow, while the clock stood still. It is at rest now.
struct LostCounts {
  ConservationBench bench;
  std::int64_t lost = 0;

  LostCounts() {
    bench.begin_tick(kNone);
    for (int tick = 0; tick < 30; ++tick) {
      bench.commit(kCruise);
      bench.begin_tick(kCruise);
      bench.read_position(0, bench.position_at_trigger(0));
    }
    const Counts before = bench.plant.motor_counts(0);
    bench.stand_still(1'000'000);
    lost = (bench.plant.motor_counts(0) - before).value();
    for (int tick = 0; tick < 2; ++tick) bench.begin_tick(kNone);
  }

  // The decoder has followed `followed` of the counts.
  void read_position(std::int64_t followed) { bench.read_position(0, bench.position_at_trigger(0) - lost + followed); }
};

TEST(ConservationClock, TheDecoderLosesTheCountsOfAMotorThatMovesMeanwhile) {
  LostCounts run;
  ASSERT_GT(run.lost, 100);
  EXPECT_CONSERVED(run.bench);
  run.read_position(1);
  EXPECT_CONSERVED(run.bench);
}

TEST(ConservationClock, TheDecoderCannotFollowTheMotor) {
  for (const std::int64_t followed : {-6, 6, 100}) {
    LostCounts run;
    run.read_position(followed);
    EXPECT_TRUE(run.bench.check.violation()) << followed;
  }
}

TEST(ConservationClock, TheNumberOfLostCountsIsOneNumber) {
  LostCounts run;
  run.read_position(-1);
  for (int tick = 0; tick < 3; ++tick) {
    run.bench.begin_tick(kNone);
    run.read_position(-1);
  }
  EXPECT_CONSERVED(run.bench);
  run.bench.begin_tick(kNone);
  run.read_position(0);
  ASSERT_TRUE(run.bench.check.violation());
  EXPECT_THAT(*run.bench.check.violation(), HasSubstr("axis 1"));
  EXPECT_THAT(*run.bench.check.violation(), HasSubstr("POSITION reads"));
}

TEST(ConservationClock, CountsOfSeveralStopsAddUp) {
  LostCounts run;
  run.read_position(2);
  const std::int64_t before = run.bench.plant.motor_counts(0).value();
  for (int tick = 0; tick < 30; ++tick) {
    run.bench.commit(kCruise);
    run.bench.begin_tick(kCruise);
    run.read_position(2);
  }
  const std::int64_t seen = run.bench.plant.motor_counts(0).value() - before;
  ASSERT_GT(seen, 100);
  run.bench.stand_still(1'000'000);
  run.lost += run.bench.plant.motor_counts(0).value() - before - seen;
  for (int tick = 0; tick < 2; ++tick) run.bench.begin_tick(kNone);
  run.read_position(2);
  EXPECT_CONSERVED(run.bench);
}

TEST(ConservationClock, AMotorAtRestLosesNothing) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.stand_still(1'000'000);
  bench.begin_tick(kNone);
  bench.read_position(0, 0);
  EXPECT_CONSERVED(bench);
  bench.read_position(0, 1);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationClock, AReadMayCrossATriggerAndAStop) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit({5, 0, 0, 0, 0, 0});
  bench.begin_tick({5, 0, 0, 0, 0, 0});
  bench.begin_tick(kNone, 5);
  bench.stand_still(10'000);
  bench.read_emitted(0, 0);
  EXPECT_CONSERVED(bench);
  bench.wait(12);
  bench.read_emitted(0, 0);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationClock, AReadOfFaultBeforeTheShortageDoesNotBecomeYounger) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit({5, 0, 0, 0, 0, 0});
  bench.begin_tick(kNone);
  bench.begin_tick(kNone, 5);
  bench.stand_still(10'000);
  bench.read_fault(0);  // may have been sampled before the trigger
  EXPECT_CONSERVED(bench);
  bench.wait(20);
  bench.read_fault(0);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationClock, AHalfPeriodMakesNoPulsesMeanwhile) {
  namespace pw = regs::pulse_width;
  ConservationBench bench{{.paper = true}};
  bench.begin_tick(kNone);
  bench.write(regs::soc::kPulseWidthBase + pw::kWidthOffset, 125);
  bench.begin_tick({10, 0, 0, 0, 0, 0});
  bench.stand_still(700);
  bench.begin_tick({10, 0, 0, 0, 0, 0}, 1'500);
  bench.read(regs::soc::kPulseWidthBase + pw::kStatusOffset, 0);
  EXPECT_CONSERVED(bench);
}

}  // namespace
}  // namespace armature::cosim
