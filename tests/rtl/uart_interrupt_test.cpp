// axi_uart16550: interrupt sources, their priority and what clears them; loopback.
#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

class UartInterrupts : public UartTest {
 protected:
  void expect_source(std::uint32_t iir) {
    axi_.step(2);
    EXPECT_EQ(dut_.irq_o, (iir & 1u) == 0);
    EXPECT_EQ(read(kIir), iir);
    axi_.step(2);
  }
};
INSTANTIATE_AXI_STALLS(UartInterrupts);

TEST_P(UartInterrupts, TheHighestPriorityShowsAndTheLineStaysHighForTheRest) {
  configure(1, {8, UartParity::kEven});
  write(kFcr, kFifoOn);
  receive(0x41, true);
  write(kMcr, kLoop | 2);
  write(kIer, 0x0F);
  expect_source(0xC6);
  read(kLsr);
  expect_source(0xC4);
  read(kRbr);
  expect_source(0xC2);  // this read acknowledges it
  EXPECT_TRUE(dut_.irq_o);
  expect_source(0xC0);
  read(kMsr);
  expect_source(0xC1);
}

TEST_P(UartInterrupts, EverySourceNeedsItsOwnEnable) {
  configure(1, {8, UartParity::kEven});
  receive(0x41, true);
  write(kMcr, kLoop | 2);
  static constexpr std::uint32_t kCode[] = {0x4, 0x2, 0x6, 0x0};
  for (unsigned bit = 0; bit < 4; ++bit) {
    write(kIer, 1u << bit);
    EXPECT_TRUE(dut_.irq_o);
    EXPECT_EQ(read(kIir), kCode[bit]);
    write(kIer, 0);
    EXPECT_FALSE(dut_.irq_o);
    EXPECT_EQ(read(kIir), 0x01u);
  }
}

// Neither OUT2 nor anything else of MCR gates the line.
TEST_P(UartInterrupts, ModemControlDoesNotGateTheLine) {
  write(kIer, kIerThre);
  for (std::uint32_t mcr = 0; mcr < 32; ++mcr) {
    write(kMcr, mcr);
    EXPECT_TRUE(dut_.irq_o) << mcr;
  }
}

TEST_P(UartInterrupts, EnablingThreWhileEmptyRaisesItEachTime) {
  expect_source(0x01);
  for (int i = 0; i < 3; ++i) {
    write(kIer, kIerThre);
    expect_source(0x02);  // acknowledged by the read
    EXPECT_FALSE(dut_.irq_o);
    expect_source(0x01);
    write(kIer, kIerThre | kIerLine);
    expect_source(0x01);  // bit 1 was set already
    write(kIer, 0);
  }
}

