// Cascade: both timers as one of 64 bits.
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

class AxiTimerCascade : public CoreFixture<Vtimer_core> {
 protected:
  std::uint64_t count() { return std::uint64_t{tcr(1)} << 32 | tcr(0); }

  // Each TCSR loads its own half, timer 0 with CASC as `mode` has it.
  void load64(std::uint64_t value, std::uint32_t mode) {
    load(0, static_cast<std::uint32_t>(value), mode);
    load(1, static_cast<std::uint32_t>(value >> 32));
  }
};

// One 64-bit count: the carry into the upper half is on the edge of the lower half's roll-over.
TEST_F(AxiTimerCascade, CountsSixtyFourBitsAcrossTheCarry) {
  for (const bool down : {false, true}) {
    const std::uint64_t from = down ? 0x1234'0000'0000'0003u : 0x1233'FFFF'FFFF'FFFCu;
    const std::uint32_t mode = kCascade | kReload | kGenerate | (down ? kDown : 0u);
    load64(from, mode);
    write_tcsr(0, mode | kRun);
    for (std::uint64_t i = 1; i <= 10; ++i) {
      tick();
      EXPECT_EQ(count(), down ? from - i : from + i);
      EXPECT_FALSE(pulse(0) || pulse(1) || flag(0) || flag(1)) << "a roll-over of the lower half alone is no event";
    }
    write_tcsr(0, 0);
  }
}

// The first event TLR + 1 clocks after ENT, then one every TLR + 4: the wrapped value shows for three clocks.
TEST_F(AxiTimerCascade, PeriodIsTheLoadValuePlusFour) {
  for (const bool down : {false, true}) {
    for (const std::int64_t span : {0, 1, 2, 5, 100}) {
      const std::uint64_t from = down ? static_cast<std::uint64_t>(span) : ~static_cast<std::uint64_t>(span);
      const std::uint32_t mode = kCascade | kReload | kGenerate | (down ? kDown : 0u);
      load64(from, mode);
      write_tcsr(0, mode | kRun);
      std::vector<std::int64_t> expected;
      for (int i = 0; i < 4; ++i) expected.push_back(span + 1 + i * (span + 4));
      EXPECT_EQ(pulses(0, expected.back() + 2), expected) << span;
      EXPECT_EQ(count(), down ? ~std::uint64_t{0} : 0u) << "the third clock of the wrapped value";
      tick();
      EXPECT_EQ(count(), from) << "both halves are reloaded";
      write_tcsr(0, 0);
    }
  }
}

TEST_F(AxiTimerCascade, OnlyTimer0HasAnEvent) {
  load64(3, kCascade | kDown);
  write_tcsr(1, kIrq | kGenerate | kRun | kDown);
  write_tcsr(0, kCascade | kDown | kReload | kRun | kGenerate);
  EXPECT_TRUE(pulses(1, 50).empty());
  EXPECT_TRUE(flag(0));
  EXPECT_FALSE(flag(1));
  EXPECT_FALSE(dut_.irq_o);
  write_tcsr(0, kCascade | kDown | kReload | kRun | kIrq);
  tick();
  EXPECT_TRUE(dut_.irq_o);
}

TEST_F(AxiTimerCascade, AFlagThatTimer1HasFromBeforeRaisesNoInterrupt) {
  load(1, 3, kDown);
  write_tcsr(1, kDown | kIrq | kRun);
  tick(10);
  EXPECT_TRUE(flag(1));
  EXPECT_TRUE(dut_.irq_o);
  load64(20, kCascade | kDown);
  write_tcsr(1, kIrq);
  tick();
  EXPECT_FALSE(dut_.irq_o);
  write_tcsr(0, kCascade | kDown | kReload | kRun | kIrq);
  EXPECT_EQ(when(30, [&] { return dut_.irq_o != 0; }).front(), 22) << "one clock after the flag of timer 0";
  EXPECT_TRUE(flag(1)) << "kept";
  write_tcsr(0, kCascade | kFlag);
  tick();
  EXPECT_FALSE(dut_.irq_o);
  write_tcsr(0, 0);
  tick();
  EXPECT_TRUE(dut_.irq_o) << "two timers again";
}

