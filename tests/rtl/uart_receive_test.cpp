// axi_uart16550: reception from a line with foreign bit times and every defect, the receive FIFO, its error bits and
// the character timeout.
#include <numeric>

#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

class UartReceive : public UartTest {
 protected:
  std::vector<unsigned> drain() {
    std::vector<unsigned> data;
    while ((read(kLsr) & kDr) != 0) data.push_back(read(kRbr));
    return data;
  }
  // Clocks from now until irq_o rises.
  std::int64_t clocks_to_irq(std::int64_t limit) {
    const std::int64_t begin = axi_.clock();
    EXPECT_TRUE(wait_for_irq(limit)) << "no interrupt within " << limit << " clocks";
    return axi_.clock() - begin;
  }
};
INSTANTIATE_UART_LINE(UartReceive);

TEST_P(UartReceive, EveryFormatAtTwoPercentOffTheRate) {
  const std::vector<unsigned> data = {0x00, 0x55, 0xFF, 0x96, 0x01, 0x80, 0x7E};
  for (const unsigned divisor : {1u, 3u}) {
    for (const double factor : {0.98, 1.0, 1.02}) {
      for (const UartFormat& format : all_uart_formats()) {
        configure(divisor, format);
        write(kFcr, kFifoOn | kFlushRx);
        sender_.bit_clocks = factor * static_cast<double>(bit_);
        for (const unsigned value : data) sender_.send(value, format);  // no gap
        finish_sending();
        for (const unsigned value : data) {
          EXPECT_EQ(read(kLsr) & ~kFifoError, kDr | kThre | kTemt) << format << " at " << factor;
          EXPECT_EQ(read(kRbr), value & format.mask()) << format << " at " << factor;
        }
        EXPECT_EQ(read(kLsr), kThre | kTemt);
      }
    }
  }
}

// The worst case of one character: the last sample is 9.5 bits after the edge, and must not leave its bit.
TEST_P(UartReceive, FourAndAHalfPercentOffIsStillRead) {
  for (const double factor : {0.955, 1.045}) {
    configure(27, {8, UartParity::kNone});
    sender_.bit_clocks = factor * static_cast<double>(bit_);
    for (const unsigned value : {0x00u, 0xFFu, 0xA5u, 0x80u}) {
      sender_.send(value, format_);
      sender_.bits(true, 2);
      finish_sending();
      EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
      EXPECT_EQ(read(kRbr), value);
    }
  }
}

TEST_P(UartReceive, SeventhToNinthSixteenthDecideABit) {
  configure(4);  // a sixteenth is 4 clocks
  // One of the three samples is wrong in every bit, with each position in turn.
  for (const double at : {6.5, 7.5, 8.5}) {
    const unsigned value = 0x2D;
    const double sixteenth = sender_.bit_clocks / 16;
    for (unsigned bit = 0; bit < 10; ++bit) {
      const bool level = bit == 0 ? false : bit == 9 ? true : (value >> (bit - 1) & 1u) != 0;
      sender_.level(level, at * sixteenth);
      sender_.level(!level, sixteenth);
      sender_.level(level, (15 - at) * sixteenth);
    }
    finish_sending();
    EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
    EXPECT_EQ(read(kRbr), value);
  }
}

TEST_P(UartReceive, AGlitchIsNoStartBit) {
  configure(4);
  for (const double sixteenths : {0.25, 1.0, 4.0, 6.0}) {
    sender_.bits(false, sixteenths / 16);
    sender_.bits(true, 2);
    finish_sending();
    EXPECT_EQ(read(kLsr), kThre | kTemt) << sixteenths;
    receive(0x3C);
    EXPECT_EQ(read(kLsr), kDr | kThre | kTemt) << sixteenths;
    EXPECT_EQ(read(kRbr), 0x3Cu);
  }
}

// The start bit begins in every clock around the one in which the receiver gives the glitch up.
TEST_P(UartReceive, ACharacterRightAfterAGlitchIsReceived) {
  configure(1);
  for (int high = 6; high <= 12; ++high) {
    sender_.level(false, 3);
    sender_.level(true, high);
    receive(0x3C);
    EXPECT_EQ(read(kLsr), kDr | kThre | kTemt) << high;
    EXPECT_EQ(read(kRbr), 0x3Cu) << high;
  }
}

