// axi_uart16550 under the register traffic of two drivers, re-expressed: AMD's bare-metal driver with its examples, and
// Linux's 8250 driver.
#include <numeric>

#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

constexpr unsigned kDivisor19200 = 163, kDivisor3125000 = 1;

class UartVendorDriver : public UartTest {
 protected:
  using Bytes = std::vector<unsigned>;
  static constexpr std::uint32_t kFifoReset = 1, kFifos = 2, kLoopback = 4, kDataInterrupt = 8;

  static Bytes pattern(std::size_t count) {
    Bytes data(count);
    std::iota(data.begin(), data.end(), 1);
    return data;
  }

  void set_baud(unsigned divisor) {
    const std::uint32_t lcr = read(kLcr);
    write(kLcr, lcr | kDlab);
    write(kDll, 0xFF);
    write(kDlm, divisor >> 8);
    write(kDll, divisor & 0xFF);
    write(kLcr, lcr);
    bit_ = 16 * static_cast<std::int64_t>(divisor);
    receiver_.bit_clocks = static_cast<double>(bit_);
  }
  void initialize(unsigned divisor) {
    set_baud(divisor);
    write(kLcr, 0x03);
    write(kFcr, 0x01);
    write(kFcr, 0x81);
  }

  // Sends as many of the bytes from `next_` on as the FIFO takes.
  std::size_t send() {
    const std::uint32_t ier = read(kIer);
    write(kIer, ier & ~kIerThre);
    const std::uint32_t lsr = read(kLsr);
    std::size_t room = 0;
    if ((lsr & kThre) != 0) room = (read(kIir) & 0xC0) == 0xC0 ? ((lsr & kTemt) != 0 ? 16 : 15) : 1;
    const std::size_t count = std::min(room, sending_.size() - next_);
    for (std::size_t i = 0; i < count; ++i) write(kThr, sending_[next_++]);
    const std::uint32_t after = read(kIer);
    if ((after & kIerRx) != 0) write(kIer, after | kIerThre);
    return count;
  }
  std::size_t send(const Bytes& data) {
    sending_ = data;
    next_ = 0;
    return send();
  }
  void receive_waiting(std::size_t limit) {
    const std::uint32_t ier = read(kIer);
    write(kIer, 0);
    while (received_.size() < limit && (read(kLsr) & kDr) != 0) received_.push_back(read(kRbr));
    write(kIer, ier);
  }
  std::uint32_t read_fcr() {
    const std::uint32_t lcr = read(kLcr);
    write(kLcr, lcr | kDlab);
    const std::uint32_t fcr = read(kFcr);
    write(kLcr, lcr);
    return fcr;
  }
  // One read-modify-write per option, FCR by way of its read-back.
  void set_options(std::uint32_t options) {
    const auto change = [this](std::uint32_t reg, std::uint32_t bit, bool set) {
      const std::uint32_t old = reg == kFcr ? read_fcr() : read(reg);
      write(reg, set ? old | bit : old & ~bit);
    };
    change(kFcr, kFlushRx, (options & kFifoReset) != 0);
    change(kFcr, kFlushTx, (options & kFifoReset) != 0);
    change(kFcr, kFifoOn, (options & kFifos) != 0);
    for (const std::uint32_t output : {1u, 2u, 4u, 8u}) change(kMcr, output, false);
    change(kMcr, kLoop, (options & kLoopback) != 0);
    for (const std::uint32_t enable : {kIerModem, kIerLine}) change(kIer, enable, false);
    change(kIer, kIerRx, (options & kDataInterrupt) != 0);
    change(kLcr, kBreakOn, false);
  }
  void self_test() {
    const std::uint32_t ier = read(kIer);
    write(kIer, 0);
    const std::uint32_t mcr = read(kMcr);
    write(kMcr, mcr | kLoop);
    for (unsigned i = 0; i < 32; ++i) {
      ASSERT_EQ(send({i}), 1u) << "byte " << i;
      wait_for_data();
      received_.clear();
      receive_waiting(1);
      ASSERT_EQ(received_, Bytes{i});
    }
    write(kIer, ier);
    write(kMcr, mcr);
  }
  void wait_for_data() {
    const std::int64_t limit = axi_.clock() + 20 * bit_;
    while ((read(kLsr) & kDr) == 0) ASSERT_LT(axi_.clock(), limit) << "no data";
  }
  // One source per call, as the driver's handler does it.
  void handle_interrupt() {
    const std::uint32_t iir = read(kIir);
    ASSERT_EQ(iir & 0xF0, 0xC0u);
    switch (iir & 0x0F) {
      case 0x2:
        ++transmit_interrupts_;
        send();
        break;
      case 0xC:
        ++timeouts_;
        [[fallthrough]];
      case 0x4:
        ++receive_interrupts_;
        while ((read(kLsr) & kDr) != 0) received_.push_back(read(kRbr));
        break;
      default:
        ADD_FAILURE() << "IIR " << iir;
    }
  }

