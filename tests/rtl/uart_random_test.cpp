// axi_uart16550 under random traffic from the bus, the line and the modem pins, in step with a software model.
#include "tests/rtl/uart_fixture.hpp"
#include "tests/rtl/uart_model.hpp"

namespace armature::test {
namespace {

using namespace uart;

constexpr std::uint64_t kSeed = 16550;
constexpr int kOperations = 4000;

class UartRandom : public UartTest {
 protected:
  std::uint32_t below(std::uint32_t limit) { return random_.below(limit); }

  // Formats change only while nothing waits: the timeout of a waiting character has the length of its own format.
  void random_format() {
    if (model_.waiting() != 0) return;
    configure(8, {5 + below(4), kAllParities[below(5)], below(2) != 0});
  }
  void character_from_the_line() {
    if (model_.loops()) return;
    const std::uint32_t data = below(256) & format_.mask();
    const std::uint32_t kind = below(8);
    if (kind == 0) {
      sender_.bits(false, 14);
      sender_.bits(true, 1);
      finish_sending();
      model_.arrive({0, kBi | kFe});
    } else {
      const bool wrong_parity = kind == 1 && format_.has_parity(), no_stop = kind == 2;
      // All low is a break.
      if (no_stop && data == 0) return;
      sender_.send(data, format_, wrong_parity, !no_stop);
      sender_.bits(true, 0.5);
      finish_sending();
      model_.arrive({data, (wrong_parity ? kPe : 0u) | (no_stop ? kFe : 0u)});
    }
    last_event_ = axi_.clock();
  }
  void characters_to_send() {
    std::vector<std::uint32_t> data(below(4) == 0 ? 1 + below(20) : 1 + below(2));
    for (std::uint32_t& value : data) value = below(256);
    for (const std::uint32_t value : data) axi_.post_write(kThr, value);
    axi_.drain();
    axi_.write_answers.clear();
    const std::int64_t character = static_cast<std::int64_t>(format_.bits() * 16) * 8;
    const std::vector<std::uint32_t> sent = model_.transmit(data);
    axi_.step(static_cast<int>(character * std::ssize(sent) + bit_));
    if (model_.loops()) {
      for (const std::uint32_t value : sent) model_.arrive({value & format_.mask(), 0});
      last_event_ = axi_.clock() - bit_;
    } else {
      for (const std::uint32_t value : sent) line_.push_back(value & format_.mask());
    }
  }
  void access() {
    switch (below(9)) {
      case 0:
        EXPECT_EQ(read(kIir), model_.read_iir());
        break;
      case 1:
        EXPECT_EQ(read(kLsr), model_.read_lsr());
        break;
      case 2:
        EXPECT_EQ(read(kMsr), model_.read_msr());
        break;
      case 3:
        write_both(kIer, below(32), &UartModel::write_ier);
        break;
      case 4:
        write_both(kFcr, below(3) == 0 ? below(256) : ((below(256) & ~6u) | 1u), &UartModel::write_fcr);
        break;
      case 5:
        write_both(kMcr, below(2) == 0 ? below(32) : below(16), &UartModel::write_mcr);
        break;
      case 6:
        EXPECT_EQ(read(kIer), model_.ier());
        EXPECT_EQ(read(kMcr), model_.mcr());
        write(kLcr, format_.lcr() | kDlab);
        EXPECT_EQ(read(kFcr), model_.fcr());
        write(kLcr, format_.lcr());
        break;
      case 7: {
        const std::uint32_t pins = below(16);
        dut_.cts_ni = (pins & 1) == 0;
        dut_.dsr_ni = (pins & 2) == 0;
        dut_.ri_ni = (pins & 4) == 0;
        dut_.dcd_ni = (pins & 8) == 0;
        model_.set_modem_pins(pins);
        break;
      }
      default:
        for (std::uint32_t count = below(6); count > 0; --count) {
          EXPECT_EQ(read(kRbr), model_.read_rbr());
          last_event_ = axi_.clock();
        }
    }
    axi_.step(6);
  }
  void write_both(std::uint32_t reg, std::uint32_t value, void (UartModel::*model_write)(std::uint32_t)) {
    write(reg, value);
    (model_.*model_write)(value);
  }
  // Nothing is compared while a timeout may or may not have come.
  void settle_timeout() {
    const double character = format_.bits() * static_cast<double>(bit_);
    const auto passed = [&] { return static_cast<double>(axi_.clock() - last_event_) / character; };
    if (below(20) == 0 || passed() > 2.5) {
      while (passed() < 5) axi_.step(50);
      model_.four_characters_pass();
    }
  }

  SplitMix random_{kSeed};
  UartModel model_;
  std::vector<unsigned> line_;  // expected there
  std::int64_t last_event_ = 0;
};
INSTANTIATE_UART_LINE(UartRandom);

TEST_P(UartRandom, BehavesAsTheModel) {
  std::cout << "seed " << kSeed << '\n';
  configure(8);
  for (int i = 0; i < kOperations && !HasFailure(); ++i) {
    const std::uint32_t kind = below(16);
    if (kind == 0) {
      random_format();
    } else if (kind < 5) {
      character_from_the_line();
    } else if (kind < 7) {
      characters_to_send();
    } else {
      access();
    }
    settle_timeout();
    EXPECT_EQ(dut_.irq_o, model_.irq()) << "operation " << i;
    EXPECT_EQ(receiver_.data(), line_) << "operation " << i;
    receiver_.characters.clear();
    line_.clear();
  }
}

}  // namespace
}  // namespace armature::test
