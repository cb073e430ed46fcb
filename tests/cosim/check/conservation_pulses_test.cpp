// Committed counts against pins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/time/random.hpp"
#include "tests/cosim/support/conservation_bench.hpp"

namespace armature::cosim {
namespace {

namespace pt = regs::pulse_train;
using ::testing::HasSubstr;

constexpr CountSet kSet{10, -20, 0, 199, -200, 3};

TEST(Conservation, IsSilentOverAHealthyRun) {
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  Random random{kSeed};
  ConservationBench bench;
  CountSet counts{};
  PerAxis<std::int64_t> sum{};
  for (int tick = 0; tick < 120; ++tick) {
    bench.begin_tick(counts);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      bench.read_emitted(axis, bench.emitted_at_trigger[axis]);
      bench.read_position(axis, bench.position_at_trigger(axis));
      sum[axis] += counts[axis];
      counts[axis] = static_cast<std::int32_t>(random.next() % 41) - 20;
    }
    bench.read_fault(0);
    if (tick == 60) bench.plant.drop_pulses(4, 50);
    if (tick % 7 == 3) {
      counts = kNone;  // nothing committed: an underrun
    } else {
      bench.commit(counts);
    }
  }
  bench.begin_tick(counts);
  bench.begin_tick(kNone);
  EXPECT_CONSERVED(bench);
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(bench.check.pin_pulses(axis), sum[axis] + counts[axis]);
  EXPECT_NE(bench.plant.dropped_pulses(4).value(), 0);
}

TEST(Conservation, ExpectsPositionsFrom0WhereverTheEncodersStandAtTheStart) {
  ConservationBench bench{{}, std::nullopt, {10.0, -10.0}};  // 13889 counts of 7.2e-4 degrees
  for (int tick = 0; tick < 3; ++tick) {
    bench.begin_tick(tick == 0 ? kNone : kSet);
    if (tick > 0) bench.read_position(0, bench.position_at_trigger(0) - 13889);
    if (tick > 0) bench.read_position(1, bench.position_at_trigger(1) + 13889);
    bench.commit(kSet);
  }
  EXPECT_CONSERVED(bench);
  bench.read_position(0, bench.position_at_trigger(0));
  EXPECT_THAT(bench.check.violation().value_or(""), HasSubstr("axis 1"));
}

TEST(Conservation, CatchesAnExcessPulse) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(with(kSet, 2, 1));
  EXPECT_CONSERVED(bench);
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 2, axis 3, cycle 8500: 0 pulses committed, 1 emitted");
}

TEST(Conservation, DoesNotExcuseAnExcessByAStop) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(with(kSet, 1, -21));
  bench.read_fault(pt::kFaultEstopMask);
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 2, axis 2, cycle 8500: -20 pulses committed, -21 emitted");
}

TEST(Conservation, CatchesAPulseInTheWrongDirection) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(with(kSet, 0, -10));
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 2, axis 1, cycle 8500: 10 pulses committed, -10 emitted");
}

TEST(Conservation, CatchesPulsesThatNobodyCommitted) {
  ConservationBench bench;
  bench.begin_tick(with(kNone, 5, 1));
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 1, axis 6, cycle 6000: 0 pulses committed, 1 emitted");
}

TEST(Conservation, CatchesASetThatIsEmittedTwice) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kSet);
  bench.begin_tick(kSet);
  EXPECT_CONSERVED(bench);
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 3, axis 1, cycle 11000: 0 pulses committed, 10 emitted");
}

TEST(Conservation, LimitsACountAsTheLogicDoes) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(with(with(kSet, 3, 250), 4, -32768));
  bench.begin_tick(with(with(kSet, 3, 200), 4, -200));
  bench.begin_tick(kNone);
  bench.read_fault(pt::kFaultClippedMask);
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, ExpectsTheLastOfTwoCommits) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit({1, 1, 1, 1, 1, 1});
  bench.commit(kSet);
  bench.begin_tick(kSet);
  bench.begin_tick(kNone);
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, CatchesAMissingPulse) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(with(kSet, 3, 198));
  bench.begin_tick(kNone);
  EXPECT_CONSERVED(bench);  // the software has not asked for the reason yet
  bench.read_fault(pt::kFaultUnderrunMask | pt::kFaultClippedMask | pt::kFaultRecommitMask);
  EXPECT_VIOLATION(bench,
                   "conservation: tick 2, axis 4, cycle 8500: 199 pulses committed, 198 emitted, and FAULT shows no "
                   "RESIDUAL, ESTOP or WATCHDOG");
}

TEST(Conservation, AcceptsMissingPulsesThatTheLogicExplains) {
  for (const std::uint32_t flag : {pt::kFaultResidualMask, pt::kFaultEstopMask, pt::kFaultWatchdogMask}) {
    ConservationBench bench;
    bench.begin_tick(kNone);
    bench.commit(kSet);
    bench.begin_tick(with(kSet, 3, 150));
    bench.begin_tick(kNone);
    bench.read_fault(flag);
    bench.begin_tick(kNone);
    bench.read_fault(0);
    EXPECT_CONSERVED(bench) << "flag " << flag;
  }
}

