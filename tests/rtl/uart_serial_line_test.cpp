// The whole way of a byte: script, line, pins, RTL, driver, and back to the log. The driver is the controller's own,
// the line the one of the simulation.
#include <gmock/gmock.h>

#include <array>
#include <string>
#include <vector>

#include "controller/drivers/axi_uart16550.hpp"
#include "cosim/serial/serial_line.hpp"
#include "cosim/serial/serial_log.hpp"
#include "tests/rtl/uart_fixture.hpp"

namespace armature::test {
namespace {

using cosim::SerialDirection;
using cosim::SerialEvent;
using cosim::SerialFault;
using cosim::SerialFormat;
using cosim::SerialSendSpec;
using testing::ElementsAre;
using Errors = AxiUart16550::Errors;
using Parity = AxiUart16550::Parity;

// A core that reaches the block through its AXI4-Lite port.
template <class Axi>
class AxiBus final : public RegisterBus {
 public:
  explicit AxiBus(Axi& axi) : axi_{axi} {}
  std::uint32_t read32(RegAddr addr) noexcept override {
    const AxiReadResult result = axi_.read(addr.value);
    EXPECT_EQ(result.resp, AxiResp::kOkay);
    return result.data;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    EXPECT_EQ(axi_.write(addr.value, value), AxiResp::kOkay);
  }
  Interrupts wait_for_interrupt(Interrupts) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return Cycles{axi_.clock()}; }
  void charge(Work, std::int64_t) noexcept override {}

 private:
  Axi& axi_;
};

class UartSerialLine : public AxiStallTest<Vaxi_uart16550> {
 protected:
  static constexpr std::int32_t kBaud = 1'562'500;  // divisor 2: no error of its own

  void SetUp() override {
    dut_.rxd_i = 1;
    dut_.cts_ni = dut_.dsr_ni = dut_.dcd_ni = dut_.ri_ni = 1;
    AxiStallTest::SetUp();
    axi_.step(4);
  }

  void clock() override {
    const Cycles now{axi_.clock()};
    if (line_) {
      if (const auto next = line_->next_event(); next && *next <= now) line_->advance(now);
      dut_.rxd_i = line_->rxd();
    }
    tick();
    if (line_) line_->on_level(now + Cycles{1}, dut_.txd_o != 0);
  }

  // Both ends in this format. The script's times count from here.
  void connect(const SerialFormat& format, const AxiUart16550::Format& own, std::vector<SerialSendSpec> sends) {
    ASSERT_TRUE(uart_.configure(static_cast<std::int32_t>(format.baud), own));
    for (SerialSendSpec& send : sends) send.at_s += static_cast<double>(axi_.clock()) * 20e-9;
    line_.emplace(format, to_script(sends), [this](const SerialEvent& event) {
      (event.direction == SerialDirection::kTx ? from_uart_ : to_uart_).push_back(event);
    });
  }
  void connect(std::vector<SerialSendSpec> sends) { connect({.baud = kBaud}, {}, std::move(sends)); }

  struct Read {
    std::string bytes;
    std::vector<Errors> errors;  // of every call that told one
  };
  // Receives and discards nothing until `clocks` have passed without anything coming.
  Read read_all(std::int64_t clocks = 3'000) {
    Read all;
    for (std::int64_t quiet = axi_.clock(); axi_.clock() - quiet < clocks;) {
      std::array<std::uint8_t, 16> bytes{};
      const auto received = uart_.receive(bytes);
      all.bytes.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(received.count));
      if (received.errors.any()) all.errors.push_back(received.errors);
      if (received.count > 0) quiet = axi_.clock();
      axi_.step(20);
    }
    return all;
  }

  void send_all(const std::string& text) {
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    for (std::size_t done = 0; done < bytes.size();) done += uart_.send(std::span{bytes}.subspan(done));
    while (!uart_.sent()) axi_.step();
    axi_.step(200);
  }

  [[nodiscard]] std::string sent_text() const {
    std::string text;
    for (const SerialEvent& event : from_uart_) text += static_cast<char>(event.byte);
    return text;
  }

  AxiBus<AxiLiteDriver<Vaxi_uart16550>> bus_{axi_};
  AxiUart16550 uart_{bus_, {0}};  // the block alone: no address above its own
  std::optional<cosim::SerialLine> line_;
  std::vector<SerialEvent> to_uart_, from_uart_;
};
INSTANTIATE_UART_LINE(UartSerialLine);

SerialSendSpec bytes(const std::string& text, double baud_error_percent = 0, SerialFault fault = SerialFault::kNone) {
  SerialSendSpec send;
  send.bytes = text;
  send.baud_error_percent = baud_error_percent;
  send.fault = fault;
  return send;
}

const std::string kText = "The quick brown fox\x7F\x80\xFF\x55\xAA" + std::string(2, '\0');

