// Fixture of axi_timer with its bus: register access per timer, sequences of the vendor driver, clocks of pin events.
#pragma once

#include <vector>

#include "Vaxi_timer.h"
#include "tests/rtl/axi_timer_bits.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test::axi_timer {

inline constexpr std::uint32_t kTimerStride = 0x10, kTcsr = 0x0, kTlr = 0x4, kTcr = 0x8;

class AxiTimerFixture : public AxiStallTest<Vaxi_timer> {
 protected:
  void SetUp() override {
    dut_.capture_trig_i = 0;
    dut_.freeze_i = 0;
    AxiStallTest<Vaxi_timer>::SetUp();
  }

  void clock() override {
    tick();
    for (unsigned timer = 0; timer < 2; ++timer) {
      if ((dut_.generate_o & 1u << timer) != 0) pulses_[timer].push_back(cycle_);
    }
    if (dut_.irq_o && !irq_) irq_rises_.push_back(cycle_);
    irq_ = dut_.irq_o;
    if (dut_.pwm_o && !pwm_) pwm_rises_.push_back(cycle_);
    if (!dut_.pwm_o && pwm_) pwm_falls_.push_back(cycle_);
    pwm_ = dut_.pwm_o;
  }

  static std::uint32_t address(unsigned timer, std::uint32_t reg) { return timer * kTimerStride + reg; }
  void write(unsigned timer, std::uint32_t reg, std::uint32_t value) {
    AxiStallTest::write(address(timer, reg), value);
  }
  std::uint32_t read(unsigned timer, std::uint32_t reg) { return AxiStallTest::read(address(timer, reg)); }

  // The sequences of the vendor's bare-metal driver, with the same names.
  void initialize(unsigned timer) {
    write(timer, kTlr, 0);
    write(timer, kTcsr, kFlag | kLoad);
    write(timer, kTcsr, 0);
  }
  void start(unsigned timer) {
    const std::uint32_t old = read(timer, kTcsr);
    write(timer, kTcsr, kLoad);
    write(timer, kTcsr, old | kRun);
  }
  void stop(unsigned timer) { write(timer, kTcsr, read(timer, kTcsr) & ~kRun); }
  void reset_timer(unsigned timer) {
    const std::uint32_t old = read(timer, kTcsr);
    write(timer, kTcsr, old | kLoad);
    write(timer, kTcsr, old);
  }
  // The counter counts up from 0.
  void self_test(unsigned timer) {
    write(timer, kTlr, 0);
    write(timer, kTcsr, kFlag | kLoad);
    write(timer, kTcsr, kRun);
    const std::uint32_t first = read(timer, kTcr);
    EXPECT_GT(read(timer, kTcr), first);
    write(timer, kTcsr, kFlag | kLoad);
    write(timer, kTcsr, 0);
    EXPECT_EQ(read(timer, kTcr), 0u);
  }
  void expect_counting(unsigned timer) {
    const std::uint32_t first = read(timer, kTcr);
    for (int polls = 0; polls < 100; ++polls) {
      if (read(timer, kTcr) != first) return;
    }
    ADD_FAILURE() << "timer " << timer << " does not count";
  }

  void wait_for_irq(std::int64_t limit) {
    for (std::int64_t i = 0; i < limit && !dut_.irq_o; ++i) axi_.step();
    EXPECT_TRUE(dut_.irq_o) << "no interrupt within " << limit << " clocks";
  }

  std::vector<std::int64_t> pulses_[2];  // cycles in which generate_o was high
  std::vector<std::int64_t> irq_rises_;  // first cycle of each pulse of irq_o
  std::vector<std::int64_t> pwm_rises_, pwm_falls_;
  bool irq_ = false, pwm_ = false;
};

}  // namespace armature::test::axi_timer
