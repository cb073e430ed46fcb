// axi_timer over the bus: the register traffic of the drivers that the block must be compatible with, both timers, and
// the interrupt line. Clock-exact counting is axi_timer_channel_test's subject.
#include <vector>

#include "Vaxi_timer.h"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

constexpr std::uint32_t kTimerStride = 0x10, kTcsr = 0x0, kTlr = 0x4, kTcr = 0x8;
constexpr std::uint32_t kDown = 1u << 1, kGenerate = 1u << 2, kReload = 1u << 4, kLoad = 1u << 5, kIrq = 1u << 6,
                        kRun = 1u << 7, kFlag = 1u << 8;

class AxiTimerTest : public AxiStallTest<Vaxi_timer> {
 protected:
  void clock() override {
    tick();
    for (unsigned timer = 0; timer < 2; ++timer) {
      if ((dut_.generate_o & 1u << timer) != 0) pulses_[timer].push_back(cycle_);
    }
    if (dut_.irq_o && !irq_) irq_rises_.push_back(cycle_);
    irq_ = dut_.irq_o;
  }

  static std::uint32_t address(unsigned timer, std::uint32_t reg) { return timer * kTimerStride + reg; }
  void write(unsigned timer, std::uint32_t reg, std::uint32_t value) {
    EXPECT_EQ(axi_.write(address(timer, reg), value), AxiResp::kOkay);
  }
  std::uint32_t read(unsigned timer, std::uint32_t reg) {
    const AxiReadResult result = axi_.read(address(timer, reg));
    EXPECT_EQ(result.resp, AxiResp::kOkay);
    return result.data;
  }

  // The sequences of the vendor's bare-metal driver, by their names there.
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
  std::vector<std::int64_t> irq_rises_;  // first cycles of irq_o
  bool irq_ = false;
};
INSTANTIATE_AXI_STALLS(AxiTimerTest);

TEST_P(AxiTimerTest, ResetStateIsZeroAndSilent) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    for (const std::uint32_t reg : {kTcsr, kTlr, kTcr}) EXPECT_EQ(read(timer, reg), 0u);
  }
  axi_.step(100);
  EXPECT_TRUE(pulses_[0].empty() && pulses_[1].empty() && irq_rises_.empty());
}

