// Snapshot registers against pins and encoders.
#include <gtest/gtest.h>

#include <string>

#include "tests/cosim/support/conservation_bench.hpp"

namespace armature::cosim {
namespace {

namespace en = regs::encoder;

// Runs at a constant number of pulses per tick until `wanted`. While the drives settle, every trigger meets the encoder
// in another phase.
template <class Wanted>
void cruise(ConservationBench& bench, const CountSet& counts, Wanted wanted) {
  bench.begin_tick(kNone);
  for (int tick = 0; tick < 1000; ++tick) {
    bench.commit(counts);
    bench.begin_tick(counts);
    ASSERT_FALSE(bench.check.violation()) << *bench.check.violation();
    if (tick > 20 && wanted()) return;
  }
  FAIL() << "the situation did not come up";
}

TEST(ConservationEmitted, MustBeThePinCountAtTheTrigger) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit({5, -7, 0, 0, 0, 0});
  bench.begin_tick({5, -7, 0, 0, 0, 0});
  bench.begin_tick(kNone);
  bench.read_emitted(0, 5);
  bench.read_emitted(1, -7);
  EXPECT_FALSE(bench.check.violation());
  bench.read_emitted(1, -6);
  ASSERT_TRUE(bench.check.violation());
  EXPECT_EQ(*bench.check.violation(),
            "conservation: tick 2, axis 2, cycle 9000: EMITTED reads -6, -7 pulses were on the pins at the trigger");
}

TEST(ConservationEmitted, MustNotShowPulsesAfterTheTrigger) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  bench.commit({5, 0, 0, 0, 0, 0});
  bench.begin_tick({5, 0, 0, 0, 0, 0});
  bench.read_emitted(0, 0);
  EXPECT_FALSE(bench.check.violation());
  bench.read_emitted(0, 5);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationEmitted, MayBeOfEitherTriggerWhenTheReadCrossesOne) {
  for (const std::int64_t value : {0, 5, 3}) {
    ConservationBench bench;
    bench.begin_tick(kNone);
    bench.commit({5, 0, 0, 0, 0, 0});
    bench.begin_tick({5, 0, 0, 0, 0, 0});
    bench.begin_tick(kNone, 16);
    bench.read_emitted(0, value);
    EXPECT_EQ(bench.check.violation().has_value(), value == 3) << value;
    bench.wait(1);
    bench.read_emitted(0, 5);
    EXPECT_EQ(bench.check.violation().has_value(), value == 3);
    bench.read_emitted(0, 0);
    EXPECT_TRUE(bench.check.violation());
  }
}

TEST(ConservationEmitted, MayBeOfEitherTriggerLongerWhenTheBusStalls) {
  BusSpec stalling;
  stalling.stall_probability = 0.5;
  stalling.timeout_cycles = 1000;
  ConservationBench bench;
  Conservation check{bench.plant, stalling};
  SocOutputs pins;
  pins.servo_on = 0x3F;
  check.on_outputs(Cycles{1}, pins);
  check.on_trigger(Cycles{1000});
  const std::uint32_t emitted = ConservationBench::pulse_train(regs::pulse_train::kEmittedOffset);
  check.on_trigger(Cycles{3500});
  check.on_read(Cycles{4500}, emitted, 0);
  EXPECT_FALSE(check.violation());
}

TEST(ConservationPosition, MayBeAnyCountThatTheEncoderShowedWithinTheFilterLatency) {
  // 8 cycles: synchroniser 2, debounce 5, position 1.
  for (const std::int32_t rate : {19, -19}) {
    ConservationBench bench;
    cruise(bench, {rate, 0, 0, 0, 0, 0},
           [&bench] { return bench.count_before_trigger(0, 8) != bench.count_before_trigger(0, 0); });
    if (HasFatalFailure()) return;
    for (std::size_t age = 0; age <= 8; ++age) bench.read_position(0, bench.count_before_trigger(0, age));
    EXPECT_FALSE(bench.check.violation()) << *bench.check.violation();
  }
}

TEST(ConservationPosition, MustNotBeOlderThanTheFilterLatency) {
  ConservationBench bench;
  cruise(bench, {19, 0, 0, 0, 0, 0},
         [&bench] { return bench.count_before_trigger(0, 9) != bench.count_before_trigger(0, 8); });
  if (HasFatalFailure()) return;
  bench.read_position(0, bench.count_before_trigger(0, 8));
  EXPECT_FALSE(bench.check.violation());
  bench.read_position(0, bench.count_before_trigger(0, 9));
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationPosition, MustNotBeYoungerThanTheTrigger) {
  ConservationBench bench;
  cruise(bench, {0, 0, 0, 0, 0, 19}, [] { return true; });
  if (HasFatalFailure()) return;
  const std::int64_t newest = bench.count_before_trigger(5, 0);
  const std::int64_t oldest = bench.count_before_trigger(5, 8);
  bench.read_position(5, newest);
  EXPECT_FALSE(bench.check.violation());
  bench.read_position(5, newest + 1);
  ASSERT_TRUE(bench.check.violation());
  const std::string expected = "axis 6, cycle " + std::to_string(bench.now().value()) + ": POSITION reads " +
                               std::to_string(newest + 1) + ", the encoder showed " + std::to_string(oldest) + " .. " +
                               std::to_string(newest) + " counts before the trigger";
  EXPECT_NE(bench.check.violation()->find(expected), std::string::npos) << *bench.check.violation();
}