TEST_P(UartReceive, ParityErrorsOfEveryKind) {
  for (const UartParity parity : kAllParities) {
    if (parity == UartParity::kNone) continue;
    for (const unsigned bits : {5u, 8u}) {
      configure(1, {bits, parity});
      write(kFcr, kFifoOn | kFlushRx);
      for (const unsigned value : {0x00u, 0x01u, 0x1Fu, 0x0Eu}) {
        const bool wrong = true;
        receive(value, wrong);
        EXPECT_EQ(read(kLsr), kFifoError | kPe | kDr | kThre | kTemt) << format_ << ", " << value;
        EXPECT_EQ(read(kRbr), value);
        receive(value);
        EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
        EXPECT_EQ(read(kRbr), value);
      }
    }
  }
}

TEST_P(UartReceive, MissingStopBitIsAFramingErrorAndTheNextCharacterIsRead) {
  configure(2);
  write(kFcr, kFifoOn);
  receive(0x7B, false, false);
  EXPECT_EQ(read(kLsr), kFifoError | kFe | kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0x7Bu);
  receive(0x00, false, true);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt) << "zero with a stop bit is no break";
  EXPECT_EQ(read(kRbr), 0x00u);
}

TEST_P(UartReceive, BreakIsOneZeroCharacterUntilTheLineIsHigh) {
  for (const UartFormat& format : {UartFormat{8, UartParity::kNone}, UartFormat{5, UartParity::kOdd, true}}) {
    configure(2, format);
    write(kFcr, kFifoOn | kFlushRx);
    sender_.bits(false, 60);
    while (!sender_.idle()) axi_.step();
    EXPECT_EQ(read(kLsr), kFifoError | kBi | kFe | kDr | kThre | kTemt) << format;
    EXPECT_EQ(read(kRbr), 0u);
    axi_.step(static_cast<int>(20 * bit_));
    EXPECT_EQ(read(kLsr), kThre | kTemt) << "nothing more";
    receive(0x15);
    EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
    EXPECT_EQ(read(kRbr), 0x15u);
  }
  // All bits low, but one: no break.
  configure(2, {8, UartParity::kMark});
  receive(0x00, true, false);
  EXPECT_EQ(read(kLsr) & (kBi | kFe), kBi | kFe);
  EXPECT_EQ(read(kRbr), 0u);
  receive(0x00, false, false);
  EXPECT_EQ(read(kLsr) & (kBi | kFe), kFe);
}

TEST_P(UartReceive, ALineThatIsLowAtResetIsNoCharacter) {
  dut_.rst_ni = 0;
  sender_.level(false, 1000);
  axi_.step(kResetCycles);
  dut_.rst_ni = 1;
  configure(1);
  finish_sending();
  EXPECT_EQ(read(kLsr), kThre | kTemt);
  receive(0x47);
  EXPECT_EQ(read(kRbr), 0x47u);
}

// Good, parity error, good, framing error, good: each shows its own errors when it is the oldest.
TEST_P(UartReceive, ErrorsTravelWithTheirCharacter) {
  configure(1, {8, UartParity::kEven});
  write(kFcr, kFifoOn);
  receive(0x01);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  receive(0x02, true);
  receive(0x03);
  receive(0x04, true, false);
  receive(0x05);
  const std::uint32_t good = kDr | kThre | kTemt;
  EXPECT_EQ(read(kLsr), kFifoError | good);
  EXPECT_EQ(read(kRbr), 0x01u);
  EXPECT_EQ(read(kLsr), kFifoError | kPe | good);
  EXPECT_EQ(read(kLsr), kFifoError | good) << "read errors are gone, one more waits";
  EXPECT_EQ(read(kRbr), 0x02u);
  EXPECT_EQ(read(kLsr), kFifoError | good);
  EXPECT_EQ(read(kRbr), 0x03u);
  EXPECT_EQ(read(kRbr), 0x04u);
  EXPECT_EQ(read(kLsr), kFifoError | kPe | kFe | good) << "errors wait for LSR, not for their character";
  EXPECT_EQ(read(kLsr), good);
  EXPECT_EQ(read(kRbr), 0x05u);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
}

TEST_P(UartReceive, FlushForgetsTheErrorsThatWait) {
  configure(1, {8, UartParity::kEven});
  write(kFcr, kFifoOn);
  receive(0x01);
  for (int i = 0; i < 3; ++i) receive(0x02, true);
  write(kFcr, kFifoOn | kFlushTx);
  EXPECT_EQ(read(kLsr), kFifoError | kDr | kThre | kTemt);
  write(kFcr, kFifoOn | kFlushRx);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
  receive(0x03);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
}

