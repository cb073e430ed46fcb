// axi_timer over the bus: the register traffic of the drivers that the block must be compatible with.
#include "tests/rtl/axi_timer_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

class AxiTimerDrivers : public AxiTimerFixture {
 protected:
  // Zephyr's PWM driver: constant levels run one timer and load none, everything between loads both.
  void zephyr_pwm(std::uint32_t period, std::uint32_t high) {
    constexpr std::uint32_t kMode = kPwm | kGenerate | kReload | kDown;
    std::uint32_t mode0 = kMode, mode1 = kMode;
    if (high == 0) {
      mode1 |= kRun;
    } else if (high == period) {
      mode0 |= kRun;
    } else {
      write(0, kTcsr, kMode);
      write(1, kTcsr, kMode);
      write(0, kTlr, period - 2);
      write(0, kTcsr, kMode | kLoad);
      write(1, kTlr, high - 2);
      write(1, kTcsr, kMode | kLoad);
      mode1 |= kRunAll;
    }
    write(0, kTcsr, mode0);
    write(1, kTcsr, mode1);
  }

  int high_clocks(int clocks) {
    int high = 0;
    for (int i = 0; i < clocks; ++i) {
      axi_.step();
      high += dut_.pwm_o;
    }
    return high;
  }
};
INSTANTIATE_AXI_STALLS(AxiTimerDrivers);

TEST_P(AxiTimerDrivers, VendorSelfTestSeesBothTimersCountUp) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    initialize(timer);
    self_test(timer);
  }
}

TEST_P(AxiTimerDrivers, VendorPolledExample) {
  initialize(0);
  write(0, kTcsr, kReload);
  EXPECT_EQ(read(0, kTcr), 0u);
  EXPECT_EQ(read(0, kTcr), 0u);
  start(0);
  EXPECT_EQ(read(0, kTcsr), kReload | kRun);
  expect_counting(0);
  stop(0);
  const std::uint32_t stopped = read(0, kTcr);
  EXPECT_EQ(read(0, kTcr), stopped);
}