  Bytes sending_, received_;
  std::size_t next_ = 0;
  int transmit_interrupts_ = 0, receive_interrupts_ = 0, timeouts_ = 0;
};
INSTANTIATE_UART_LINE(UartVendorDriver);

TEST_P(UartVendorDriver, SelfTestAt3125000Baud) {
  initialize(kDivisor3125000);
  self_test();
  EXPECT_EQ(receiver_.segments.size(), 1u) << "nothing on the line";
}

TEST_P(UartVendorDriver, SelfTestAt19200Baud) {
  initialize(kDivisor19200);
  self_test();
}

// Send(16) right after the self test: the driver gives the FIFO sixteen bytes only if the transmitter is empty.
TEST_P(UartVendorDriver, PolledExample) {
  for (const unsigned divisor : {1u, 27u, 40u, 163u, 326u}) {
    initialize(divisor);
    self_test();
    set_options(kLoopback | kFifos);
    const Bytes data = pattern(16);
    ASSERT_EQ(send(data), 16u) << "divisor " << divisor;
    received_.clear();
    while (received_.size() < 16) {
      wait_for_data();
      receive_waiting(16);
    }
    EXPECT_EQ(received_, data);
    EXPECT_EQ(read_fcr(), 0x81u);
    EXPECT_EQ(read(kMcr), kLoop);
    set_options(0);
    EXPECT_EQ(read_fcr(), 0x80u);
    EXPECT_EQ(read(kMcr), 0u);
  }
}

TEST_P(UartVendorDriver, FifoThresholdSurvivesOptions) {
  initialize(1);
  for (const std::uint32_t threshold : {0x00u, 0x40u, 0x80u, 0xC0u}) {
    write(kFcr, (read_fcr() & ~0xC0u) | threshold);
    EXPECT_EQ(read_fcr(), threshold | kFifoOn);
    set_options(kFifos);
    EXPECT_EQ(read_fcr(), threshold | kFifoOn);
  }
}

// A hundred bytes: sixteen from Send, the rest by interrupts; eight at a time come back, the last four by a timeout.
TEST_P(UartVendorDriver, InterruptExampleInLoopback) {
  for (const unsigned divisor : {1u, 8u}) {
    initialize(divisor);
    self_test();
    set_options(kDataInterrupt | kLoopback | kFifos);
    const Bytes data = pattern(100);
    received_.clear();
    transmit_interrupts_ = receive_interrupts_ = timeouts_ = 0;
    receive_waiting(0);
    EXPECT_EQ(send(data), 16u);
    while (received_.size() < data.size()) {
      ASSERT_TRUE(wait_for_irq(200 * bit_)) << received_.size() << " bytes";
      handle_interrupt();
      if (HasFatalFailure()) return;
    }
    EXPECT_EQ(received_, data);
    EXPECT_GE(transmit_interrupts_, 6);
    EXPECT_GE(timeouts_, 1);
    EXPECT_LE(receive_interrupts_, 14);
    EXPECT_EQ(read(kLsr), kThre | kTemt);
    write(kIer, 0);
    write(kMcr, 0);
  }
}

TEST_P(UartVendorDriver, HelloWorld) {
  initialize(4);
  const std::string text = "Hello World\n";
  std::size_t sent = 0;
  while (sent < text.size()) sent += send({static_cast<unsigned char>(text[sent])});
  finish_transmitting();
  const std::vector<unsigned> line = receiver_.data();
  EXPECT_EQ(std::string(line.begin(), line.end()), text);
}

TEST_P(UartVendorDriver, LowLevelExampleOverAWire) {
  for (const unsigned divisor : {kDivisor3125000, kDivisor19200}) {
    wired_ = true;
    set_baud(divisor);
    write(kLcr, 0x03);
    write(kFcr, 0x01);
    for (unsigned i = 0; i < 16; ++i) {
      while ((read(kLsr) & kThre) == 0) axi_.step();
      write(kThr, 0x30 + i);
    }
    for (unsigned i = 0; i < 16; ++i) {
      wait_for_data();
      EXPECT_EQ(read(kRbr), 0x30 + i);
    }
    EXPECT_EQ(read(kLsr) | kTemt, kThre | kTemt) << "no overrun; the last stop bit may still be on the line";
    axi_.step(static_cast<int>(bit_));
  }
}

