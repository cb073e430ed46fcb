// axi_uart16550: what it puts on the line, clock by clock, and the transmit FIFO.
#include <numeric>

#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

class UartTransmit : public UartTest {
 protected:
  // The line as an ideal sender with the same bit time drives it, from the first falling edge on.
  std::vector<LineSegment> ideal(const std::vector<unsigned>& data) const {
    LineSender sender;
    LineReceiver segments;
    sender.bit_clocks = static_cast<double>(bit_);
    for (const unsigned value : data) sender.send(value, format_);
    while (!sender.idle()) segments.clock(sender.clock());
    return segments.segments;
  }
  void expect_line(const std::vector<LineSegment>& expected) {
    std::vector<LineSegment> line = receiver_.segments;
    ASSERT_GE(line.size(), 2u);
    line.erase(line.begin());  // idle
    ASSERT_EQ(line.size(), expected.size());
    // The last high segment also holds the idle time that follows.
    for (std::size_t i = 0; i + 1 < line.size(); ++i) EXPECT_EQ(line[i], expected[i]) << format_ << ", segment " << i;
  }
};
INSTANTIATE_UART_LINE(UartTransmit);

TEST_P(UartTransmit, EveryFormatIsExactOnTheLineWithoutGaps) {
  const std::vector<unsigned> data = {0x55, 0xFF, 0x00, 0x96, 0x01};
  for (const UartFormat& format : all_uart_formats()) {
    axi_.step(4);
    configure(2, format);
    write(kFcr, kFifoOn | kFlushTx);
    receiver_.segments.clear();
    axi_.step(10);
    transmit(data);
    finish_transmitting();
    expect_line(ideal(data));
  }
}

TEST_P(UartTransmit, ABitIsSixteenDivisorsLong) {
  for (const unsigned divisor : {1u, 2u, 3u, 27u, 163u, 255u, 256u, 300u}) {
    configure(divisor);
    write(kFcr, kFifoOn);
    receiver_.segments.clear();
    axi_.step(10);
    write(kThr, 0x55);
    finish_transmitting();
    expect_line(ideal({0x55}));
  }
}

// Nothing but the bytes of the low data bits, whatever the upper ones hold.
TEST_P(UartTransmit, ShortCharactersIgnoreTheUpperBits) {
  for (const unsigned bits : {5u, 6u, 7u}) {
    configure(1, {bits, UartParity::kEven});
    receiver_.characters.clear();
    write(kThr, 0xE0 | 0x13);
    finish_transmitting();
    ASSERT_EQ(receiver_.characters.size(), 1u);
    EXPECT_EQ(receiver_.characters[0].data, 0xF3u & format_.mask());
    EXPECT_EQ(receiver_.characters[0].parity, format_.parity_bit(0xF3));
  }
}

TEST_P(UartTransmit, FifoHoldsSixteenBesidesTheCharacterUnderWay) {
  configure(4);
  write(kFcr, kFifoOn);
  std::vector<unsigned> data(20);
  std::iota(data.begin(), data.end(), 0x41);
  transmit(data);
  EXPECT_EQ(read(kLsr), 0u);
  finish_transmitting();
  data.resize(17);
  EXPECT_EQ(receiver_.data(), data) << "the newest are lost";
}

TEST_P(UartTransmit, WithoutFifoAWriteReplacesTheWaitingCharacter) {
  configure(4);
  write(kThr, 0x31);
  axi_.step(4);
  EXPECT_EQ(read(kLsr), kThre) << "the first one is under way";
  write(kThr, 0x32);
  EXPECT_EQ(read(kLsr), 0u);
  write(kThr, 0x33);
  finish_transmitting();
  EXPECT_EQ(receiver_.data(), (std::vector<unsigned>{0x31, 0x33}));
}

// THRE rises with the start bit of the last character, TEMT with the end of its stop bit.
TEST_P(UartTransmit, EmptyFlagsFollowTheLine) {
  configure(8, {7, UartParity::kOdd, true});
  write(kFcr, kFifoOn);
  transmit({1, 2, 3});
  std::int64_t thre = 0, temt = 0;
  while (temt == 0) {
    const std::uint32_t lsr = read(kLsr);
    if (thre == 0 && (lsr & kThre) != 0) thre = receiver_.now();
    if ((lsr & kTemt) != 0) temt = receiver_.now();
  }
  ASSERT_EQ(receiver_.characters.size(), 3u);
  const std::int64_t last = receiver_.characters[2].start;
  EXPECT_NEAR(static_cast<double>(thre - last), 0, 12);
  EXPECT_NEAR(static_cast<double>(temt - last), format_.bits() * static_cast<double>(bit_), 12);
}

TEST_P(UartTransmit, FlushDropsWhatWaitsAndNotWhatIsUnderWay) {
  configure(2);
  write(kFcr, kFifoOn);
  transmit({0x61, 0x62, 0x63});
  write(kFcr, kFifoOn | kFlushRx);
  EXPECT_EQ(read(kLsr), 0u) << "the other flush";
  write(kFcr, kFifoOn | kFlushTx);
  EXPECT_EQ(read(kLsr), kThre);
  finish_transmitting();
  axi_.step(1000);
  EXPECT_EQ(receiver_.data(), std::vector<unsigned>{0x61});
}

TEST_P(UartTransmit, ACharacterKeepsTheFormatItBeganWith) {
  const UartFormat first{8, UartParity::kEven, true}, second{5, UartParity::kNone, false};
  configure(4, first);
  LineSender sender;
  LineReceiver expected;
  sender.bit_clocks = static_cast<double>(bit_);
  sender.send(0x69, first);
  sender.send(0x0B, second);
  while (!sender.idle()) expected.clock(sender.clock());
  receiver_.segments.clear();
  axi_.step(10);
  write(kThr, 0x69);
  axi_.step(100);
  write(kLcr, second.lcr());
  write(kThr, 0x0B);
  finish_transmitting();
  expect_line(expected.segments);
}

TEST_P(UartTransmit, BreakHoldsTheLineLowWhileItIsSet) {
  configure(2);
  write(kFcr, kFifoOn);
  write(kLcr, format_.lcr() | kBreakOn);
  axi_.step(5);
  EXPECT_FALSE(dut_.txd_o);
  write(kThr, 0xFF);
  for (int i = 0; i < 2000; ++i) {
    axi_.step();
    ASSERT_FALSE(dut_.txd_o);
  }
  EXPECT_EQ(read(kLsr), kThre | kTemt) << "the transmitter goes on behind the break";
  write(kLcr, format_.lcr());
  axi_.step(5);
  EXPECT_TRUE(dut_.txd_o);
  receiver_.characters.clear();
  axi_.step(500);
  write(kThr, 0x5C);
  finish_transmitting();
  EXPECT_EQ(receiver_.data(), std::vector<unsigned>{0x5C});
}

// A long tick must not be waited for: the next one comes after the new divisor.
TEST_P(UartTransmit, ANewDivisorTakesEffectAtOnce) {
  configure(0xFFFF);
  write(kThr, 0x00);
  axi_.step(100);
  configure(1);
  const std::int64_t begin = axi_.clock();
  finish_transmitting();
  EXPECT_LT(axi_.clock() - begin, 200);
}

}  // namespace
}  // namespace armature::test