TEST_F(AxiTimerCascade, ModeAndEnableOfTcsr1AreIgnored) {
  constexpr std::uint32_t mode = kCascade | kDown | kReload | kGenerate | kRun;
  for (const std::uint32_t other : {0u, kRun, kRun | kCapture | kCapturePin, kRun | kReload, kDown, kPwm | kGenerate}) {
    load64(5, kCascade | kDown);
    write_tcsr(1, other);
    const std::uint32_t tlr1 = tlr(1);
    write_tcsr(0, mode);
    dut_.capture_trig_i = 2;
    EXPECT_EQ(pulses(0, 16), (std::vector<std::int64_t>{6, 15})) << std::hex << other;
    EXPECT_EQ(tlr(1), tlr1);
    EXPECT_EQ(tcsr(1), other);
    EXPECT_FALSE(dut_.pwm_o);
    dut_.capture_trig_i = 0;
    write_tcsr(1, 0);
    write_tcsr(0, kFlag);
  }
}

TEST_F(AxiTimerCascade, OneShotHoldsBothHalvesUntilLoad) {
  load64(4, kCascade | kDown);
  write_tcsr(0, kCascade | kDown | kGenerate | kRun);
  EXPECT_EQ(pulses(0, 60), std::vector<std::int64_t>{5});
  EXPECT_EQ(count(), ~std::uint64_t{0});
  EXPECT_TRUE(tcsr(0) & kRun);
  load64(4, kCascade | kDown);
  write_tcsr(0, kCascade | kDown | kGenerate | kRun);
  EXPECT_EQ(pulses(0, 60), std::vector<std::int64_t>{5});
}

TEST_F(AxiTimerCascade, LoadOfEachTcsrLoadsItsOwnHalf) {
  for (const std::uint32_t casc : {0u, kCascade}) {
    load(0, 0x1111, casc);
    load(1, 0x2222);
    EXPECT_EQ(count(), 0x2222'0000'1111u);
    write_tlr(0, 0x3333);
    write_tlr(1, 0x4444);
    write_tcsr(0, casc | kLoad);
    tick(2);
    EXPECT_EQ(count(), 0x2222'0000'3333u);
    write_tcsr(0, casc);
    write_tcsr(1, kLoad);
    tick(2);
    EXPECT_EQ(count(), 0x4444'0000'3333u);
    write_tcsr(1, 0);
  }
}

TEST_F(AxiTimerCascade, LoadOfTheUpperHalfLeavesTheLowerOneRunning) {
  load64(100, kCascade);
  write_tcsr(0, kCascade | kRun);
  write_tlr(1, 9);
  write_tcsr(1, kLoad);
  tick(10);
  EXPECT_EQ(count(), std::uint64_t{9} << 32 | 112u);
}

TEST_F(AxiTimerCascade, CaptureStoresBothHalvesByThePinOfTimer0) {
  load64(0x7'FFFF'FFF0u, kCascade);
  write_tcsr(0, kCascade | kRun | kCapture | kCapturePin | kReload);
  dut_.capture_trig_i = 2;
  tick(10);
  EXPECT_FALSE(flag(0) || flag(1));
  for (int i = 0; i < 4; ++i) {
    dut_.capture_trig_i = 1;
    tick(kEdgeClocks);
    const std::uint64_t expected = count();
    tick();
    EXPECT_EQ(tlr(0), static_cast<std::uint32_t>(expected));
    EXPECT_EQ(tlr(1), expected >> 32);
    EXPECT_TRUE(flag(0));
    EXPECT_FALSE(flag(1));
    dut_.capture_trig_i = 0;
    tick(4);
  }
  EXPECT_EQ(tlr(1), 8u) << "the carry was seen";
}

TEST_F(AxiTimerCascade, CaptureModeRunsOnThroughTheSixtyFourBitRollOver) {
  load64(2, kCascade | kDown);
  write_tcsr(0, kCascade | kDown | kRun | kCapture | kReload | kGenerate);
  EXPECT_TRUE(pulses(0, 10).empty());
  EXPECT_FALSE(flag(0));
  EXPECT_EQ(count(), ~std::uint64_t{0} - 7);
}

TEST_F(AxiTimerCascade, ThirtyTwoBitTimersAreThemselvesAgainAfterwards) {
  load64(4, kCascade | kDown);
  write_tcsr(0, kCascade | kDown | kGenerate | kReload | kRun);
  tick(30);
  load(0, 3, kDown);
  load(1, 5, kDown);
  write_tcsr(1, kDown | kGenerate | kReload);
  write_tcsr(0, kDown | kGenerate | kReload | kRunAll);
  std::vector<std::int64_t> found[2];
  for (std::int64_t i = 1; i <= 14; ++i) {
    tick();
    for (unsigned t = 0; t < 2; ++t) {
      if (pulse(t)) found[t].push_back(i);
    }
  }
  EXPECT_EQ(found[0], (std::vector<std::int64_t>{4, 9, 14}));
  EXPECT_EQ(found[1], (std::vector<std::int64_t>{6, 13}));
}

}  // namespace
}  // namespace armature::test::axi_timer