TEST(Conservation, AcceptsMissingPulsesThatWereExplainedWithinTheTick) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.read_fault(pt::kFaultEstopMask);
  bench.begin_tick(kNone);
  bench.read_fault(0);
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, AcceptsALatchedStopInStatus) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.read(ConservationBench::pulse_train(pt::kStatusOffset), pt::kStatusWatchdogMask);
  bench.read_fault(0);
  EXPECT_CONSERVED(bench);
}

TEST(Conservation, DoesNotLetAnExplanationLast) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.read_fault(pt::kFaultResidualMask);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.read_fault(0);
  EXPECT_TRUE(bench.check.violation());
}

TEST(Conservation, WaitsForAReadThatIsSurelyLaterThanTheShortage) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone, 10);
  bench.read_fault(0);  // may have been sampled before the trigger
  EXPECT_CONSERVED(bench);
  bench.wait(20);
  bench.read_fault(0);
  EXPECT_TRUE(bench.check.violation());
}

TEST(Conservation, ReportsAnUnexplainedShortageAtTheEndOfTheRun) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.check.finish();
  EXPECT_CONSERVED(bench);  // no time to ask
  bench.begin_tick(kNone);
  bench.check.finish();
  ASSERT_TRUE(bench.check.violation());
  EXPECT_THAT(*bench.check.violation(), HasSubstr("tick 2, axis 1, cycle 8500: 10 pulses committed, 0 emitted"));
}

TEST(Conservation, TakesALowServoEnableForAStopAtTheEndOfTheRun) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.set_servo(0);
  bench.check.finish();
  EXPECT_CONSERVED(bench);
}

// ---- a commit that finishes just after a trigger

TEST(Conservation, TakesACommitAtTheTriggerForTheTickInWhichItIsEmitted) {
  ConservationBench early;
  early.begin_tick(kNone);
  early.begin_tick(kSet, 5);
  early.commit(kSet);
  early.begin_tick(kNone);
  early.begin_tick(kNone);
  EXPECT_CONSERVED(early);

  ConservationBench late;
  late.begin_tick(kNone);
  late.begin_tick(kNone, 5);
  late.commit(kSet);
  late.begin_tick(kSet);
  late.begin_tick(kNone);
  EXPECT_CONSERVED(late);
}

TEST(Conservation, CatchesACommitAtTheTriggerThatIsEmittedTwice) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.begin_tick(kSet, 5);
  bench.commit(kSet);
  bench.begin_tick(kSet);
  bench.begin_tick(kNone);
  EXPECT_VIOLATION(bench, "conservation: tick 3, axis 1, cycle 11000: 0 pulses committed, 10 emitted");
}

TEST(Conservation, CatchesACommitAtTheTriggerThatIsNeverEmitted) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.begin_tick(kNone, 5);
  bench.commit(kSet);
  bench.begin_tick(kNone);
  bench.begin_tick(kNone);
  bench.read_fault(0);
  EXPECT_VIOLATION(bench,
                   "conservation: tick 3, axis 1, cycle 11000: 10 pulses committed, 0 emitted, and FAULT shows no "
                   "RESIDUAL, ESTOP or WATCHDOG");
}

TEST(Conservation, KeepsBothOrdersOpenWhenTheTickTellsNothing) {
  for (const CountSet& second : {kSet, kNone}) {
    ConservationBench bench;
    bench.begin_tick(kNone);
    bench.commit(kSet);
    bench.begin_tick(kSet, 5);
    bench.commit(kSet);  // the same counts again: active now, or waiting
    bench.begin_tick(second);
    bench.begin_tick(kNone);
    bench.read_fault(0);
    EXPECT_CONSERVED(bench);
    bench.begin_tick(second);
    bench.begin_tick(kNone);
    EXPECT_EQ(bench.check.violation().has_value(), second != kNone);
  }
}

TEST(Conservation, TakesACommitWellAfterATriggerForTheNextTick) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.begin_tick(kSet, 17);  // latency 6 and the response path of 10 are over
  bench.commit(kSet);
  bench.begin_tick(kNone);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationEdges, AreTheFirstPulseAndTheLatestTurnOfATick) {
  ConservationBench bench;
  const auto edges = [&](std::size_t axis) { return bench.check.edges_of_tick(axis); };
  bench.begin_tick({0, 0, 5, -3, 0, 0});
  const Cycles first = bench.trigger();
  bench.begin_tick({0, 0, 5, 2, 0, 0});
  const Cycles second = bench.trigger();
  EXPECT_EQ(edges(2).first_rise, first + Cycles{90});
  EXPECT_EQ(edges(2).turned, first + Cycles{60});
  EXPECT_EQ(edges(3).first_rise, first + Cycles{90});
  EXPECT_EQ(edges(3).turned, Cycles{});  // the pin was low before
  EXPECT_EQ(edges(0).first_rise, Cycles{});
  bench.begin_tick({});
  EXPECT_EQ(edges(2).first_rise, second + Cycles{90});
  EXPECT_EQ(edges(2).turned, Cycles{});
  EXPECT_EQ(edges(3).turned, second + Cycles{60});
  bench.begin_tick({});
  EXPECT_EQ(edges(2).first_rise, Cycles{});
  EXPECT_EQ(edges(3).turned, Cycles{});
}

}  // namespace
}  // namespace armature::cosim