class UartLinuxDriver : public UartTest {
 protected:
  // Byte accesses, as with reg-shift = 2 and no reg-io-width.
  void out(std::uint32_t reg, std::uint32_t value) {
    EXPECT_EQ(axi_.write(reg, value * 0x0101'0101u, 0x1), AxiResp::kOkay);
  }
  void clear_fifos() {
    out(kFcr, 0x01);
    out(kFcr, 0x07);
    out(kFcr, 0x00);
  }
};
INSTANTIATE_AXI_STALLS(UartLinuxDriver);

TEST_P(UartLinuxDriver, StartupFindsNoBugs) {
  clear_fifos();
  for (const std::uint32_t reg : {kLsr, kRbr, kIir, kMsr}) read(reg);
  EXPECT_NE(read(kLsr), 0xFFu);
  out(kLcr, 0x03);
  // THRE test: the interrupt comes back when it is enabled again.
  out(kIer, kIerThre);
  read(kIir);
  out(kIer, 0);
  out(kIer, kIerThre);
  EXPECT_EQ(read(kIir) & 0x0F, 0x02u);
  out(kIer, 0);
  // TXEN test: an empty transmitter interrupts as soon as it may.
  out(kIer, kIerThre);
  const std::uint32_t lsr = read(kLsr), iir = read(kIir);
  out(kIer, 0);
  EXPECT_EQ(lsr & kTemt, kTemt);
  EXPECT_EQ(iir & 0x0F, 0x02u);
  for (const std::uint32_t reg : {kLsr, kRbr, kIir, kMsr}) read(reg);
  out(kIer, kIerRx | kIerLine);
  EXPECT_EQ(read(kIir) & 0x0F, 0x01u);
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(UartLinuxDriver, AutoconfigSeesA16550A) {
  // There is a UART: IER takes its four bits.
  out(kIer, 0);
  EXPECT_EQ(read(kIer) & 0x0F, 0x00u);
  out(kIer, 0x0F);
  EXPECT_EQ(read(kIer) & 0x0F, 0x0Fu);
  out(kIer, 0);
  // Loop test.
  out(kMcr, 0x1A);
  EXPECT_EQ(read(kMsr) & 0xF0, 0x90u);
  out(kMcr, 0);
  // IIR 7:6 with the FIFOs on.
  out(kLcr, 0xBF);
  out(kFcr, 0x00);
  out(kLcr, 0x00);
  out(kFcr, 0x01);
  EXPECT_EQ(read(kIir) >> 6, 3u);
  // No EFR (16650) at offset 2 behind DLAB.
  out(kLcr, 0x80);
  EXPECT_NE(read(kIir), 0u);
  out(kLcr, 0xBF);
  EXPECT_NE(read(kIir), 0u);
  // No EXCR1 (National): bit 4 there does not follow MCR.LOOP.
  out(kLcr, 0x00);
  const std::uint32_t mcr = read(kMcr);
  out(kLcr, 0xE0);
  const std::uint32_t before = read(kIir);
  out(kLcr, 0x00);
  out(kMcr, mcr ^ kLoop);
  out(kLcr, 0xE0);
  const std::uint32_t after = read(kIir);
  out(kLcr, 0x00);
  out(kMcr, mcr);
  EXPECT_EQ((before ^ after) & kLoop, 0u);
  // No 64-byte FIFO (16750), with or without DLAB.
  out(kFcr, 0x21);
  EXPECT_EQ(read(kIir) >> 5, 6u);
  out(kFcr, 0x01);
  out(kLcr, 0x80);
  out(kFcr, 0x21);
  EXPECT_NE(read(kIir) >> 5, 7u);
  out(kFcr, 0x01);
  out(kLcr, 0x00);
  // No XScale: bit 6 of IER does not stick.
  out(kIer, 0x40);
  EXPECT_EQ(read(kIer), 0u);
  // Scratch register.
  for (const std::uint32_t value : {0xA5u, 0x5Au}) {
    out(kScr, value);
    EXPECT_EQ(read(kScr), value);
  }
}

// Sends 256 bytes to itself at divisor 1 and counts what the FIFO has kept.
TEST_P(UartLinuxDriver, FifoSizeIsSixteen) {
  out(kFcr, 0x07);
  out(kMcr, kLoop);
  out(kLcr, 0x80);
  out(kDll, 1);
  out(kDlm, 0);
  out(kLcr, 0x03);
  for (unsigned i = 0; i < 256; ++i) axi_.post_write(kThr, i, 0x1);
  axi_.drain();
  axi_.write_answers.clear();
  axi_.step(20 * 160);
  unsigned count = 0;
  while ((read(kLsr) & kDr) != 0 && count < 256) {
    EXPECT_EQ(read(kRbr), count) << "in order from the first";
    ++count;
  }
  EXPECT_EQ(count, 16u);
}

}  // namespace
}  // namespace armature::test
