// PWM: timer 0 sets the period, timer 1 the high time.
#include "tests/rtl/axi_timer_core_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

constexpr std::uint32_t kPwmMode = kPwm | kGenerate | kReload;

class AxiTimerPwm : public CoreFixture<Vtimer_core> {
 protected:
  // Loads both timers and starts them on one edge.
  void start_pwm(std::uint32_t period_span, std::uint32_t high_span, std::uint32_t mode = kPwmMode | kDown) {
    write_tcsr(0, 0);
    write_tcsr(1, kFlag);
    tick(3);
    EXPECT_FALSE(dut_.pwm_o);
    load(0, before_end(mode & kDown, period_span), mode);
    load(1, before_end(mode & kDown, high_span), mode);
    write_tcsr(0, mode | kFlag | kRunAll);
  }
  std::vector<std::int64_t> high(std::int64_t clocks) {
    return when(clocks, [&] { return dut_.pwm_o != 0; });
  }
};

// Down: period TLR0 + 2, high TLR1 + 2; up: the same with MAX - TLR. The pulse begins with the period, and the first
// one begins when the first period ends. A high time of a whole period or more is constant 0.
TEST_F(AxiTimerPwm, PeriodAndHighTimeAreExact) {
  for (const bool down : {true, false}) {
    for (std::int64_t period_span = 0; period_span <= 12; ++period_span) {
      for (std::int64_t high_span = 0; high_span <= 14; ++high_span) {
        start_pwm(static_cast<std::uint32_t>(period_span), static_cast<std::uint32_t>(high_span),
                  kPwmMode | (down ? kDown : 0u));
        std::vector<std::int64_t> expected;
        for (std::int64_t period = 0; period < 3 && high_span < period_span; ++period) {
          const std::int64_t begin = period_span + 1 + period * (period_span + 2);
          for (std::int64_t i = 0; i < high_span + 2; ++i) expected.push_back(begin + i);
        }
        EXPECT_EQ(high(period_span + 3 * (period_span + 2)), expected)
            << (down ? "down " : "up ") << period_span << ' ' << high_span;
      }
    }
  }
}

TEST_F(AxiTimerPwm, BothTimersEndOncePerPeriodWithFlagAndPulse) {
  for (const std::uint32_t high_span : {0u, 4u, 10u}) {  // 10: ends together with timer 0
    start_pwm(10, high_span);
    std::vector<std::int64_t> found[2];
    for (std::int64_t i = 1; i <= 48; ++i) {
      tick();
      for (unsigned t = 0; t < 2; ++t) {
        if (pulse(t)) found[t].push_back(i);
      }
    }
    EXPECT_EQ(found[0], (std::vector<std::int64_t>{11, 23, 35, 47}));
    const std::int64_t first = high_span + 1;
    EXPECT_EQ(found[1], (std::vector<std::int64_t>{first, first + 12, first + 24, first + 36}));
    EXPECT_TRUE(flag(0) && flag(1));
  }
}

TEST_F(AxiTimerPwm, Timer1HoldsItsWrappedValueAndReloadsWithTimer0) {
  start_pwm(8, 2);
  tick(9);
  for (int period = 0; period < 3; ++period) {
    EXPECT_EQ(tcr(0), kMax);
    EXPECT_EQ(tcr(1), kMax);
    tick();
    EXPECT_EQ(tcr(0), 8u);
    EXPECT_EQ(tcr(1), 2u);
    tick(9);
  }
}

TEST_F(AxiTimerPwm, OnlyTimer0RunningIsConstantOne) {
  load(0, 5, kPwmMode | kDown);
  load(1, 2, kPwmMode | kDown);
  write_tcsr(0, kPwmMode | kDown | kRun);
  tick(5);
  EXPECT_FALSE(dut_.pwm_o);
  EXPECT_EQ(high(40).size(), 40u);
  EXPECT_EQ(tcr(1), 2u) << "ENT1 = 0 freezes timer 1";
}

TEST_F(AxiTimerPwm, OnlyTimer1RunningIsConstantZero) {
  load(0, 5, kPwmMode | kDown);
  load(1, 2, kPwmMode | kDown);
  write_tcsr(1, kPwmMode | kDown | kRun);
  EXPECT_TRUE(high(40).empty());
}

