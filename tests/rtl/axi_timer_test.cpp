// axi_timer over the bus: register access, error answers, the interrupt line, the trigger of the tick. Clock-exact
// counting is the subject of the tests without the bus, driver traffic that of axi_timer_drivers_test.
#include "tests/rtl/axi_timer_fixture.hpp"

namespace armature::test::axi_timer {
namespace {

class AxiTimerTest : public AxiTimerFixture {};
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
    write(timer, kTcsr, ~(kRun | kRunAll));
    EXPECT_EQ(read(timer, kTcsr), timer == 0 ? 0xA7Fu : 0x27Fu) << "CASC is a bit of TCSR0 alone";
  }
}

TEST_P(AxiTimerTest, ByteStrobesReachTcsrAndTlr) {
  write(1, kTlr, 0x1122'3344u);
  EXPECT_EQ(axi_.write(address(1, kTlr), 0xAABB'CCDDu, 0x6), AxiResp::kOkay);
  EXPECT_EQ(read(1, kTlr), 0x11BB'CC44u);
  EXPECT_EQ(axi_.write(address(1, kTlr), 0, 0x0), AxiResp::kOkay);
  EXPECT_EQ(read(1, kTlr), 0x11BB'CC44u);
  EXPECT_EQ(axi_.write(address(0, kTcsr), ~kRunAll, 0xE), AxiResp::kOkay);
  EXPECT_EQ(read(0, kTcsr), kCascade | kPwm);
}

TEST_P(AxiTimerTest, OffsetsBeyondTheMapAnswerSlvErr) {
  for (const std::uint32_t addr : {0x20u, 0x24u, 0x100u, 0x1000u, 0x8004u, 0xFFFCu}) {
    EXPECT_EQ(axi_.write(addr, 1), AxiResp::kSlvErr) << std::hex << addr;
    EXPECT_EQ(axi_.read(addr).resp, AxiResp::kSlvErr) << std::hex << addr;
  }
}

// As in the vendor's block: TCR and the reserved words, which read 0.
TEST_P(AxiTimerTest, WritesToReadOnlyAndReservedWordsAreIgnored) {
  write(0, kTlr, 77);
  for (const std::uint32_t addr : {0x08u, 0x0Cu, 0x18u, 0x1Cu}) {
    EXPECT_EQ(axi_.write(addr, 0xFFFF'FFFFu), AxiResp::kOkay) << std::hex << addr;
    EXPECT_EQ(axi_.read(addr), (AxiReadResult{AxiResp::kOkay, 0u})) << std::hex << addr;
  }
  for (unsigned timer = 0; timer < 2; ++timer) {
    EXPECT_EQ(read(timer, kTcsr), 0u);
    EXPECT_EQ(read(timer, kTlr), timer == 0 ? 77u : 0u);
  }
}

TEST_P(AxiTimerTest, UnalignedAddressesSelectTheWord) {
  EXPECT_EQ(axi_.write(0x07, 0x5566'7788u), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(0x05), (AxiReadResult{AxiResp::kOkay, 0x5566'7788u}));
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

// The pins reach the timers they belong to.
TEST_P(AxiTimerTest, CapturePinsAndFreezeAreWired) {
  for (unsigned timer = 0; timer < 2; ++timer) {
    write(timer, kTcsr, kRun | kCapture | kCapturePin);
    dut_.capture_trig_i = static_cast<CData>(1u << timer);
    axi_.step(5);
    EXPECT_NE(read(timer, kTlr), 0u);
    EXPECT_EQ(read(timer, kTcsr), kRun | kCapture | kCapturePin | kFlag);
    EXPECT_EQ(read(1 - timer, kTcsr) & kFlag, timer == 0 ? 0u : kFlag);
  }
  dut_.freeze_i = 1;
  axi_.step(5);
  for (unsigned timer = 0; timer < 2; ++timer) {
    const std::uint32_t frozen = read(timer, kTcr);
    axi_.step(10);
    EXPECT_EQ(read(timer, kTcr), frozen);
  }
  dut_.freeze_i = 0;
  axi_.step(3);
  expect_counting(0);
  expect_counting(1);
}

TEST_P(AxiTimerTest, RandomRegisterTrafficMatchesASoftwareModel) {
  std::uint32_t tcsr[2] = {}, tlr[2] = {};  // the timers stand still: no LOAD, no ENT, no ENALL
  for (int i = 0; i < 400; ++i) {
    const unsigned timer = axi_.random().below(2), strobe = axi_.random().below(16);
    const std::uint32_t reg = 4 * axi_.random().below(4);
    const auto data = static_cast<std::uint32_t>(axi_.random().next()) & ~(reg == kTcsr ? kRun | kLoad | kRunAll : 0u);
    const std::uint32_t modes = (strobe & 1u ? 0xFFu : 0u) | (strobe & 2u ? kPwm | (timer == 0 ? kCascade : 0u) : 0u);
    if (reg == kTcsr) tcsr[timer] = (tcsr[timer] & ~modes) | (data & modes);
    for (unsigned byte = 0; reg == kTlr && byte < 4; ++byte) {
      const std::uint32_t mask = 0xFFu << (8 * byte);
      if (strobe >> byte & 1u) tlr[timer] = (tlr[timer] & ~mask) | (data & mask);
    }
    EXPECT_EQ(axi_.write(address(timer, reg), data, strobe), AxiResp::kOkay);
    for (unsigned t = 0; t < 2; ++t) {
      EXPECT_EQ(read(t, kTcsr), tcsr[t]);
      EXPECT_EQ(read(t, kTlr), tlr[t]);
      EXPECT_EQ(read(t, kTcr), 0u);
    }
  }
}

}  // namespace
}  // namespace armature::test::axi_timer
