// Fixture of axi_uart16550 with its bus, a serial line at its pins and every modem line inactive.
#pragma once

#include <functional>
#include <iostream>
#include <vector>

#include "Vaxi_uart16550.h"
#include "tests/rtl/uart_line.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {

namespace uart {
// Byte registers: the vendor's base address plus 0x1000, one per word.
inline constexpr std::uint32_t kRbr = 0x1000, kIer = 0x1004, kIir = 0x1008, kLcr = 0x100C, kMcr = 0x1010, kLsr = 0x1014,
                               kMsr = 0x1018, kScr = 0x101C;
inline constexpr std::uint32_t kThr = kRbr, kDll = kRbr, kDlm = kIer, kFcr = kIir;
inline constexpr std::uint32_t kDlab = 0x80, kBreakOn = 0x40, kLoop = 0x10;
inline constexpr std::uint32_t kDr = 1, kOe = 2, kPe = 4, kFe = 8, kBi = 0x10, kThre = 0x20, kTemt = 0x40,
                               kFifoError = 0x80;
inline constexpr std::uint32_t kIerRx = 1, kIerThre = 2, kIerLine = 4, kIerModem = 8;
inline constexpr std::uint32_t kFifoOn = 1, kFlushRx = 2, kFlushTx = 4;
}  // namespace uart

class UartTest : public AxiStallTest<Vaxi_uart16550> {
 protected:
  void SetUp() override {
    dut_.rxd_i = 1;
    dut_.cts_ni = dut_.dsr_ni = dut_.dcd_ni = dut_.ri_ni = 1;
    AxiStallTest::SetUp();
    axi_.step(4);
  }

  void clock() override {
    dut_.rxd_i = wired_ ? dut_.txd_o : sender_.clock();
    tick();
    receiver_.clock(dut_.txd_o);
  }

  // Sets divisor and format of the block and of both ends of the line.
  void configure(unsigned divisor, const UartFormat& format = {}) {
    format_ = receiver_.format = format;
    bit_ = 16 * static_cast<std::int64_t>(divisor);
    sender_.bit_clocks = receiver_.bit_clocks = static_cast<double>(bit_);
    write(uart::kLcr, uart::kDlab | format.lcr());
    write(uart::kDll, divisor & 0xFF);
    write(uart::kDlm, divisor >> 8);
    write(uart::kLcr, format.lcr());
  }

  // Runs until everything queued has been sent on the line, and half a bit longer.
  void finish_sending() {
    while (!sender_.idle()) axi_.step();
    axi_.step(static_cast<int>(bit_ / 2) + 8);
  }
  void receive(unsigned data, bool wrong_parity = false, bool stop = true) {
    sender_.send(data, format_, wrong_parity, stop);
    finish_sending();
  }
  void transmit(const std::vector<unsigned>& data) {
    for (const unsigned value : data) write(uart::kThr, value);
  }
  // Runs until the transmitter is empty.
  void finish_transmitting() {
    const std::int64_t limit = axi_.clock() + 40 * 12 * bit_;
    while ((read(uart::kLsr) & uart::kTemt) == 0) {
      ASSERT_LT(axi_.clock(), limit) << "the transmitter does not end";
    }
    axi_.step(4);
  }
  bool wait_for_irq(std::int64_t limit) {
    for (std::int64_t i = 0; i < limit && !dut_.irq_o; ++i) axi_.step();
    return dut_.irq_o;
  }

  LineSender sender_;
  LineReceiver receiver_;
  UartFormat format_;
  std::int64_t bit_ = 16;  // clocks
  bool wired_ = false;     // txd_o instead of the sender is connected to rxd_i
};

// Tests of register traffic run with every stall pattern. The line does not depend on the bus: one pattern is enough.
#define INSTANTIATE_UART_LINE(Fixture)                                                            \
  INSTANTIATE_TEST_SUITE_P(Stalls, Fixture, ::testing::Values(::armature::test::AxiStall::kNone), \
                           [](const auto& suite) { return ::armature::test::name_of(suite.param); })

}  // namespace armature::test
