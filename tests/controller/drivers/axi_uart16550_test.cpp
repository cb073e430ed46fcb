#include "controller/drivers/axi_uart16550.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "cosim/model/slot.hpp"
#include "cosim/model/uart/axi_uart16550.hpp"
#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::ElementsAre;
using testing::InSequence;
using testing::Return;
using testing::StrictMock;
using Parity = AxiUart16550::Parity;
using Source = AxiUart16550::Source;

// From the AXI UART 16550 v2.0 register description, not from the generated header.
constexpr RegAddr kBase{0x43C0'0000};
constexpr RegAddr kRbr{0x43C0'1000}, kUartIer{0x43C0'1004}, kIir{0x43C0'1008}, kLcr{0x43C0'100C}, kLsr{0x43C0'1014};
constexpr std::uint32_t kDlab = 0x80;
constexpr std::uint32_t kDr = 0x01, kOverrun = 0x02, kParityError = 0x04, kThre = 0x20, kTemt = 0x40;

class AxiUart16550Driver : public testing::Test {
 protected:
  void expect_configuration(std::uint32_t lcr, std::uint32_t high, std::uint32_t low) {
    EXPECT_CALL(bus_, write32(kUartIer, 0u));
    EXPECT_CALL(bus_, write32(kLcr, kDlab | lcr));
    EXPECT_CALL(bus_, write32(kRbr, 0xFFu));  // DLL, so that the divisor is never 1 on the way
    EXPECT_CALL(bus_, write32(kUartIer, high));
    EXPECT_CALL(bus_, write32(kRbr, low));
    EXPECT_CALL(bus_, write32(kLcr, lcr));
    EXPECT_CALL(bus_, write32(kIir, 0x87u));  // FCR: on, both flushed, trigger 8
    EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kThre | kTemt));
  }

  StrictMock<test::MockRegisterBus> bus_;
  AxiUart16550 uart_{bus_, kBase};
  const InSequence in_order_;
};