// A timer with a wrong period: the read has come before one of the last triggers.
TEST(ConservationPosition, MayBeOfAnyTriggerDuringTheRead) {
  constexpr std::int64_t kSpacing = 6;
  constexpr auto kLatency = static_cast<std::int64_t>(ConservationBench::kEncoderLatency);
  ConservationBench bench;
  cruise(bench, {19, 0, 0, 0, 0, 0}, [&bench] { return bench.plant.motor_counts(0) > Counts{2'000}; });
  if (HasFatalFailure()) return;
  bench.begin_tick(kNone, 1);  // the drive still follows what it got
  int of_the_first_alone = 0;
  std::int64_t first = 0;
  for (int i = 0; i < 60; ++i) {
    first = bench.plant.motor_counts(0).value();
    bench.wait(kSpacing);
    of_the_first_alone += bench.plant.motor_counts(0).value() != first ? 1 : 0;
    bench.wait(kLatency - kSpacing);
    bench.check.on_trigger(bench.now());
    for (int j = 0; j < 2; ++j) {
      bench.wait(kSpacing);
      bench.check.on_trigger(bench.now());
    }
    bench.wait(1);
    bench.read_position(0, first);
    EXPECT_CONSERVED(bench) << i;
  }
  EXPECT_GT(of_the_first_alone, 0);
  bench.read_position(0, first - 200);
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationPosition, IsCheckedAtStandstillToTheCount) {
  for (const std::int64_t value : {-1, 1}) {
    ConservationBench bench;
    bench.begin_tick(kNone);
    bench.read_position(3, 0);
    EXPECT_FALSE(bench.check.violation());
    bench.read_position(3, value);
    EXPECT_TRUE(bench.check.violation());
  }
}

TEST(ConservationPosition, KnowsTheDebounceTimeThatTheSoftwareSets) {
  ConservationBench bench;
  bench.write(ConservationBench::encoder(en::kDebounceOffset), 20);
  cruise(bench, {19, 0, 0, 0, 0, 0},
         [&bench] { return bench.count_before_trigger(0, 24) != bench.count_before_trigger(0, 23); });
  if (HasFatalFailure()) return;
  bench.read_position(0, bench.count_before_trigger(0, 23));
  EXPECT_FALSE(bench.check.violation());
  bench.read_position(0, bench.count_before_trigger(0, 24));
  EXPECT_TRUE(bench.check.violation());
}

TEST(ConservationPosition, TakesADebounceTimeOfZeroForOne) {
  ConservationBench bench;
  bench.write(ConservationBench::encoder(en::kDebounceOffset), 0);
  cruise(bench, {19, 0, 0, 0, 0, 0},
         [&bench] { return bench.count_before_trigger(0, 5) != bench.count_before_trigger(0, 4); });
  if (HasFatalFailure()) return;
  bench.read_position(0, bench.count_before_trigger(0, 4));
  EXPECT_FALSE(bench.check.violation());
  bench.read_position(0, bench.count_before_trigger(0, 5));
  EXPECT_TRUE(bench.check.violation());
}

// The synchroniser may see a level one cycle later, and no more. What the encoder shows after the trigger, or showed
// before that, is still wrong.
TEST(ConservationPosition, MayBeOneCycleOlderWithInputJitter) {
  for (const bool input_jitter : {false, true}) {
    ConservationBench bench{{.input_jitter = input_jitter}};
    cruise(bench, {19, 0, 0, 0, 0, 0},
           [&bench] { return bench.count_before_trigger(0, 9) != bench.count_before_trigger(0, 8); });
    if (HasFatalFailure()) return;
    bench.read_position(0, bench.count_before_trigger(0, 9));
    EXPECT_EQ(bench.check.violation().has_value(), !input_jitter);
  }
}

TEST(ConservationPosition, MustNotBeWrongWithInputJitter) {
  for (const bool older : {false, true}) {
    ConservationBench bench{{.input_jitter = true}};
    cruise(bench, {19, 0, 0, 0, 0, 0},
           [&bench] { return bench.count_before_trigger(0, 10) != bench.count_before_trigger(0, 9); });
    if (HasFatalFailure()) return;
    bench.read_position(0, bench.count_before_trigger(0, 0));
    bench.read_position(0, bench.count_before_trigger(0, 9));
    EXPECT_CONSERVED(bench);
    bench.read_position(0, older ? bench.count_before_trigger(0, 10) : bench.count_before_trigger(0, 0) + 1);
    EXPECT_TRUE(bench.check.violation()) << older;
  }
}

TEST(ConservationBus, IgnoresRegistersThatItDoesNotWatch) {
  ConservationBench bench;
  bench.begin_tick(kNone);
  for (const std::uint32_t base : {0x4120'0000u, 0x4280'0000u, 0x43C1'0000u, 0x43C2'0000u}) {
    for (const std::uint32_t offset : {0x00u, 0x08u, 0x5Cu, 0x7Cu, 0x9Cu, 0xFFFCu}) {
      const bool watched = base == 0x43C1'0000u && offset == 0x08u;
      if (!watched) bench.read(base + offset, 0x1234'5670);
    }
  }
  EXPECT_FALSE(bench.check.violation()) << *bench.check.violation();
}

}  // namespace
}  // namespace armature::cosim
