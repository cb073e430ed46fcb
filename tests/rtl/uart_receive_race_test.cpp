// axi_uart16550: reception in the clock of a register access, and while software changes the divisor or the format.
#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using namespace uart;

class UartReceiveRace : public UartTest {};
INSTANTIATE_UART_LINE(UartReceiveRace);

// The read of the only character may meet the arrival of the next one in any clock. The next one keeps its error.
TEST_P(UartReceiveRace, AReadInTheClockOfAnArrivalKeepsTheErrorOfTheArrival) {
  configure(1);
  write(kFcr, kFifoOn);
  bool first = false, second = false;
  for (int offset = 0; offset < 40; ++offset) {
    receive(0x41);
    sender_.send(0x42, format_, false, false);  // framing error
    axi_.step(10 * 16 - 20 + offset);
    EXPECT_EQ(read(kRbr), 0x41u) << "offset " << offset;
    const bool arrived = (read(kLsr) & kDr) != 0;
    first |= !arrived;
    second |= arrived;
    finish_sending();
    if (!arrived) {
      EXPECT_EQ(read(kLsr), kFifoError | kFe | kDr | kThre | kTemt) << "offset " << offset;
    }
    EXPECT_EQ(read(kRbr), 0x42u) << "offset " << offset;
    EXPECT_EQ(read(kLsr), kThre | kTemt) << "no error is left, offset " << offset;
  }
  EXPECT_TRUE(first && second) << "the sweep did not cross the arrival";
}

// A long tick must not be waited for: the next one comes after the new divisor.
TEST_P(UartReceiveRace, ANewDivisorTakesEffectInTheCharacterInProgress) {
  configure(0xFFFF);
  sender_.level(false, 50);
  axi_.step(100);  // the receiver waits for the middle of a start bit, for 9 ticks of 65535 clocks
  configure(1);
  axi_.step(100);
  receive(0x3C);
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0x3Cu);
}

TEST_P(UartReceiveRace, ANewDivisorTakesEffectInTheRunningTimeout) {
  configure(1);
  write(kFcr, kFifoOn | 0xC0);
  write(kIer, kIerRx);
  receive(0x31);
  configure(0xFFFF);
  axi_.step(100);
  EXPECT_FALSE(dut_.irq_o);
  configure(1);
  EXPECT_TRUE(wait_for_irq(41 * bit_));
  EXPECT_EQ(read(kIir), 0xCCu);
}

TEST_P(UartReceiveRace, ACharacterKeepsTheFormatItBeganWith) {
  const UartFormat first{8, UartParity::kEven}, second{5, UartParity::kNone};
  configure(2, first);
  sender_.send(0xE9, first);
  axi_.step(static_cast<int>(3 * bit_));
  write(kLcr, second.lcr());
  finish_sending();
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0xE9u);
  configure(2, second);
  sender_.send(0x16, second);
  axi_.step(static_cast<int>(3 * bit_));
  write(kLcr, first.lcr());
  finish_sending();
  EXPECT_EQ(read(kLsr), kDr | kThre | kTemt);
  EXPECT_EQ(read(kRbr), 0x16u);
}

}  // namespace
}  // namespace armature::test
