// pulse_gen: ticks of the wrong length, stops, and everything at random. No pulse may be lost, invented or misshapen.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "Vpulse_gen.h"
#include "tests/rtl/pulse_gen_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

class PulseGenIrregular : public PulseGenBase<Vpulse_gen> {};

TEST_F(PulseGenIrregular, SurvivesTicksShorterThanSetupAndHold) {
  for (const int tick : {0, 1, 13, 100, 500, 1500, 4095}) {
    for (const int length : {1, 2, 13, 100, 500, 1500, 4095}) {
      SCOPED_TRACE(testing::Message() << "tick_cycles " << tick << " real tick " << length);
      reset();
      monitor_ = {};
      dut_.tick_cycles_i = static_cast<std::uint16_t>(tick);
      dut_.dir_setup_i = 1023;
      dut_.dir_hold_i = 1023;
      int owed = 0;  // commanded minus reported as unfinished
      for (int i = 0; i < 12; ++i) {
        const int count = i % 2 == 0 ? kMaxCount : -kMaxCount;
        run_tick(count, length);
        owed += count - unfinished();
        EXPECT_EQ(emitted(), owed);
      }
      dut_.tick_cycles_i = kTickCycles;
      run_tick(0);
      run_tick(0);
      EXPECT_EQ(monitor_.position, emitted());
      for (const int count : {37, -11}) {
        const int before = emitted();
        run_tick(count);
        EXPECT_EQ(emitted() - before, count);
        run_tick(0);
      }
      expect_legal_timing(1023, 1023);
      if (HasFailure()) return;
    }
  }
}

TEST_F(PulseGenIrregular, LateTriggerAddsNoPulse) {
  for (const int count : {1, -3, 77, -199, 200}) {
    for (const int late : {1, 2, 6, 7, 100, 2500}) {
      const int before = emitted();
      run_tick(count, kTickCycles + late);
      EXPECT_EQ(emitted() - before, count);
      EXPECT_EQ(unfinished(), 0);
      EXPECT_EQ(dut_.step_o, 0);
    }
  }
  expect_legal_timing();
}

TEST_F(PulseGenIrregular, EarlyTriggerReportsTheRestAndSpoilsNothing) {
  for (const int count : {1, 2, 150, 200}) {
    for (int length = 2; length < kTickCycles; length += (length < 40 || length > kTickCycles - 40) ? 1 : 41) {
      SCOPED_TRACE(testing::Message() << "count " << count << " length " << length);
      run_tick(0);
      const int before = emitted();
      run_tick(count, length);
      EXPECT_EQ(emitted() - before + unfinished(), count);
      const int middle = emitted();
      run_tick(count);
      // A pulse cut off costs at most kMinWidth cycles of the next tick; 200 pulses need 2400.
      EXPECT_EQ(emitted() - middle, count);
      EXPECT_EQ(unfinished(), 0);
      if (HasFailure()) return;
    }
  }
  run_tick(0);
  EXPECT_EQ(monitor_.position, emitted());
  expect_legal_timing();
}

TEST_F(PulseGenIrregular, StopAtEveryPhaseAllowsNoFurtherRise) {
  for (const int count : {200, -200, 61, -1}) {
    const int last = std::abs(count) > 100 ? 80 : 2499;
    for (int at = 1; at <= last; at += last > 100 ? 13 : 1) {
      for (const int stop_length : {1, 400}) {
        SCOPED_TRACE(testing::Message() << "count " << count << " stop at " << at << " for " << stop_length);
        run_tick(0);
        const int before = emitted();
        begin_tick(count);
        for (int i = 1; i < at; ++i) step_clock();
        const int sent = emitted() - before;
        dut_.stop_i = 1;
        const bool was_high = dut_.step_o;
        const std::int64_t rises = monitor_.rises;
        for (int i = 0; i < stop_length; ++i) step_clock();
        dut_.stop_i = 0;
        for (int i = at + stop_length; i < kTickCycles; ++i) step_clock();
        EXPECT_EQ(monitor_.rises, rises);
        EXPECT_EQ(emitted() - before, sent);
        EXPECT_EQ(unfinished(), count - sent);
        EXPECT_EQ(dut_.step_o, 0);
        if (was_high) {
          // At once, but never below the minimum width.
          const auto& edges = monitor_.edges;
          const std::int64_t rise = edges.at(edges.size() - 2).time;
          EXPECT_LE(edges.back().time, std::max(rise + kMinWidth, trigger_ + at + 1));
        }
        if (HasFailure()) return;
      }
    }
  }
  expect_legal_timing();
}