TEST_P(UartReceive, WithoutFifoThereIsNoFifoError) {
  configure(1, {8, UartParity::kEven});
  receive(0x41, true);
  EXPECT_EQ(read(kLsr), kPe | kDr | kThre | kTemt);
}

TEST_P(UartReceive, OverrunKeepsSixteenAndLosesTheNewest) {
  configure(1, {8, UartParity::kEven});
  write(kFcr, kFifoOn);
  std::vector<unsigned> sent(16);
  std::iota(sent.begin(), sent.end(), 0x20);
  for (const unsigned value : sent) receive(value);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  receive(0xEE, true);
  EXPECT_EQ(read(kLsr), kOe | kDr | kThre | kTemt) << "at once, and the errors of the lost one are lost with it";
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  EXPECT_EQ(drain(), sent);
}

TEST_P(UartReceive, WithoutFifoAnOverrunKeepsTheNewest) {
  configure(1, {8, UartParity::kEven});
  receive(0x41);
  receive(0x42, true);
  EXPECT_EQ(read(kLsr), kOe | kPe | kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0x42u);
  EXPECT_EQ(read(kLsr), kThre | kTemt);
}

// At whatever clock a read of LSR meets the overrun, exactly one read shows it.
TEST_P(UartReceive, AnErrorThatMeetsTheReadIsReportedOnce) {
  configure(1, {8, UartParity::kEven});
  bool first = false, second = false;
  receive(0x00);
  for (int offset = 0; offset < 40; ++offset) {
    sender_.send(0x41, format_, true);  // overrun and parity error: no FIFO
    axi_.step(11 * 16 - 20);
    read(kLsr);
    axi_.step(offset);
    const std::uint32_t early = read(kLsr);
    finish_sending();
    const std::uint32_t late = read(kLsr);
    for (const std::uint32_t flag : {kOe, kPe}) {
      EXPECT_EQ((early & flag) + (late & flag), flag) << "offset " << offset;
    }
    first |= (early & kOe) != 0;
    second |= (late & kOe) != 0;
  }
  EXPECT_TRUE(first && second) << "the sweep did not cross the event";
}

TEST_P(UartReceive, DataInterruptAtTheTriggerLevel) {
  static constexpr unsigned kLevels[] = {1, 4, 8, 14};
  configure(1);
  write(kIer, kIerRx);
  for (unsigned code = 0; code < 4; ++code) {
    write(kFcr, kFifoOn | kFlushRx | code << 6);
    for (unsigned level = 1; level <= 16; ++level) {
      receive(level);
      EXPECT_EQ(read(kIir), level >= kLevels[code] ? 0xC4u : 0xC1u) << "trigger " << kLevels[code];
      EXPECT_EQ(dut_.irq_o, level >= kLevels[code]);
    }
    for (unsigned level = 15; level > 0; --level) {
      EXPECT_EQ(read(kRbr), 16 - level);
      EXPECT_EQ(read(kIir), level >= kLevels[code] ? 0xC4u : 0xC1u) << "trigger " << kLevels[code];
      EXPECT_EQ(dut_.irq_o, level >= kLevels[code]);
    }
    read(kRbr);
  }
  write(kFcr, 0);
  receive(0x31);
  EXPECT_EQ(read(kIir), 0x04u) << "16450";
  EXPECT_EQ(read(kRbr), 0x31u);
  EXPECT_EQ(read(kIir), 0x01u);
}