TEST_P(AxiTimerDrivers, VendorLowLevelExample) {
  write(0, kTcsr, 0);
  write(0, kTlr, 0xDEAD'BEEFu);
  write(0, kTcsr, read(0, kTcsr) | kLoad);
  write(0, kTcsr, read(0, kTcsr) & ~kLoad);
  EXPECT_EQ(read(0, kTcr), 0xDEAD'BEEFu);
  write(0, kTcsr, read(0, kTcsr) | kRun);
  expect_counting(0);
  stop(0);
}

// TLR = 0xFFFF0000 counting up: an interrupt every 65537 clocks; the third handler stops the timer.
TEST_P(AxiTimerDrivers, VendorInterruptExample) {
  initialize(0);
  write(0, kTcsr, kIrq | kReload);
  write(0, kTlr, 0xFFFF'0000u);
  start(0);
  for (int interrupt = 1; interrupt <= 3; ++interrupt) {
    wait_for_irq(70'000);
    EXPECT_EQ(read(0, kTcsr), 0x1D0u);
    if (interrupt == 3) {
      write(0, kTcsr, 0);
      EXPECT_EQ(read(0, kTcsr), kFlag) << "the flag survives the clearing of every mode bit";
      write(0, kTcsr, kFlag | kLoad);
      write(0, kTcsr, kFlag);
      EXPECT_EQ(read(0, kTcsr), 0u);
    } else {
      write(0, kTcsr, read(0, kTcsr));
    }
    EXPECT_FALSE(dut_.irq_o) << "acknowledged before the response";
    EXPECT_EQ(read(1, kTcsr), 0u);
  }
  ASSERT_EQ(irq_rises_.size(), 3u);
  EXPECT_EQ(irq_rises_[1] - irq_rises_[0], 65'537);
  EXPECT_EQ(irq_rises_[2] - irq_rises_[1], 65'537);
}

// Both halves loaded one after the other, timer 1 without CASC; Start() writes TCSR0 once with CASC = 0.
TEST_P(AxiTimerDrivers, VendorInterrupt64BitExample) {
  initialize(0);
  initialize(1);
  self_test(0);
  self_test(1);
  write(0, kTlr, 0xFFFF'0000u);
  write(1, kTlr, 0xFFFF'FFFFu);
  write(0, kTcsr, 0x850);
  reset_timer(0);
  reset_timer(1);
  EXPECT_EQ(read(0, kTcr), 0xFFFF'0000u);
  EXPECT_EQ(read(1, kTcr), 0xFFFF'FFFFu);
  start(0);
  EXPECT_EQ(read(0, kTcsr), 0x8D0u);
  for (int interrupt = 1; interrupt <= 3; ++interrupt) {
    wait_for_irq(70'000);
    EXPECT_EQ(read(0, kTcsr), 0x9D0u);
    EXPECT_EQ(read(1, kTcsr), 0u) << "the flag is that of timer 0";
    write(0, kTcsr, read(0, kTcsr));
    EXPECT_EQ(read(0, kTcsr), 0x8D0u);
  }
  ASSERT_EQ(irq_rises_.size(), 3u);
  EXPECT_EQ(irq_rises_[1] - irq_rises_[0], 65'535 + 4);
  EXPECT_EQ(irq_rises_[2] - irq_rises_[1], 65'535 + 4);
  stop(0);
  EXPECT_EQ(read(0, kTcsr), 0x850u);
}

// Software reads 64 bits by TCR1, TCR0, TCR1 until both reads of TCR1 agree: it never sees the count jump.
TEST_P(AxiTimerDrivers, SixtyFourBitReadsAreCoherentAcrossTheCarry) {
  for (std::uint32_t before = 0; before < 40; ++before) {
    write(0, kTcsr, kCascade);
    write(0, kTlr, kMax - before);
    write(1, kTlr, 6);
    reset_timer(0);
    reset_timer(1);
    write(0, kTcsr, kCascade | kRun);
    std::uint64_t previous = (std::uint64_t{6} << 32) + (kMax - before);
    for (int i = 0; i < 6; ++i) {
      std::uint32_t high = 0, low = 0, again = read(1, kTcr);
      do {
        high = again;
        low = read(0, kTcr);
        again = read(1, kTcr);
      } while (high != again);
      const std::uint64_t count = std::uint64_t{high} << 32 | low;
      EXPECT_GT(count, previous);
      EXPECT_LT(count, previous + 500);
      previous = count;
    }
    EXPECT_EQ(previous >> 32, 7u);
    write(0, kTcsr, 0);
  }
}

// Four duty cycles of one period; each wants ten pairs of interrupts. Stop() writes ENALL back and so does not stop,
// and from the second pass on the timers are loaded while they run: the pulses are right all the same once both have
// run one period. In the last pass the high time is the period: constant 0.
TEST_P(AxiTimerDrivers, VendorPwmExample) {
  constexpr std::uint32_t kPeriod = 2500;
  self_test(0);
  write(0, kTcsr, 0x040);
  write(1, kTcsr, 0x040);
  for (std::uint32_t divisor = 4; divisor >= 1; --divisor) {
    const std::uint32_t high = kPeriod / divisor;
    stop(0);
    stop(1);
    for (unsigned timer = 0; timer < 2; ++timer) write(timer, kTcsr, (read(timer, kTcsr) | 0x012u) & ~0x804u);
    write(0, kTlr, kPeriod - 2);
    write(1, kTlr, high - 2);
    for (unsigned timer = 0; timer < 2; ++timer) write(timer, kTcsr, read(timer, kTcsr) & ~kCapture);
    for (unsigned timer = 0; timer < 2; ++timer) write(timer, kTcsr, read(timer, kTcsr) | 0x204u);
    reset_timer(0);
    reset_timer(1);
    write(0, kTcsr, read(0, kTcsr) | kRunAll);
    EXPECT_EQ(read(0, kTcsr) & 0x6D6u, 0x6D6u);
    pwm_rises_.clear();
    pwm_falls_.clear();
    int pairs = 0;
    for (bool seen[2] = {}; pairs < 10;) {
      wait_for_irq(2 * kPeriod);
      if (HasFailure()) return;
      for (unsigned timer = 0; timer < 2; ++timer) {
        const std::uint32_t status = read(timer, kTcsr);
        if ((status & kFlag) == 0) continue;
        write(timer, kTcsr, status);
        seen[timer] = true;
      }
      if (!seen[0] || !seen[1]) continue;
      ++pairs;
      seen[0] = seen[1] = false;
    }
    if (divisor == 1) {
      EXPECT_LE(pwm_rises_.size(), 1u);
      EXPECT_FALSE(dut_.pwm_o);
      continue;
    }
    ASSERT_GE(pwm_rises_.size(), 8u);
    ASSERT_GE(pwm_falls_.size(), 8u);
    const std::size_t first_fall = pwm_falls_[2] > pwm_rises_[2] ? 2 : 3;
    for (std::size_t i = 2; i < 7; ++i) {
      EXPECT_EQ(pwm_rises_[i + 1] - pwm_rises_[i], kPeriod) << divisor;
      if (first_fall - 2 + i < pwm_falls_.size()) {
        EXPECT_EQ(pwm_falls_[first_fall - 2 + i] - pwm_rises_[i], high) << divisor;
      }
    }
  }
}

// A stop that reads TCSR with ENALL and writes it back is none; one that writes ENALL 0 is.
TEST_P(AxiTimerDrivers, VendorStopAfterEnallStopsNothing) {
  write(0, kTlr, 100);
  write(0, kTcsr, 0x656);
  EXPECT_EQ(read(0, kTcsr) & ~kFlag, 0x6D6u);
  stop(0);
  stop(1);
  EXPECT_EQ(read(0, kTcsr) & ~kFlag, 0x6D6u);
  EXPECT_EQ(read(1, kTcsr) & ~kFlag, 0x480u);
  expect_counting(1);
  write(1, kTcsr, 0);
  write(0, kTcsr, 0x256);
  EXPECT_EQ(read(0, kTcsr) & ~kFlag, 0x256u);
  EXPECT_EQ(read(1, kTcsr) & ~kFlag, 0u);
}

// Linux, pwm: load both, modes, then ENALL in TCSR1; afterwards it wants ENT0 = 1, LOAD = 0, CASC = 0.
TEST_P(AxiTimerDrivers, LinuxPwmStartsBothTimersInPhase) {
  constexpr std::uint32_t kMode = kPwm | kGenerate | kReload | kDown;
  write(0, kTlr, 998);
  write(1, kTlr, 298);
  write(0, kTcsr, read(0, kTcsr) | kLoad);
  write(1, kTcsr, read(1, kTcsr) | kLoad);
  write(0, kTcsr, kMode);
  write(1, kTcsr, kMode | kRun | kRunAll);
  EXPECT_EQ(read(0, kTcsr) & (kRun | kLoad | kCascade), kRun);
  axi_.step(5000);
  ASSERT_GE(pwm_rises_.size(), 4u);
  ASSERT_GE(pwm_falls_.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(pwm_falls_[i] - pwm_rises_[i], 300) << "from the first pulse on";
    if (i > 0) {
      EXPECT_EQ(pwm_rises_[i] - pwm_rises_[i - 1], 1000);
    }
  }
  // A new state: timer 0 first, then timer 1, without a stop.
  write(0, kTlr, 1998);
  write(1, kTlr, 98);
  axi_.step(4000);
  pwm_rises_.clear();
  pwm_falls_.clear();
  axi_.step(6000);
  ASSERT_GE(pwm_rises_.size(), 2u);
  EXPECT_EQ(pwm_rises_[1] - pwm_rises_[0], 2000);
  EXPECT_EQ(read(0, kTlr), 1998u);
  EXPECT_EQ(read(1, kTlr), 98u);
  write(0, kTcsr, 0);
  write(1, kTcsr, 0);
  axi_.step(10);
  EXPECT_FALSE(dut_.pwm_o) << "off";
  const std::size_t rises = pwm_rises_.size();
  axi_.step(5000);
  EXPECT_EQ(pwm_rises_.size(), rises);
}

// 0, 50 and 100 %, each after each other one, from every clock of the period.
TEST_P(AxiTimerDrivers, ZephyrPwmDutyCyclesAreExactAfterEveryOtherOne) {
  constexpr int kPeriod = 100, kSettle = 2 * kPeriod, kLook = 4 * kPeriod;
  for (int phase = 0; phase < kPeriod; ++phase) {
    for (const int high : {50, 100, 0, 50, 0, 100, 50}) {
      zephyr_pwm(kPeriod, static_cast<std::uint32_t>(high));
      axi_.step(kSettle);
      ASSERT_EQ(high_clocks(kLook), 4 * high) << "phase " << phase;
      axi_.step(phase);
    }
  }
}

// Linux, microblaze: timer 0 is the periodic clock event, timer 1 the free-running clock source.
TEST_P(AxiTimerDrivers, LinuxClockEventAndClockSource) {
  write(1, kTcsr, 0x190);
  write(0, kTlr, 498);
  write(0, kTcsr, 0x020);
  write(0, kTcsr, 0x1D2);
  std::uint32_t previous = read(1, kTcr);
  for (int i = 0; i < 5; ++i) {
    wait_for_irq(600);
    const std::uint32_t status = read(0, kTcsr);
    EXPECT_EQ(status, 0x1D2u);
    write(0, kTcsr, status);
    EXPECT_EQ(read(0, kTcsr), 0x0D2u);
    const std::uint32_t source = read(1, kTcr);
    EXPECT_GT(source, previous);
    previous = source;
  }
  for (std::size_t i = 1; i < irq_rises_.size(); ++i) EXPECT_EQ(irq_rises_[i] - irq_rises_[i - 1], 500);
}

// Zephyr's counter: load with everything set, start; the alarm is a one-shot on timer 1.
TEST_P(AxiTimerDrivers, ZephyrCounterAndAlarm) {
  write(0, kTlr, 1000);
  write(0, kTcsr, 0x076);
  write(0, kTcsr, 0x0D6);
  write(1, kTlr, 200);
  write(1, kTcsr, 0x046 | kLoad);
  write(1, kTcsr, 0x0C6);
  wait_for_irq(300);
  EXPECT_EQ(read(1, kTcsr), 0x1C6u);
  write(1, kTcsr, 0x146);
  EXPECT_EQ(read(1, kTcsr), 0x046u);
  EXPECT_FALSE(dut_.irq_o);
  EXPECT_EQ(pulses_[1].size(), 1u);
  wait_for_irq(1000);
  EXPECT_EQ(read(0, kTcsr), 0x1D6u);
}

}  // namespace
}  // namespace armature::test::axi_timer
