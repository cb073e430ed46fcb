// axi_uart16550: long transfers without a gap between two ends whose clocks differ. Each change of the receive pin is
// sampled up to a clock late, at random.
#include "tests/rtl/uart_fixture.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/synchroniser_jitter.hpp"

namespace armature::test {
namespace {

using namespace uart;

// Differences of the bit time of the far end from that of the block, in per mille, with which every character arrives.
// README.md of the block states them.
struct Tolerance {
  UartFormat format;
  int shortest;
  int longest;
};
constexpr Tolerance kTolerances[] = {
    {{8, UartParity::kNone}, -43, 55},
    {{8, UartParity::kEven}, -39, 49},
};
constexpr int kCharacters = 250;

class UartDrift : public UartTest {
 protected:
  void clock() override {
    dut_.rxd_i = static_cast<CData>(jitter_.sample(sender_.clock()));
    tick();
    receiver_.clock(dut_.txd_o);
  }

  std::vector<unsigned> random_characters() {
    std::vector<unsigned> characters;
    for (int i = 0; i < kCharacters; ++i) characters.push_back(random_.below(256) & format_.mask());
    return characters;
  }

  bool receives_all(int per_mille) {
    write(kFcr, kFifoOn | kFlushRx);
    sender_.bit_clocks = static_cast<double>(bit_) * (1 + per_mille / 1000.0);
    const std::vector<unsigned> sent = random_characters();
    for (const unsigned character : sent) sender_.send(character, format_);
    std::vector<unsigned> received;
    std::uint32_t errors = 0;
    for (int quiet = 0; quiet < 4; ++quiet) {
      axi_.step(4 * static_cast<int>(bit_));
      if (!sender_.idle()) quiet = 0;
      for (std::uint32_t status; ((status = read(kLsr)) & kDr) != 0; received.push_back(read(kRbr))) errors |= status;
    }
    return received == sent && (errors & (kOe | kPe | kFe | kBi)) == 0;
  }

  // The far end samples in the middle of its bits.
  bool sends_all(int per_mille) {
    write(kFcr, kFifoOn | kFlushTx);
    receiver_.bit_clocks = static_cast<double>(bit_) * (1 + per_mille / 1000.0);
    receiver_.characters.clear();
    const std::vector<unsigned> sent = random_characters();
    for (std::size_t i = 0; i < sent.size(); ++i) {
      while (i % 16 == 0 && (read(kLsr) & kThre) == 0) axi_.step(static_cast<int>(bit_));
      write(kThr, sent[i]);
    }
    finish_transmitting();
    bool stops = true;
    for (const LineCharacter& character : receiver_.characters) stops = stops && character.stop;
    return stops && receiver_.data() == sent;
  }

  SplitMix random_{kAxiSeed};
  SynchroniserJitter jitter_{kAxiSeed, 1};
};
INSTANTIATE_UART_LINE(UartDrift);

TEST_P(UartDrift, ReceivesALongTransferWithinTheStatedToleranceAndNotBeyond) {
  for (const Tolerance& tolerance : kTolerances) {
    configure(27, tolerance.format);  // 115740 baud
    for (const int per_mille : {tolerance.shortest, -20, -5, 0, 5, 20, tolerance.longest}) {
      EXPECT_TRUE(receives_all(per_mille)) << tolerance.format << " at " << per_mille << " per mille";
    }
    for (const int per_mille : {tolerance.shortest - 2, tolerance.longest + 2}) {
      EXPECT_FALSE(receives_all(per_mille)) << tolerance.format << " at " << per_mille << " per mille";
    }
  }
}

TEST_P(UartDrift, SendsALongTransferToAFarEndThatIsFourPercentOff) {
  for (const Tolerance& tolerance : kTolerances) {
    configure(27, tolerance.format);
    for (const int per_mille : {-40, 0, 40}) {
      EXPECT_TRUE(sends_all(per_mille)) << tolerance.format << " at " << per_mille << " per mille";
    }
  }
}

}  // namespace
}  // namespace armature::test