// From the middle of the last stop bit; a stop bit more or less is a tenth of a character.
TEST_P(UartReceive, TimeoutAfterFourCharacterTimes) {
  for (const UartFormat& format : {UartFormat{8}, UartFormat{5, UartParity::kNone, true}, UartFormat{5},
                                   UartFormat{7, UartParity::kOdd, true}, UartFormat{8, UartParity::kMark}}) {
    for (const unsigned divisor : {1u, 5u}) {
      configure(divisor, format);
      write(kFcr, kFifoOn | kFlushRx | 0xC0);
      write(kIer, kIerRx);
      receive(0x11);  // ends half a bit after the stop bits
      const double bit = static_cast<double>(bit_);
      const double since_delivery = (format.stop_bits() - 0.5 + 0.5) * bit + 8;
      EXPECT_NEAR(static_cast<double>(clocks_to_irq(50 * bit_)), 4 * format.bits() * bit - since_delivery,
                  0.1 * bit + 8)
          << format;
      EXPECT_EQ(read(kIir), 0xCCu);
      receive(0x12);
      EXPECT_EQ(read(kIir), 0xCCu) << "only reading RBR ends it";
      EXPECT_EQ(read(kRbr), 0x11u);
      EXPECT_EQ(read(kIir), 0xC1u);
      // One more waits, and times out from that read on.
      EXPECT_NEAR(static_cast<double>(clocks_to_irq(50 * bit_)), 4 * format.bits() * bit, 0.1 * bit + 20) << format;
      EXPECT_EQ(read(kIir), 0xCCu);
      EXPECT_EQ(read(kRbr), 0x12u);
      EXPECT_FALSE(wait_for_irq(100 * bit_)) << "an empty FIFO does not time out";
    }
  }
}

TEST_P(UartReceive, ACharacterRestartsTheTimeout) {
  configure(1);
  write(kFcr, kFifoOn | 0xC0);
  write(kIer, kIerRx);
  for (int i = 0; i < 5; ++i) {
    receive(0x31);
    EXPECT_FALSE(wait_for_irq(28 * bit_)) << "three character times without one, and one that comes";
  }
  EXPECT_TRUE(wait_for_irq(20 * bit_));
}

TEST_P(UartReceive, AReadRestartsTheTimeout) {
  configure(1);
  write(kFcr, kFifoOn | 0xC0);
  write(kIer, kIerRx);
  for (int i = 0; i < 5; ++i) receive(0x31);
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(wait_for_irq(35 * bit_));
    EXPECT_EQ(read(kRbr), 0x31u);
  }
  EXPECT_TRUE(wait_for_irq(42 * bit_));
}

TEST_P(UartReceive, AFlushEndsTheTimeout) {
  configure(1);
  write(kFcr, kFifoOn | 0xC0);
  write(kIer, kIerRx);
  receive(0x31);
  EXPECT_TRUE(wait_for_irq(50 * bit_));
  write(kFcr, kFifoOn | kFlushRx | 0xC0);
  axi_.step(3);
  EXPECT_FALSE(dut_.irq_o);
  EXPECT_EQ(read(kIir), 0xC1u);
}

TEST_P(UartReceive, WithoutFifoThereIsNoTimeout) {
  configure(1);
  receive(0x31);
  axi_.step(100 * 16);
  write(kIer, kIerRx);
  EXPECT_EQ(read(kIir), 0x04u);
}

TEST_P(UartReceive, ReadingTakesExactlyOneCharacter) {
  configure(1);
  write(kFcr, kFifoOn);
  std::vector<unsigned> sent(16);
  std::iota(sent.begin(), sent.end(), 0xA0);
  for (const unsigned value : sent) sender_.send(value, format_);
  finish_sending();
  for (int i = 0; i < 16; ++i) axi_.post_read(kRbr);
  axi_.drain();
  for (const unsigned value : sent) {
    EXPECT_EQ(axi_.read_answers.front(), (AxiReadResult{AxiResp::kOkay, value}));
    axi_.read_answers.pop_front();
  }
  EXPECT_EQ(read(kLsr), kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0u);
}

// The same over every way to stall the bus.
class UartReceiveOverTheBus : public UartReceive {};
INSTANTIATE_AXI_STALLS(UartReceiveOverTheBus);

TEST_P(UartReceiveOverTheBus, CharactersAndErrorsAreReadOnce) {
  configure(1, {8, UartParity::kEven});
  write(kFcr, kFifoOn);
  for (unsigned i = 0; i < 16; ++i) {
    sender_.send(i, format_, i % 3 == 2);
    sender_.bits(true, 0.1 * i);
  }
  finish_sending();
  for (unsigned i = 0; i < 16; ++i) {
    EXPECT_EQ(read(kLsr) & (kDr | kPe), i % 3 == 2 ? kDr | kPe : kDr) << i;
    EXPECT_EQ(read(kLsr) & (kDr | kPe), kDr) << i;
    EXPECT_EQ(read(kRbr), i);
  }
  EXPECT_EQ(read(kLsr), kThre | kTemt);
}

}  // namespace
}  // namespace armature::test