TEST_P(UartSerialLine, CarriesATextBothWaysInEveryFormat) {
  const Parity parities[] = {Parity::kNone, Parity::kEven, Parity::kOdd, Parity::kMark, Parity::kSpace};
  const cosim::SerialParity line_parities[] = {cosim::SerialParity::kNone, cosim::SerialParity::kEven,
                                               cosim::SerialParity::kOdd, cosim::SerialParity::kMark,
                                               cosim::SerialParity::kSpace};
  for (const int bits : {5, 6, 7, 8}) {
    for (std::size_t parity = 0; parity < std::size(parities); ++parity) {
      for (const bool long_stop : {false, true}) {
        SCOPED_TRACE(testing::Message() << bits << " bits, parity " << parity << ", long stop " << long_stop);
        std::string text = "0123456789:;<=>?@";
        for (char& c : text) c = static_cast<char>(c & ((1 << bits) - 1));
        from_uart_.clear();
        const SerialFormat format{.baud = kBaud,
                                  .data_bits = bits,
                                  .parity = line_parities[parity],
                                  .stop_half_bits = !long_stop  ? 2
                                                    : bits == 5 ? 3
                                                                : 4};
        connect(format, {static_cast<std::uint8_t>(bits), parities[parity], long_stop}, {bytes(text)});
        const Read read = read_all(1'000);
        EXPECT_EQ(read.bytes, text);
        EXPECT_TRUE(read.errors.empty());
        send_all(text);
        EXPECT_EQ(sent_text(), text);
        for (const SerialEvent& event : from_uart_) EXPECT_FALSE(event.has_error());
      }
    }
  }
}

// 115200 is 0.47 % slower than what divisor 27 gives; the line adds its own error to that.
TEST_P(UartSerialLine, AFarEndTwoPercentOffIsStillUnderstood) {
  for (const double percent : {-2.0, 2.0}) {
    connect({.baud = 115'200}, {}, {bytes(kText, percent)});
    const Read read = read_all(20'000);
    EXPECT_EQ(read.bytes, kText) << percent;
    EXPECT_TRUE(read.errors.empty()) << percent;
  }
}

// The stop bit of a character of ten bits is sampled 9.5 bits after its start: 8 % fast is three quarters of a bit.
TEST_P(UartSerialLine, AFarEndEightPercentOffIsNot) {
  for (const double percent : {-8.0, 8.0}) {
    connect({.baud = 115'200}, {}, {bytes(kText, percent)});
    EXPECT_NE(read_all(20'000).bytes, kText) << percent;
  }
}

TEST_P(UartSerialLine, AMissingStopBitIsAFramingErrorOfThatCharacterAlone) {
  connect({bytes("ok"), bytes("A", 0, SerialFault::kFraming), bytes("fine")});
  const Read read = read_all();
  EXPECT_EQ(read.bytes, "okAfine");
  EXPECT_THAT(read.errors, ElementsAre(Errors{.framing = true}));
}

TEST_P(UartSerialLine, AWrongParityBitIsAParityErrorOfThatCharacterAlone) {
  connect({.baud = kBaud, .parity = cosim::SerialParity::kEven}, {.parity = Parity::kEven},
          {bytes("ok"), bytes("A", 0, SerialFault::kParity), bytes("fine")});
  const Read read = read_all();
  EXPECT_EQ(read.bytes, "okAfine");
  EXPECT_THAT(read.errors, ElementsAre(Errors{.parity = true}));
}

TEST_P(UartSerialLine, ABreakIsOneEmptyByteHoweverLongItLasts) {
  SerialSendSpec pause = bytes("", 0, SerialFault::kBreak);
  pause.break_s = 100e-6;  // 156 bits
  connect({bytes("before"), pause, bytes("after")});
  const Read read = read_all(8'000);
  EXPECT_EQ(read.bytes, std::string("before\0after", 12));
  EXPECT_THAT(read.errors, ElementsAre(Errors{.framing = true, .line_break = true}));
}

TEST_P(UartSerialLine, ABreakOfTheControllerReachesTheLog) {
  connect({});
  const std::uint32_t format = bus_.read32({uart::kLcr});
  bus_.write32({uart::kLcr}, format | uart::kBreakOn);
  axi_.step(2'000);
  bus_.write32({uart::kLcr}, format);
  axi_.step(200);
  send_all("up");
  ASSERT_EQ(from_uart_.size(), 3u);
  EXPECT_TRUE(from_uart_[0].is_break);
  EXPECT_EQ(sent_text().substr(1), "up");
}

TEST_P(UartSerialLine, InterruptsOnceForEightBytesAndAfterAPauseForTheRest) {
  connect({bytes("12345678abc")});
  uart_.enable({.received = true});
  while (!dut_.irq_o) axi_.step();
  EXPECT_EQ(to_uart_.size(), 8u) << "the eighth character is on the line";
  EXPECT_EQ(uart_.pending(), AxiUart16550::Source::kReceived);
  std::array<std::uint8_t, 8> first{};
  EXPECT_EQ(uart_.receive(first).count, 8u);
  axi_.step(4);
  EXPECT_FALSE(dut_.irq_o);
  while (!dut_.irq_o) axi_.step();
  EXPECT_EQ(uart_.pending(), AxiUart16550::Source::kReceiveTimeout);
  EXPECT_EQ(read_all().bytes, "abc");
}

TEST_P(UartSerialLine, AnEchoGivesTheSameLogEveryTime) {
  std::string logs[2];
  for (std::string& log : logs) {
    to_uart_.clear();
    from_uart_.clear();
    connect({bytes("ping", 1.5), bytes("!", 0, SerialFault::kFraming)});
    const auto start = axi_.clock();
    send_all(read_all().bytes);
    for (SerialEvent event : to_uart_) {
      event.at = event.at - Cycles{start};
      log += serial_log_row(event) + '\n';
    }
    EXPECT_EQ(sent_text(), "ping!");
  }
  EXPECT_EQ(logs[0], logs[1]);
  EXPECT_THAT(logs[0], testing::HasSubstr(",rx,70,p,,1.5000,\n"));
  EXPECT_THAT(logs[0], testing::HasSubstr(",rx,21,!,framing,0.0000,\n"));
}

}  // namespace
}  // namespace armature::test
