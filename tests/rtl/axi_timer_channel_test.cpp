// One timer in generate mode, clock by clock: every value of TCR, the clock of every wrap, flag and GenerateOut pulse.
#include <gtest/gtest.h>

#include <vector>

#include "Vtimer_channel.h"
#include "tests/rtl/axi_timer_bits.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test::axi_timer {
namespace {

class TimerChannelTest : public VerilatedTest<Vtimer_channel> {
 protected:
  void SetUp() override {
    dut_.tcsr_we_i = dut_.tlr_we_i = dut_.other_we_i = 0;
    dut_.freeze_i = dut_.capture_edge_i = 0;
    dut_.lower_i = 0;
    dut_.upper_count_i = 0;
    dut_.upper_i = dut_.carry_i = dut_.upper_down_i = dut_.capture_too_i = 0;
    dut_.follow_i = dut_.restart_i = 0;
    reset();
  }

  // The value is in force after the call, that is for the next clock on.
  void write_tcsr(std::uint32_t value, unsigned strobe = 0xF) { write(dut_.tcsr_we_i, value, strobe); }
  void write_tlr(std::uint32_t value, unsigned strobe = 0xF) { write(dut_.tlr_we_i, value, strobe); }

  void load(std::uint32_t value) {
    write_tlr(value);
    write_tcsr(kLoad);
    tick();
    EXPECT_EQ(dut_.tcr_o, value);
  }

  bool flag() const { return dut_.tcsr_o & kFlag; }

  // Clocks at which GenerateOut is high, counted from 1 = the first clock of the run.
  std::vector<std::int64_t> pulses(std::int64_t clocks) {
    std::vector<std::int64_t> found;
    for (std::int64_t i = 1; i <= clocks; ++i) {
      tick();
      if (dut_.generate_o) found.push_back(i);
    }
    return found;
  }

 private:
  void write(CData& strobe_port, std::uint32_t value, unsigned strobe) {
    strobe_port = 1;
    dut_.wdata_i = value;
    dut_.wstrb_i = static_cast<CData>(strobe);
    tick();
    strobe_port = 0;
    dut_.wdata_i = ~value;
  }
};

TEST_F(TimerChannelTest, ResetClearsEverything) {
  EXPECT_EQ(dut_.tcsr_o, 0u);
  EXPECT_EQ(dut_.tlr_o, 0u);
  EXPECT_EQ(dut_.tcr_o, 0u);
  tick(100);
  EXPECT_EQ(dut_.tcr_o, 0u) << "counts without ENT";
}

TEST_F(TimerChannelTest, CountsDownThroughZeroAndShowsTheWrappedValueForOneClock) {
  load(3);
  write_tcsr(kRun | kDown | kReload);
  const std::vector<std::uint32_t> expected{2, 1, 0, kMax, 3, 2, 1, 0, kMax, 3, 2};
  for (const std::uint32_t count : expected) {
    tick();
    EXPECT_EQ(dut_.tcr_o, count) << "clock " << cycle_;
  }
}

TEST_F(TimerChannelTest, CountsUpThroughMaxAndShowsTheWrappedValueForOneClock) {
  load(kMax - 2);
  write_tcsr(kRun | kReload);
  const std::vector<std::uint32_t> expected{kMax - 1, kMax, 0, kMax - 2, kMax - 1, kMax, 0, kMax - 2};
  for (const std::uint32_t count : expected) {
    tick();
    EXPECT_EQ(dut_.tcr_o, count) << "clock " << cycle_;
  }
}

// Down: the first event TLR+1 clocks after ENT, then one every TLR+2. Up: the same with MAX-TLR.
TEST_F(TimerChannelTest, PeriodIsExactInBothDirections) {
  for (const bool down : {true, false}) {
    for (const std::uint32_t span : {0u, 1u, 2u, 3u, 10u, 97u, 2498u}) {
      load(down ? span : kMax - span);
      write_tcsr(kRun | kReload | kGenerate | (down ? kDown : 0u));
      const std::int64_t first = span + 1, period = span + 2;
      std::vector<std::int64_t> expected;
      for (int i = 0; i < 5; ++i) expected.push_back(first + i * period);
      EXPECT_EQ(pulses(first + 5 * period - 1), expected) << (down ? "down " : "up ") << span;
    }
  }
}

TEST_F(TimerChannelTest, TickOf2500ClocksNeedsTlr2498) {
  load(2498);
  write_tcsr(kRun | kReload | kGenerate | kDown);
  const auto found = pulses(100 * 2500);
  ASSERT_EQ(found.size(), 100u);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], 2499 + 2500 * static_cast<std::int64_t>(i));
}

// The wrap to 0 and the reload of 0 look the same: 0 stays for two clocks.
TEST_F(TimerChannelTest, UpCountFromZeroStaysOnZeroForTwoClocks) {
  load(kMax);
  write_tcsr(kRun | kReload);
  write_tlr(0);
  EXPECT_EQ(dut_.tcr_o, 0u) << "wrapped";
  tick();
  EXPECT_EQ(dut_.tcr_o, 0u) << "reloaded";
  tick();
  EXPECT_EQ(dut_.tcr_o, 1u);
}