// Timer 0 stops in each clock of a period of 12. Timer 1 ends at most 6 clocks later and goes on with its own period.
TEST_F(AxiTimerPwm, StoppingTimer0LeavesThePinLowFromTheNextEndOfTimer1On) {
  for (int phase = 0; phase < 12; ++phase) {
    start_pwm(10, 4);
    tick(11 + phase);
    write_tcsr(0, kPwmMode | kDown);
    const std::vector<std::int64_t> ends = when(40, [&] { return pulse(1); });
    ASSERT_GE(ends.size(), 6u) << phase;
    EXPECT_LE(ends[0], 6) << phase;
    EXPECT_EQ(ends[1] - ends[0], 6) << phase;
    EXPECT_TRUE(high(40).empty()) << phase;
    write_tcsr(0, kPwmMode | kDown | kRun);
    tick(24);
    EXPECT_EQ(high(120).size(), 60u) << phase << ", timer 0 runs again";
  }
}

// TLR1 grows to TLR0 or beyond it, or TLR0 shrinks to TLR1 or below it, in each clock of a period of 22.
TEST_F(AxiTimerPwm, AHighTimeBeyondThePeriodWrittenWhileItRunsIsConstantZero) {
  constexpr struct {
    unsigned timer;
    std::uint32_t old, value;
  } kChanges[] = {{1, 8, 20}, {1, 8, 21}, {1, 8, 22}, {1, 8, 150}, {0, 20, 8}, {0, 20, 7}, {0, 20, 6}, {0, 20, 0}};
  for (const auto& [timer, old, value] : kChanges) {
    for (int phase = 0; phase < 22; ++phase) {
      start_pwm(20, 8);
      tick(21 + phase);
      write_tlr(timer, value);
      tick(66);
      EXPECT_TRUE(high(200).empty()) << "TLR" << timer << " = " << value << ", phase " << phase;
      write_tlr(timer, old);
      tick(66);
      EXPECT_EQ(high(220).size(), 100u) << "TLR" << timer << " = " << value << ", phase " << phase << ", pulses again";
    }
  }
}

// Both timers stop in each clock of a period of 12 and start again with the mode still set.
TEST_F(AxiTimerPwm, AHighTimeBeyondThePeriodIsConstantZeroAfterOnePeriodOfANewStart) {
  for (const std::uint32_t high_span : {10u, 11u, 12u, 150u}) {
    for (int phase = 0; phase < 12; ++phase) {
      start_pwm(10, 4);
      tick(11 + phase);
      write_tcsr(0, kPwmMode | kDown);
      write_tcsr(1, kPwmMode | kDown);
      load(0, 10, kPwmMode | kDown);
      load(1, high_span, kPwmMode | kDown);
      write_tcsr(0, kPwmMode | kDown | kRunAll);
      tick(11 + 12);
      EXPECT_TRUE(high(200).empty()) << high_span << ", phase " << phase;
    }
  }
}

TEST_F(AxiTimerPwm, APulseThatTimer1DoesNotEndStopsWithItsPeriod) {
  start_pwm(6, 2);
  tick(6);
  write_tlr(1, 7);  // the edge of this write begins the pulse, so the reload of its period takes it
  EXPECT_TRUE(dut_.pwm_o);
  EXPECT_EQ(high(60), (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7}));
}

// Timer 1 starts in each clock of a period. When that period ends, timer 1 has ended, has not, or ends with it.
TEST_F(AxiTimerPwm, LeavingConstantOneSkipsNoPulse) {
  for (std::uint32_t high_span = 0; high_span < 10; ++high_span) {
    for (int phase = 0; phase < 12; ++phase) {
      write_tcsr(0, 0);
      write_tcsr(1, kFlag);
      tick(3);
      load(0, 10, kPwmMode | kDown);
      load(1, high_span, kPwmMode | kDown);
      write_tcsr(0, kPwmMode | kDown | kRun);
      tick(23 + phase);
      EXPECT_TRUE(dut_.pwm_o);
      write_tcsr(1, kPwmMode | kDown | kRun);
      for (int end = 1; end <= 4;) {
        tick();
        if (!pulse(0)) continue;
        EXPECT_TRUE(dut_.pwm_o) << "high " << high_span << ", phase " << phase << ", end " << end;
        ++end;
      }
    }
  }
}

