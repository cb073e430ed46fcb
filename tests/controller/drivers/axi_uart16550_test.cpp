#include "controller/drivers/axi_uart16550.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "tests/controller/support/mock_register_bus.hpp"
#include "tests/rtl/uart_model.hpp"

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
constexpr std::uint32_t kDr = 0x01, kOverrun = 0x02, kParityError = 0x04, kFraming = 0x08, kBreak = 0x10, kThre = 0x20,
                        kTemt = 0x40;

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

// The registers of a 16550A; whatever is sent is gone at once.
class ModelBus final : public RegisterBus {
 public:
  std::uint32_t read32(RegAddr addr) noexcept override {
    if (addr == kRbr) return model.read_rbr();
    if (addr == kIir) return model.read_iir();
    if (addr == kLsr) return model.read_lsr();
    return addr == kLcr ? lcr_ : 0;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    if (addr == kLcr) lcr_ = value;
    if (addr == kIir) model.write_fcr(value);
    if ((lcr_ & kDlab) != 0) return;
    if (addr == kUartIer) model.write_ier(value);
    if (addr == kRbr) sent.push_back(model.transmit({value}).front());
  }
  Interrupts wait_for_interrupt(Interrupts) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return Cycles{}; }
  void charge(Work, std::int64_t) noexcept override {}

  test::UartModel model;
  std::vector<std::uint32_t> sent;

 private:
  std::uint32_t lcr_ = 0;
};

class AxiUart16550OnModel : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(uart_.configure(115'200, {})); }
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
    EXPECT_FALSE(bus_.model.irq()) << i;
    bus_.model.arrive({i, 0});
  }
  EXPECT_TRUE(bus_.model.irq());
  EXPECT_EQ(uart_.pending(), Source::kReceived);
  AxiUart16550::Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_FALSE(bus_.model.irq());
}

TEST_F(AxiUart16550OnModel, AFewBytesComeWithTheTimeout) {
  uart_.enable({.received = true});
  bus_.model.arrive({'a', 0});
  bus_.model.four_characters_pass();
  EXPECT_EQ(uart_.pending(), Source::kReceiveTimeout);
  AxiUart16550::Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre('a'));
  EXPECT_EQ(uart_.pending(), Source::kNone);
}

TEST_F(AxiUart16550OnModel, EachErrorComesWithItsOwnCharacter) {
  using Errors = AxiUart16550::Errors;
  bus_.model.arrive({'a', 0});
  bus_.model.arrive({'b', kParityError});
  bus_.model.arrive({'c', kFraming});
  bus_.model.arrive({0, kBreak | kFraming});
  bus_.model.arrive({'d', 0});
  Errors errors;
  EXPECT_THAT(receive(errors), ElementsAre('a', 'b'));
  EXPECT_EQ(errors, Errors{.parity = true});
  EXPECT_TRUE(uart_.sent()) << "a look at the status between two calls loses no error";
  EXPECT_THAT(receive(errors), ElementsAre('c'));
  EXPECT_EQ(errors, Errors{.framing = true});
  EXPECT_THAT(receive(errors), ElementsAre(0));
  EXPECT_EQ(errors, (Errors{.framing = true, .line_break = true}));
  EXPECT_THAT(receive(errors), ElementsAre('d'));
  EXPECT_FALSE(errors.any());
}

TEST_F(AxiUart16550OnModel, AnOverrunIsToldOnceAndKeepsTheOldCharacters) {
  for (std::uint32_t i = 0; i < 18; ++i) bus_.model.arrive({i, 0});
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
  EXPECT_THAT(bus_.sent, ElementsAre('o', 'k'));
}

TEST_F(AxiUart16550OnModel, ConfiguringAgainForgetsWhatWasThere) {
  bus_.model.arrive({'x', kParityError});
  EXPECT_TRUE(uart_.sent());
  ASSERT_TRUE(uart_.configure(9'600, {}));
  AxiUart16550::Errors errors;
  EXPECT_TRUE(receive(errors).empty());
  EXPECT_FALSE(errors.any());
}

}  // namespace
}  // namespace armature