TEST_F(TimerChannelTest, FlagAndGenerateOutComeWithTheWrappedValue) {
  load(2);
  write_tcsr(kRun | kReload | kGenerate | kDown);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(flag());
    EXPECT_FALSE(dut_.generate_o);
    tick();
  }
  EXPECT_EQ(dut_.tcr_o, kMax);
  EXPECT_TRUE(flag());
  EXPECT_TRUE(dut_.generate_o);
  tick();
  EXPECT_FALSE(dut_.generate_o) << "wider than one clock";
  EXPECT_TRUE(flag()) << "the flag stays until it is cleared";
}

TEST_F(TimerChannelTest, OneShotHoldsTheWrappedValueUntilLoad) {
  for (const bool down : {true, false}) {
    const std::uint32_t mode = kRun | kGenerate | (down ? kDown : 0u);
    load(down ? 4 : kMax - 4);
    write_tcsr(mode);
    EXPECT_EQ(pulses(50), std::vector<std::int64_t>{5});
    EXPECT_EQ(dut_.tcr_o, down ? kMax : 0u);
    EXPECT_TRUE(dut_.tcsr_o & kRun) << "ENT keeps reading 1";
    write_tcsr(mode | kFlag);
    EXPECT_TRUE(pulses(50).empty());
    EXPECT_FALSE(flag()) << "sitting on the terminal value sets no flag";
    write_tcsr(mode | kLoad);
    write_tcsr(mode);
    EXPECT_EQ(dut_.tcr_o, down ? 4 : kMax - 4);
    EXPECT_EQ(pulses(50), std::vector<std::int64_t>{5});
    write_tcsr(kFlag);
  }
}

TEST_F(TimerChannelTest, AutoReloadEnabledLateRestartsAHeldOneShot) {
  load(4);
  write_tcsr(kRun | kDown | kGenerate);
  tick(20);
  write_tcsr(kRun | kDown | kGenerate | kReload);
  EXPECT_EQ(pulses(7), std::vector<std::int64_t>{6}) << "one clock to reload, then TLR+1";
}

// The held value is the terminal count of the other direction; turning round there is no second event.
TEST_F(TimerChannelTest, TurningAHeldOneShotRoundIsNoEvent) {
  for (const bool down : {true, false}) {
    const std::uint32_t mode = kRun | kGenerate;
    load(down ? 4 : kMax - 4);
    write_tcsr(mode | (down ? kDown : 0u));
    tick(20);
    write_tcsr(mode | kFlag | (down ? 0u : kDown));
    EXPECT_TRUE(pulses(20).empty());
    EXPECT_FALSE(flag());
    EXPECT_EQ(dut_.tcr_o, down ? kMax : 0u);
  }
}

TEST_F(TimerChannelTest, LoadIsALevelThatStopsCountingAndIsNotSelfClearing) {
  write_tlr(100);
  write_tcsr(kLoad | kRun | kDown | kReload | kGenerate);
  tick();
  for (const std::uint32_t value : {100u, 7u, 0u, 0u, 12u}) {
    write_tlr(value);
    tick();
    EXPECT_EQ(dut_.tcr_o, value);
    EXPECT_TRUE(pulses(20).empty()) << "a wrap while LOAD is 1";
    EXPECT_EQ(dut_.tcr_o, value);
  }
  EXPECT_EQ(dut_.tcsr_o, kLoad | kRun | kDown | kReload | kGenerate);
}

TEST_F(TimerChannelTest, ClearingEntFreezesAndSettingItContinues) {
  for (const int run : {1, 5, 10, 11, 12, 13}) {  // 11 clocks after the start TCR shows the wrapped value
    load(10);
    write_tcsr(kFlag);
    const std::uint32_t mode = kDown | kReload | kGenerate;
    write_tcsr(mode | kRun);
    int seen = static_cast<int>(pulses(run - 1).size());
    write_tcsr(mode);  // still counts in the clock of the write
    seen += dut_.generate_o;
    const std::uint32_t frozen = dut_.tcr_o, status = dut_.tcsr_o;
    EXPECT_EQ(seen, run >= 11);
    EXPECT_EQ(pulses(30), std::vector<std::int64_t>{}) << "after " << run;
    EXPECT_EQ(dut_.tcr_o, frozen);
    EXPECT_EQ(dut_.tcsr_o, status) << "mode bits and flag keep";
    write_tcsr(mode | kRun);
    const std::int64_t first = run < 11 ? 11 - run : 11 + 12 - run;
    EXPECT_EQ(pulses(first + 3), std::vector<std::int64_t>{first}) << "after " << run;
  }
}

TEST_F(TimerChannelTest, TlrWrittenWhileRunningIsUsedAtTheNextReload) {
  load(20);
  write_tcsr(kRun | kDown | kReload | kGenerate);
  EXPECT_TRUE(pulses(9).empty());
  write_tlr(5);  // clock 10
  EXPECT_EQ(dut_.tcr_o, 10u) << "TCR is not disturbed";
  EXPECT_EQ(pulses(30), (std::vector<std::int64_t>{11, 18, 25}));
}