TEST_P(AxiTimerTest, RegistersReadBackForBothTimersSeparately) {
  write(0, kTlr, 0x1234'5678u);
  write(1, kTlr, 0x9ABC'DEF0u);
  write(0, kTcsr, kDown | kIrq);
  write(1, kTcsr, kGenerate | kLoad);
  EXPECT_EQ(read(0, kTlr), 0x1234'5678u);
  EXPECT_EQ(read(1, kTlr), 0x9ABC'DEF0u);
  EXPECT_EQ(read(0, kTcsr), kDown | kIrq);
  EXPECT_EQ(read(1, kTcsr), kGenerate | kLoad);
  EXPECT_EQ(read(0, kTcr), 0u);
  EXPECT_EQ(read(1, kTcr), 0x9ABC'DEF0u);
}

TEST_P(AxiTimerTest, BitsWithoutAFunctionReadZero) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write(timer, kTcsr, ~kRun);
    EXPECT_EQ(read(timer, kTcsr), kDown | kGenerate | kReload | kLoad | kIrq);
  }
}

TEST_P(AxiTimerTest, ByteStrobesReachTcsrAndTlr) {
  write(1, kTlr, 0x1122'3344u);
  EXPECT_EQ(axi_.write(address(1, kTlr), 0xAABB'CCDDu, 0x6), AxiResp::kOkay);
  EXPECT_EQ(read(1, kTlr), 0x11BB'CC44u);
  EXPECT_EQ(axi_.write(address(1, kTlr), 0, 0x0), AxiResp::kOkay);
  EXPECT_EQ(read(1, kTlr), 0x11BB'CC44u);
  EXPECT_EQ(axi_.write(address(0, kTcsr), 0xFFFF'FFFFu, 0xE), AxiResp::kOkay);
  EXPECT_EQ(read(0, kTcsr), 0u);
}

TEST_P(AxiTimerTest, UnmappedAndReadOnlyRegistersAnswerSlvErr) {
  write(0, kTlr, 77);
  for (const std::uint32_t addr : {0x20u, 0x24u, 0x100u, 0x1000u, 0x8004u, 0xFFFCu}) {
    EXPECT_EQ(axi_.write(addr, 1), AxiResp::kSlvErr) << std::hex << addr;
    EXPECT_EQ(axi_.read(addr).resp, AxiResp::kSlvErr) << std::hex << addr;
  }
  EXPECT_EQ(axi_.write(address(0, kTcr), 5), AxiResp::kSlvErr);
  EXPECT_EQ(read(0, kTcr), 0u);
  EXPECT_EQ(read(0, kTlr), 77u);
}

// As in the vendor's core, so that a dump of all eight words does not trap.
TEST_P(AxiTimerTest, ReservedWordsReadZero) {
  for (const std::uint32_t addr : {0x0Cu, 0x1Cu}) {
    EXPECT_EQ(axi_.write(addr, 0xFFFF'FFFFu), AxiResp::kSlvErr);
    EXPECT_EQ(axi_.read(addr), (AxiReadResult{AxiResp::kOkay, 0u}));
  }
}

TEST_P(AxiTimerTest, UnalignedAddressesSelectTheWord) {
  EXPECT_EQ(axi_.write(0x07, 0x5566'7788u), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(0x05), (AxiReadResult{AxiResp::kOkay, 0x5566'7788u}));
}

TEST_P(AxiTimerTest, VendorSelfTestSeesBothTimersCountUp) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    initialize(timer);
    write(timer, kTlr, 0);
    write(timer, kTcsr, kFlag | kLoad);
    write(timer, kTcsr, kRun);
    const std::uint32_t first = read(timer, kTcr);
    EXPECT_GT(read(timer, kTcr), first);
    write(timer, kTcsr, kFlag | kLoad);
    write(timer, kTcsr, 0);
    EXPECT_EQ(read(timer, kTcr), 0u);
  }
}

TEST_P(AxiTimerTest, VendorPolledExample) {
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

TEST_P(AxiTimerTest, VendorLowLevelExample) {
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
TEST_P(AxiTimerTest, VendorInterruptExample) {
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

// Linux, microblaze: timer 0 is the periodic clock event, timer 1 the free-running clock source.
TEST_P(AxiTimerTest, LinuxClockEventAndClockSource) {
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
TEST_P(AxiTimerTest, ZephyrCounterAndAlarm) {
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

// Any read-modify-write of TCSR while the flag is set acknowledges it: the drivers rely on it.
TEST_P(AxiTimerTest, ReadModifyWriteAcknowledges) {
  write(0, kTlr, 2);
  write(0, kTcsr, kLoad);
  write(0, kTcsr, kRun | kDown | kIrq);
  wait_for_irq(50);
  stop(0);
  EXPECT_EQ(read(0, kTcsr), kDown | kIrq);
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(AxiTimerTest, InterruptIsTheOrOfTheEnabledFlagsAndALevel) {
  for (unsigned enabled = 0; enabled < 4; ++enabled) {
    for (unsigned timer = 0; timer < 2; ++timer) {
      write(timer, kTlr, 3);
      write(timer, kTcsr, kLoad);
      write(timer, kTcsr, kRun | kDown | (enabled >> timer & 1u ? kIrq : 0u));
    }
    axi_.step(20);
    for (unsigned timer = 0; timer < 2; ++timer) {
      EXPECT_EQ(dut_.irq_o, (enabled >> timer) != 0) << "enabled " << enabled << ", acknowledged below " << timer;
      axi_.step(30);
      EXPECT_EQ(dut_.irq_o, (enabled >> timer) != 0) << "not a level";
      EXPECT_TRUE(read(timer, kTcsr) & kFlag);
      write(timer, kTcsr, read(timer, kTcsr));
    }
    EXPECT_FALSE(dut_.irq_o);
  }
}

TEST_P(AxiTimerTest, TriggerOfTheTickIsExactWhateverTheBusDoes) {
  write(0, kTlr, 2498);
  write(0, kTcsr, kLoad);
  write(0, kTcsr, kRun | kDown | kReload | kGenerate | kIrq);
  for (int tick = 0; tick < 20; ++tick) {
    wait_for_irq(2600);
    for (unsigned i = 0; i < 10; ++i) axi_.post_read(address(i % 2, kTcr));
    for (std::uint32_t i = 0; i < 10; ++i) axi_.post_write(address(1, kTlr), i);
    axi_.drain();
    axi_.read_answers.clear();
    axi_.write_answers.clear();
    write(0, kTcsr, read(0, kTcsr));
  }
  ASSERT_EQ(pulses_[0].size(), 20u);
  ASSERT_EQ(irq_rises_.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    if (i > 0) {
      EXPECT_EQ(pulses_[0][i] - pulses_[0][i - 1], 2500);
    }
    EXPECT_EQ(irq_rises_[i], pulses_[0][i] + 1);
  }
  EXPECT_TRUE(pulses_[1].empty());
}

TEST_P(AxiTimerTest, RandomRegisterTrafficMatchesASoftwareModel) {
  std::uint32_t tcsr[2] = {}, tlr[2] = {};  // the timers stand still: no LOAD, no ENT
  for (int i = 0; i < 400; ++i) {
    const unsigned timer = axi_.random().below(2), strobe = axi_.random().below(16);
    const std::uint32_t reg = 4 * axi_.random().below(4);
    const auto data = static_cast<std::uint32_t>(axi_.random().next()) & ~(reg == kTcsr ? kRun | kLoad : 0u);
    const bool writable = reg == kTcsr || reg == kTlr;
    if (reg == kTcsr && strobe & 1u) tcsr[timer] = data & (kDown | kGenerate | kReload | kIrq);
    for (unsigned byte = 0; reg == kTlr && byte < 4; ++byte) {
      const std::uint32_t mask = 0xFFu << (8 * byte);
      if (strobe >> byte & 1u) tlr[timer] = (tlr[timer] & ~mask) | (data & mask);
    }
    EXPECT_EQ(axi_.write(address(timer, reg), data, strobe), writable ? AxiResp::kOkay : AxiResp::kSlvErr);
    for (unsigned t = 0; t < 2; ++t) {
      EXPECT_EQ(read(t, kTcsr), tcsr[t]);
      EXPECT_EQ(read(t, kTlr), tlr[t]);
      EXPECT_EQ(read(t, kTcr), 0u);
    }
  }
}

}  // namespace
}  // namespace armature::test