TEST_F(PulseGenIrregular, CountThatArrivesDuringStopIsReportedAsUnfinished) {
  dut_.stop_i = 1;
  run_tick(123);
  dut_.stop_i = 0;
  EXPECT_EQ(emitted(), 0);
  EXPECT_EQ(unfinished(), 123);
  run_tick(-5);
  EXPECT_EQ(emitted(), -5);
  EXPECT_EQ(unfinished(), 0);
}

TEST_F(PulseGenIrregular, StopInTheTriggerCycleAloneCancelsTheTick) {
  run_tick(7);
  dut_.stop_i = 1;
  begin_tick(123);
  dut_.stop_i = 0;
  for (int i = 1; i < kTickCycles; ++i) step_clock();
  EXPECT_EQ(emitted(), 7);
  EXPECT_EQ(unfinished(), 123);
  EXPECT_EQ(monitor_.position, 7);
}

TEST_F(PulseGenIrregular, NoDirectionChangeOnATriggerEdge) {
  for (int length = 1; length <= kDirHold + kDirSetup + 10; ++length) {
    SCOPED_TRACE(testing::Message() << "trigger " << length << " cycles after that of the reversal");
    reset();
    monitor_ = {};
    run_tick(5);
    run_tick(-5, length);  // its reversal is due kDirHold cycles after the trigger
    begin_tick(5);
    EXPECT_EQ(dut_.dir_o, length <= kDirHold);
    EXPECT_NE(monitor_.last_dir_change, trigger_);
    for (int i = 1; i < kTickCycles; ++i) step_clock();
    EXPECT_EQ(emitted(), 10);
    EXPECT_EQ(unfinished(), 0);
    expect_legal_timing();
    if (HasFailure()) return;
  }
}

TEST_F(PulseGenIrregular, StopAtEveryPhaseOfAReversalFreezesTheDirection) {
  for (int at = 1; at <= kDirHold + kDirSetup + 10; ++at) {
    SCOPED_TRACE(testing::Message() << "stop at " << at);
    reset();
    monitor_ = {};
    run_tick(5);
    run_tick(-5, at);
    const bool dir = dut_.dir_o;
    EXPECT_EQ(dir, at <= kDirHold);
    dut_.stop_i = 1;
    step_clock();
    dut_.stop_i = 0;
    for (int i = at + 1; i < kTickCycles; ++i) {
      step_clock();
      ASSERT_EQ(dut_.dir_o, dir);
    }
    EXPECT_EQ(emitted(), 5);
    EXPECT_EQ(unfinished(), -5);
  }
}

TEST_F(PulseGenIrregular, TimesSetAfterADirectionChangeAreForTheNextOne) {
  run_tick(5);
  const std::int64_t first = trigger_ + kTickCycles + kDirHold;
  run_tick(-200, kDirHold + 1);
  EXPECT_EQ(monitor_.last_dir_change, first);
  dut_.dir_setup_i = 1000;
  dut_.dir_hold_i = 1000;
  while (monitor_.edges.empty() || !monitor_.edges.back().rising) {
    step_clock();
    ASSERT_LT(cycle_, first + 100);
  }
  EXPECT_GE(cycle_ - first, kDirSetup);
  while (cycle_ < trigger_ + kTickCycles - 1) step_clock();
  run_tick(5);
  EXPECT_GE(monitor_.last_dir_change, trigger_ + 1000);
  run_tick(0);
  expect_legal_timing();
}

TEST_F(PulseGenIrregular, ConservesPulsesOverRandomTicks) {
  constexpr std::uint64_t kSeed = 1;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  SplitMix random(kSeed);
  const auto below = [&random](unsigned bound) { return static_cast<int>(random.below(bound)); };
  for (int run = 0; run < 8; ++run) {
    reset();
    monitor_ = {};
    const int setup = below(2) ? below(1024) : below(40);
    const int hold = below(2) ? below(1024) : below(40);
    dut_.dir_setup_i = static_cast<std::uint16_t>(setup);
    dut_.dir_hold_i = static_cast<std::uint16_t>(hold);
    int balance = 0;
    for (int i = 0; i < 100; ++i) {
      const int count = below(2 * kMaxCount + 1) - kMaxCount;
      const int length = below(4) ? kTickCycles : 1 + below(2 * kTickCycles);
      const int stop_from = below(8) ? length + 1 : below(static_cast<unsigned>(length) + 1);
      begin_tick(count);
      for (int c = 1; c < length; ++c) {
        dut_.stop_i = c >= stop_from;
        step_clock();
      }
      dut_.stop_i = 0;
      balance += count - unfinished();
      ASSERT_EQ(emitted(), balance) << "run " << run << " tick " << i;
      ASSERT_EQ(monitor_.position, emitted()) << "run " << run << " tick " << i;
    }
    expect_legal_timing(setup, hold);
  }
}

}  // namespace
}  // namespace armature::test