TEST_F(AxiUart16550Driver, ConfiguresRateFormatAndFifosWithInterruptsOff) {
  expect_configuration(0x03, 0, 27);  // 50 MHz / (16 * 27) = 115741
  EXPECT_TRUE(uart_.configure(115'200, {}));
}

TEST_F(AxiUart16550Driver, PutsEveryFormatIntoTheLineControl) {
  struct Case {
    AxiUart16550::Format format;
    std::uint32_t lcr;
  };
  for (const auto& [format, lcr] : {Case{{5, Parity::kNone, true}, 0x04},
                                    {{6, Parity::kOdd, false}, 0x09},
                                    {{7, Parity::kEven, true}, 0x1E},
                                    {{8, Parity::kMark, false}, 0x2B},
                                    {{8, Parity::kSpace, false}, 0x3B}}) {
    expect_configuration(lcr, 5'208 >> 8, 5'208 & 0xFF);  // 600 baud
    EXPECT_TRUE(uart_.configure(600, format));
  }
}

TEST_F(AxiUart16550Driver, RefusesARateOrALengthThatItCannotKeepAndTouchesNothing) {
  EXPECT_FALSE(uart_.configure(921'600, {}));
  EXPECT_FALSE(uart_.configure(9'600, {.data_bits = 9}));
  EXPECT_FALSE(uart_.configure(9'600, {.data_bits = 4}));
}

TEST(AxiUart16550Divisor, IsTheNearestOneOrNoneBeyondThreePercent) {
  EXPECT_EQ(AxiUart16550::divisor(115'200), 27u);
  EXPECT_EQ(AxiUart16550::divisor(9'600), 326u);     // 325.52
  EXPECT_EQ(AxiUart16550::divisor(3'125'000), 1u);   // exact
  EXPECT_EQ(AxiUart16550::divisor(3'033'981), 1u);   // 3.0 % too fast
  EXPECT_EQ(AxiUart16550::divisor(3'000'000), 0u);   // 4.2 %
  EXPECT_EQ(AxiUart16550::divisor(921'600), 0u);     // 3.39
  EXPECT_EQ(AxiUart16550::divisor(1'000'000), 0u);   // 3.125
  EXPECT_EQ(AxiUart16550::divisor(10'000'000), 0u);  // 0.31
  EXPECT_EQ(AxiUart16550::divisor(48), 65'104u);
  EXPECT_EQ(AxiUart16550::divisor(47), 0u);  // 66489 does not fit
  EXPECT_EQ(AxiUart16550::divisor(0), 0u);
  EXPECT_EQ(AxiUart16550::divisor(-115'200), 0u);
}

TEST_F(AxiUart16550Driver, SendsAFifoFullAtMostAndOnlyIntoAnEmptyOne) {
  std::array<std::uint8_t, 20> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(0x40 + i);
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kThre));
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_CALL(bus_, write32(kRbr, 0x40 + i));
  EXPECT_EQ(uart_.send(bytes), 16u);
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr));
  EXPECT_EQ(uart_.send(bytes), 0u);
  EXPECT_EQ(uart_.send({}), 0u);
}

TEST_F(AxiUart16550Driver, IsSentWhenTheShiftRegisterIsEmptyToo) {
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kThre)).WillOnce(Return(kThre | kTemt));
  EXPECT_FALSE(uart_.sent());
  EXPECT_TRUE(uart_.sent());
}

TEST_F(AxiUart16550Driver, ReceivesUntilNothingWaits) {
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr));
  EXPECT_CALL(bus_, read32(kRbr)).WillOnce(Return(0x55u));
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr | kThre));
  EXPECT_CALL(bus_, read32(kRbr)).WillOnce(Return(0xAAu));
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kThre));
  std::array<std::uint8_t, 8> bytes{};
  const auto received = uart_.receive(bytes);
  EXPECT_EQ(received.count, 2u);
  EXPECT_EQ(bytes[0], 0x55);
  EXPECT_EQ(bytes[1], 0xAA);
  EXPECT_FALSE(received.errors.any());
}

TEST_F(AxiUart16550Driver, AFullBufferLeavesTheRestInTheFifo) {
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr));
  EXPECT_CALL(bus_, read32(kRbr)).WillOnce(Return(1u));
  std::array<std::uint8_t, 1> byte{};
  EXPECT_EQ(uart_.receive(byte).count, 1u);
  EXPECT_EQ(uart_.receive({}).count, 0u);
}

TEST_F(AxiUart16550Driver, KeepsTheErrorsThatSendHasMetForTheirCharacter) {
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr | kParityError | kOverrun));
  const std::array<std::uint8_t, 1> byte{1};
  EXPECT_EQ(uart_.send(byte), 0u);
  EXPECT_CALL(bus_, read32(kLsr)).WillOnce(Return(kDr));  // cleared by the read before
  EXPECT_CALL(bus_, read32(kRbr)).WillOnce(Return(0x7Fu));
  std::array<std::uint8_t, 4> bytes{};
  const auto received = uart_.receive(bytes);
  EXPECT_EQ(received.count, 1u);
  EXPECT_EQ(received.errors, (AxiUart16550::Errors{.overrun = true, .parity = true}));
}

TEST_F(AxiUart16550Driver, EnablesInterruptsOneByOne) {
  EXPECT_CALL(bus_, write32(kUartIer, 1u));
  uart_.enable({.received = true});
  EXPECT_CALL(bus_, write32(kUartIer, 2u));
  uart_.enable({.send_empty = true});
  EXPECT_CALL(bus_, write32(kUartIer, 4u));
  uart_.enable({.line_status = true});
  EXPECT_CALL(bus_, write32(kUartIer, 0u));
  uart_.enable({});
}

TEST_F(AxiUart16550Driver, NamesThePendingSourceWithoutTheFifoBits) {
  EXPECT_CALL(bus_, read32(kIir)).WillOnce(Return(0xC1u)).WillOnce(Return(0xCCu)).WillOnce(Return(0xC6u));
  EXPECT_EQ(uart_.pending(), Source::kNone);
  EXPECT_EQ(uart_.pending(), Source::kReceiveTimeout);
  EXPECT_EQ(uart_.pending(), Source::kLineStatus);
}

// The registers of the model of the logic (cosim/model), and the far end of its line. An access takes one clock edge.
class ModelBus final : public RegisterBus {
 public:
  std::uint32_t read32(RegAddr addr) noexcept override {
    return edge({.read = true, .raddr = static_cast<std::uint16_t>(addr.value - kBase.value)}).rdata;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    edge({.write = true,
          .waddr = static_cast<std::uint16_t>(addr.value - kBase.value),
          .wdata = value,
          .wstrb = 0b0001});
  }
  Interrupts wait_for_interrupt(Interrupts) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return now_; }
  void charge(Work, std::int64_t) noexcept override {}

  // Runs for so many clock edges.
  void pass(std::int64_t edges) {
    for (const Cycles end = now_ + Cycles{edges}; now_ < end;) {
      const Cycles next = std::max(uart_.wakes_at(now_, pins_), now_ + Cycles{1});
      now_ = std::min(next, end) - Cycles{1};
      edge({});
    }
  }
  // The far end sends these bits, from the start bit on, and then a high line for a bit.
  void receive(std::initializer_list<int> bits) {
    for (const int bit : bits) send_bit(bit != 0);
    send_bit(true);
  }
  // A character of 8N1.
  void receive(std::uint32_t data) {
    send_bit(false);
    for (int i = 0; i < 8; ++i) send_bit((data >> i & 1u) != 0);
    send_bit(true);
  }
  [[nodiscard]] bool irq() const { return uart_.block().irq(); }
  [[nodiscard]] bool txd() const { return uart_.block().txd(); }

  static constexpr std::int64_t kBit = std::int64_t{27} * 16;  // 115200 baud

 private:
  cosim::model::Answer edge(const cosim::model::Strobes& access) {
    now_ += Cycles{1};
    return uart_.edge(now_, pins_, access);
  }
  void send_bit(bool level) {
    pins_.rxd = level;
    pass(kBit);
  }

  cosim::model::Slot<cosim::model::AxiUart16550, cosim::model::UartInputs> uart_;
  cosim::model::UartInputs pins_;
  Cycles now_{};
};