// The reload takes the value that TLR has in the clock before it.
TEST_F(TimerChannelTest, TlrWrittenInTheWrapClockIsUsedAtOnce) {
  load(3);
  write_tcsr(kRun | kDown | kReload | kGenerate);
  tick(3);
  write_tlr(50);  // the edge of this write shows the wrapped value
  EXPECT_EQ(dut_.tcr_o, kMax);
  tick();
  EXPECT_EQ(dut_.tcr_o, 50u);
}

TEST_F(TimerChannelTest, WritingOneClearsTheFlagAndZeroKeepsIt) {
  load(0);
  write_tcsr(kRun | kDown);
  tick();
  ASSERT_TRUE(flag());
  write_tcsr(0);
  EXPECT_TRUE(flag()) << "written 0";
  write_tcsr(kFlag, 0x1);
  EXPECT_TRUE(flag()) << "byte 1 was not strobed";
  write_tcsr(kFlag, 0x0);
  EXPECT_TRUE(flag()) << "no byte was strobed";
  write_tcsr(kFlag);
  EXPECT_FALSE(flag());
}

// A tick lost here would be lost for ever.
TEST_F(TimerChannelTest, AWrapWinsOverAClearInTheSameClock) {
  const std::uint32_t mode = kRun | kDown | kReload;
  for (int clear_at = 1; clear_at <= 12; ++clear_at) {
    load(3);
    write_tcsr(kFlag);
    write_tcsr(mode);  // wraps at clocks 4, 9, 14
    tick(clear_at - 1);
    write_tcsr(mode | kFlag);
    EXPECT_EQ(flag(), clear_at == 4 || clear_at == 9) << "clear at clock " << clear_at;
  }
}

TEST_F(TimerChannelTest, FlagIsSetWhetherOrNotTheInterruptIsEnabled) {
  load(1);
  write_tcsr(kRun | kDown);
  tick(5);
  EXPECT_TRUE(flag());
  EXPECT_FALSE(dut_.interrupt_o);
  write_tcsr(kIrq);
  EXPECT_TRUE(dut_.interrupt_o) << "ENIT lets a flag out that is already set";
  write_tcsr(kIrq | kFlag);
  EXPECT_FALSE(dut_.interrupt_o);
}

TEST_F(TimerChannelTest, GenerateOutNeedsGent) {
  load(3);
  write_tcsr(kRun | kDown | kReload);
  EXPECT_TRUE(pulses(50).empty());
  EXPECT_TRUE(flag());
}

TEST_F(TimerChannelTest, ByteStrobesSelectBytesOfTlr) {
  for (unsigned strobe = 0; strobe < 16; ++strobe) {
    write_tlr(0x1122'3344u);
    write_tlr(0xAABB'CCDDu, strobe);
    std::uint32_t expected = 0x1122'3344u;
    for (unsigned byte = 0; byte < 4; ++byte) {
      const std::uint32_t mask = 0xFFu << (8 * byte);
      if (strobe >> byte & 1u) expected = (expected & ~mask) | (0xAABB'CCDDu & mask);
    }
    EXPECT_EQ(dut_.tlr_o, expected) << "strobe " << strobe;
  }
}

TEST_F(TimerChannelTest, ByteStrobesSelectTheModeBits) {
  write_tcsr(~(kRun | kRunAll), 0xE);
  EXPECT_EQ(dut_.tcsr_o, kPwm) << "modes live in byte 0";
  write_tcsr(~(kRun | kRunAll), 0x1);
  EXPECT_EQ(dut_.tcsr_o, kPwm | 0x7Fu) << "bits without a function read 0";
  write_tcsr(0, 0xD);
  EXPECT_EQ(dut_.tcsr_o, kPwm);
}

// An independent description: the count is a position on a ring of the values of one period.
TEST_F(TimerChannelTest, RandomPeriodsAndPausesNeverDrift) {
  SplitMix random{5};
  for (int round = 0; round < 30; ++round) {
    const bool down = random.below(2) != 0;
    const std::uint32_t span = random.below(40);
    const std::uint32_t mode = kReload | kGenerate | (down ? kDown : 0u);
    load(down ? span : kMax - span);
    write_tcsr(mode | kRun);
    std::int64_t counted = 0;  // clocks with ENT
    for (int burst = 0; burst < 8; ++burst) {
      const std::int64_t clocks = random.below(100);
      for (std::int64_t i = 0; i < clocks; ++i) {
        tick();
        ++counted;
        EXPECT_EQ(dut_.generate_o, (counted + 1) % (span + 2) == 0) << "round " << round << ", clock " << counted;
      }
      write_tcsr(mode);
      ++counted;
      tick(random.below(5));
      write_tcsr(mode | kRun);
    }
  }
}

}  // namespace
}  // namespace armature::test::axi_timer