TEST_P(UartInterrupts, ThreIsAcknowledgedOnlyByTheReadThatReturnsIt) {
  configure(1);
  write(kFcr, kFifoOn);
  receive(0x41);
  write(kIer, kIerThre | kIerRx);
  expect_source(0xC4);
  expect_source(0xC4);
  write(kLcr, kDlab | format_.lcr());
  read(kFcr);
  write(kLcr, format_.lcr());
  read(kRbr);
  EXPECT_TRUE(dut_.irq_o) << "neither the read of another source nor that of FCR acknowledged it";
  expect_source(0xC2);
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(UartInterrupts, ThreIsClearedByWritingAndRaisedByTheLastCharacterTaken) {
  configure(32);
  write(kFcr, kFifoOn);
  write(kThr, 1);
  axi_.step(4);
  write(kIer, kIerThre);
  EXPECT_TRUE(dut_.irq_o) << "the first one is under way: THR is empty";
  write(kThr, 2);
  axi_.step(4);
  EXPECT_FALSE(dut_.irq_o);
  write(kThr, 3);
  EXPECT_EQ(read(kIir), 0xC1u);
  EXPECT_TRUE(wait_for_irq(30 * bit_));
  EXPECT_EQ(receiver_.characters.size(), 2u) << "the third has begun";
  EXPECT_EQ(read(kLsr), kThre);
  expect_source(0xC2);
  axi_.step(static_cast<int>(20 * bit_));
  EXPECT_FALSE(dut_.irq_o) << "emptying the shifter is no second event";
}

TEST_P(UartInterrupts, FlushingCharactersRaisesThreAndFlushingNothingDoesNot) {
  configure(32);
  write(kFcr, kFifoOn);
  write(kIer, kIerThre);
  read(kIir);
  write(kFcr, kFifoOn | kFlushTx);
  expect_source(0xC1);
  for (const std::uint32_t value : {1u, 2u, 3u}) write(kThr, value);
  expect_source(0xC1);
  write(kFcr, kFifoOn | kFlushTx);
  expect_source(0xC2);
}

TEST_P(UartInterrupts, EachLineErrorInterruptsUntilLsrIsRead) {
  configure(1, {8, UartParity::kEven});
  write(kIer, kIerLine);
  const auto expect_error = [this](std::uint32_t flags) {
    EXPECT_TRUE(dut_.irq_o) << flags;
    EXPECT_EQ(read(kIir), 0x06u);
    EXPECT_EQ(read(kLsr) & (kOe | kPe | kFe | kBi), flags);
    expect_source(0x01);
  };
  receive(0x01);
  expect_source(0x01);
  receive(0x02);
  expect_error(kOe);
  read(kRbr);
  receive(0x03, true);
  expect_error(kPe);
  read(kRbr);
  receive(0x05, false, false);
  expect_error(kFe);
  read(kRbr);
  sender_.bits(false, 12);
  sender_.bits(true, 1);
  finish_sending();
  expect_error(kFe | kBi);
}

TEST_P(UartInterrupts, UnreadDataKeepsTheLineHigh) {
  configure(1);
  write(kFcr, kFifoOn);
  write(kIer, kIerRx);
  receive(1);
  receive(2);
  for (int i = 0; i < 5; ++i) {
    expect_source(0xC4);
    axi_.step(200);
  }
  read(kRbr);
  expect_source(0xC4);
  read(kRbr);
  expect_source(0xC1);
}

class UartLoopback : public UartTest {};
INSTANTIATE_UART_LINE(UartLoopback);

TEST_P(UartLoopback, PinsAreIdleAndIgnored) {
  for (const UartFormat& format : all_uart_formats()) {
    configure(1, format);
    write(kFcr, kFifoOn | kFlushRx);
    write(kMcr, kLoop);
    sender_.send(0x00, format);
    write(kThr, 0x9A);
    write(kThr, 0x65);
    while (!sender_.idle() || (read(kLsr) & kTemt) == 0) axi_.step();
    EXPECT_EQ(read(kLsr), kDr | kThre | kTemt) << format;
    EXPECT_EQ(read(kRbr), 0x9Au & format.mask()) << format;
    EXPECT_EQ(read(kRbr), 0x65u & format.mask()) << format;
    EXPECT_EQ(read(kLsr), kThre | kTemt) << format;
    EXPECT_EQ(receiver_.segments.size(), 1u) << "txd_o stays high";
  }
}

TEST_P(UartLoopback, BreakActsOnThePinOnly) {
  configure(1);
  write(kMcr, kLoop);
  write(kLcr, format_.lcr() | kBreakOn);
  axi_.step(500);
  EXPECT_TRUE(dut_.txd_o);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
}

// Software that has received its own character takes the transmitter to be empty: DR and TEMT rise in one clock.
TEST_P(UartLoopback, ACharacterArrivesWhenTheTransmitterIsEmpty) {
  for (const unsigned divisor : {1u, 2u, 27u}) {
    for (const bool long_stop : {false, true}) {
      configure(divisor, {5, UartParity::kNone, long_stop});
      write(kFcr, kFifoOn);
      write(kMcr, kLoop);
      for (int phase = 0; phase < 6; ++phase) {
        write(kThr, 0x15);
        const std::int64_t begin = axi_.clock();
        axi_.step(phase);
        std::uint32_t lsr = 0;
        do {
          lsr = read(kLsr);
          ASSERT_EQ((lsr & kDr) != 0, (lsr & kTemt) != 0) << "divisor " << divisor << ", phase " << phase;
        } while ((lsr & kDr) == 0);
        EXPECT_NEAR(static_cast<double>(axi_.clock() - begin), format_.bits() * static_cast<double>(bit_), 12);
        EXPECT_EQ(read(kRbr), 0x15u);
      }
    }
  }
}

// A character that the line had begun when loopback came is not held back for ever.
TEST_P(UartLoopback, WithAnIdleTransmitterNothingIsHeldBack) {
  configure(2);
  sender_.send(0xFF, format_);
  axi_.step(40);
  write(kMcr, kLoop);
  finish_sending();
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0xFFu);
}

}  // namespace
}  // namespace armature::test