class AxiUart16550OnModel : public testing::Test {
 protected:
  void SetUp() override {
    bus_.pass(10);
    ASSERT_TRUE(uart_.configure(115'200, {}));
  }
  std::vector<std::uint8_t> receive(AxiUart16550::Errors& errors) {
    std::array<std::uint8_t, 32> bytes{};
    const auto received = uart_.receive(bytes);
    errors = received.errors;
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(received.count)};
  }
  ModelBus bus_;
  AxiUart16550 uart_{bus_, kBase};
};

TEST_F(AxiUart16550OnModel, InterruptsAtTheEighthByteAndUntilTheyAreRead) {
  uart_.enable({.received = true});
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_FALSE(bus_.irq()) << i;
    bus_.receive(i);
  }
  EXPECT_TRUE(bus_.irq());
  EXPECT_EQ(uart_.pending(), Source::kReceived);
  AxiUart16550::Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_FALSE(bus_.irq());
}

TEST_F(AxiUart16550OnModel, AFewBytesComeWithTheTimeout) {
  uart_.enable({.received = true});
  bus_.receive('a');
  bus_.pass(39 * ModelBus::kBit);
  EXPECT_EQ(uart_.pending(), Source::kNone);
  bus_.pass(2 * ModelBus::kBit);
  EXPECT_EQ(uart_.pending(), Source::kReceiveTimeout);
  AxiUart16550::Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre('a'));
  EXPECT_EQ(uart_.pending(), Source::kNone);
}

TEST_F(AxiUart16550OnModel, EachErrorComesWithItsOwnCharacter) {
  using Errors = AxiUart16550::Errors;
  ASSERT_TRUE(uart_.configure(115'200, {.data_bits = 5, .parity = Parity::kEven}));
  bus_.receive({0, 1, 0, 0, 0, 0, 1, 1});  // start, 5 bits from the lowest, parity, stop
  bus_.receive({0, 0, 1, 0, 0, 0, 0, 1});  // wrong parity
  bus_.receive({0, 1, 1, 0, 0, 0, 0, 0});  // no stop bit
  bus_.receive({0, 0, 0, 0, 0, 0, 0, 0});  // break
  bus_.receive({0, 0, 0, 1, 0, 0, 1, 1});
  Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre(1, 2));
  EXPECT_EQ(errors, Errors{.parity = true});
  EXPECT_TRUE(uart_.sent()) << "a look at the status between two calls loses no error";
  EXPECT_THAT(receive(errors), ElementsAre(3));
  EXPECT_EQ(errors, Errors{.framing = true});
  EXPECT_THAT(receive(errors), ElementsAre(0));
  EXPECT_EQ(errors, (Errors{.framing = true, .line_break = true}));
  EXPECT_THAT(receive(errors), ElementsAre(4));
  EXPECT_FALSE(errors.any());
}

TEST_F(AxiUart16550OnModel, AnOverrunIsToldOnceAndKeepsTheOldCharacters) {
  for (std::uint32_t i = 0; i < 18; ++i) bus_.receive(i);
  AxiUart16550::Errors errors;
  EXPECT_EQ(receive(errors).size(), 16u);
  EXPECT_EQ(errors, AxiUart16550::Errors{.overrun = true});
  EXPECT_TRUE(receive(errors).empty());
  EXPECT_FALSE(errors.any());
}

TEST_F(AxiUart16550OnModel, EnablingSendEmptyAsksForBytesAtOnce) {
  uart_.enable({.send_empty = true});
  EXPECT_EQ(uart_.pending(), Source::kSendEmpty);
  EXPECT_EQ(uart_.pending(), Source::kNone) << "acknowledged by the first look";
  const std::array<std::uint8_t, 2> bytes{'o', 'k'};
  EXPECT_EQ(uart_.send(bytes), 2u);
  std::vector<std::uint8_t> sent(2);
  for (std::uint8_t& byte : sent) {
    for (std::int64_t edges = 0; bus_.txd() && edges < 2 * ModelBus::kBit; ++edges) bus_.pass(1);
    bus_.pass(ModelBus::kBit / 2);
    for (int i = 0; i < 8; ++i) {
      bus_.pass(ModelBus::kBit);
      byte = static_cast<std::uint8_t>(byte | (bus_.txd() ? 1u << i : 0u));
    }
    bus_.pass(ModelBus::kBit);
  }
  EXPECT_THAT(sent, ElementsAre('o', 'k'));
  bus_.pass(ModelBus::kBit);
  EXPECT_TRUE(uart_.sent());
}

TEST_F(AxiUart16550OnModel, ConfiguringAgainForgetsWhatWasThere) {
  bus_.receive({0, 1, 1, 1, 1, 0, 0, 0, 0, 0});  // no stop bit
  EXPECT_TRUE(uart_.sent());
  ASSERT_TRUE(uart_.configure(9'600, {}));
  AxiUart16550::Errors errors;
  EXPECT_TRUE(receive(errors).empty());
  EXPECT_FALSE(errors.any());
}

}  // namespace
}  // namespace armature