TEST_F(AxiTimerPwm, AnEndOfTimer1WinsOverAnEndOfTimer0) {
  start_pwm(6, 3);
  tick(7);
  EXPECT_TRUE(dut_.pwm_o);
  write_tlr(1, 6);  // from the next reload on both end together
  EXPECT_EQ(high(80), (std::vector<std::int64_t>{1, 2, 3, 7, 8, 9, 10, 11, 12, 13, 14}));
}

// Written across a reload, one cycle has the period of the new values and the high time of the old ones.
TEST_F(AxiTimerPwm, ChangeAcrossAReloadGivesOneOddCycle) {
  start_pwm(20, 5);
  tick(20);
  write_tlr(0, 40);  // the edge of this write shows the wrapped value, so the reload takes it
  write_tlr(1, 30);  // the edge of this one is the reload
  std::vector<std::int64_t> expected{1, 2, 3, 4, 5};
  for (std::int64_t i = 41; i < 41 + 32; ++i) expected.push_back(i);
  expected.push_back(41 + 42);
  EXPECT_EQ(high(41 + 42), expected);
}

TEST_F(AxiTimerPwm, NeedsBothPwmBitsBothPulsesAndGenerateMode) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    for (const std::uint32_t wrong : {kPwm, kGenerate, kCapture}) {
      start_pwm(6, 2);
      EXPECT_FALSE(high(30).empty());
      start_pwm(6, 2);
      tick(8);
      EXPECT_TRUE(dut_.pwm_o);
      write_tcsr(timer, (kPwmMode | kDown | kRun) ^ wrong);
      tick(2);
      EXPECT_TRUE(high(40).empty()) << timer << ' ' << std::hex << wrong;
    }
  }
  start_pwm(6, 2);
  write_tcsr(0, kPwmMode | kDown | kRun | kCascade);
  EXPECT_TRUE(high(40).empty()) << "no PWM in a cascade";
}

TEST_F(AxiTimerPwm, ClearingPwmaMakesThePinLow) {
  start_pwm(6, 2);
  tick(8);
  EXPECT_TRUE(dut_.pwm_o);
  write_tcsr(0, 0);
  tick();
  EXPECT_TRUE(dut_.pwm_o);
  tick();
  EXPECT_FALSE(dut_.pwm_o);
}

TEST_F(AxiTimerPwm, WithoutPwmTimer1ReloadsByItself) {
  load(0, 10, kGenerate | kDown | kReload);
  load(1, 2, kGenerate | kDown | kReload);
  write_tcsr(0, kGenerate | kDown | kReload | kRunAll);
  EXPECT_EQ(pulses(1, 16), (std::vector<std::int64_t>{3, 7, 11, 15}));
}

// ARHT of timer 1 has no meaning here: timer 0 reloads it.
TEST_F(AxiTimerPwm, DoesNotNeedArhtOfTimer1) {
  load(0, 6, kPwmMode | kDown);
  load(1, 2, kPwm | kGenerate | kDown);
  write_tcsr(0, kPwmMode | kDown | kRunAll);
  EXPECT_EQ(high(20), (std::vector<std::int64_t>{7, 8, 9, 10, 15, 16, 17, 18}));
}

TEST_F(AxiTimerPwm, FreezeHoldsThePin) {
  start_pwm(6, 2);
  tick(7);
  dut_.freeze_i = 1;
  EXPECT_EQ(high(50).size(), 50u);
  dut_.freeze_i = 0;
  EXPECT_EQ(high(10), (std::vector<std::int64_t>{1, 2, 3, 8, 9, 10})) << "goes on where it stood";
}

TEST_F(AxiTimerPwm, StoppingTimer1DuringThePulseMakesItConstantOneUntilItRunsOn) {
  start_pwm(10, 4);
  tick(12);
  write_tcsr(1, kPwmMode | kDown);
  EXPECT_EQ(high(50).size(), 50u);
  write_tcsr(1, kPwmMode | kDown | kRun);
  EXPECT_EQ(high(24), (std::vector<std::int64_t>{1, 2, 3, 7, 8, 9, 10, 11, 12, 19, 20, 21, 22, 23, 24}));
}

}  // namespace
}  // namespace armature::test::axi_timer
