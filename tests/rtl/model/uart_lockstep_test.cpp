// axi_uart16550 and its model, clock for clock.
#include <string>
#include <vector>

#include "Vaxi_uart16550.h"
#include "controller/regs/axi_uart16550_regs.hpp"
#include "cosim/model/uart/axi_uart16550.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test {
namespace {

namespace regs = armature::regs::axi_uart16550;
using cosim::model::AxiUart16550;
using cosim::model::UartInputs;

// The far end: characters with start and stop bits, breaks, noise, and bit times that are slightly wrong.
class FarEnd {
 public:
  bool next(SplitMix& random, std::uint32_t bit_clocks) {
    if (noise_ != 0 && --noise_ != 0) return random.below(2) != 0;
    if (random.below(4000) == 0) noise_ = 1 + random.below(30);
    if (left_ == 0 && bits_.empty()) {
      if (gap_ != 0 && --gap_ != 0) return true;
      gap_ = random.below(3) == 0 ? random.below(40 * bit_clocks) : 1;
      const std::uint32_t size = 5 + random.below(5);
      const bool is_break = random.below(12) == 0;
      bits_.push_back(random.below(12) != 0);  // the last one: stop
      for (std::uint32_t i = 0; i < size; ++i) bits_.push_back(!is_break && random.below(2) != 0);
      bits_.push_back(false);
    }
    if (left_ == 0) {
      level_ = bits_.back();
      bits_.pop_back();
      left_ = bit_clocks + (random.below(8) == 0 ? random.below(3) : 0);
    }
    --left_;
    return level_;
  }

 private:
  std::vector<bool> bits_;  // the next one last
  bool level_ = true;
  std::uint32_t left_ = 0, gap_ = 100, noise_ = 0;
};

class UartLockstep : public BlockLockstep<Vaxi_uart16550, AxiUart16550, UartInputs> {
 protected:
  BusTraffic random_write() override {
    const auto any = static_cast<std::uint32_t>(random_.next());
    const auto strobes = random_.below(8) == 0 ? static_cast<std::uint8_t>(random_.below(16)) : std::uint8_t{0xF};
    if (divisor_steps_ != 0) return divisor_write();
    if (random_.below(rare_) != 0) {
      const std::uint32_t kind = random_.below(6);
      return {kind < 4 ? regs::kRbrOffset : regs::kScrOffset, any, strobes};
    }
    switch (random_.below(8)) {
      case 0:
        divisor_steps_ = 4;
        return divisor_write();
      case 1:
        return {regs::kIirOffset, random_.below(4) == 0 ? any : (any & 0xC0) | 1, strobes};
      case 2:
        return {regs::kLcrOffset, any & (random_.below(4) == 0 ? 0x7F : 0x3F), strobes};
      case 3:
        return {regs::kMcrOffset, any & (random_.below(3) == 0 ? 0x1F : 0xF), strobes};
      case 4:
      case 5:
        return {regs::kIerOffset, any, strobes};
      case 6:
        return {0x1000 + 4 * random_.below(8), any, strobes};
      default:
        return {random_.below(random_.below(8) == 0 ? 0x10000 : 0x1030), any, strobes};
    }
  }

  // DLAB on, DLM, DLL, DLAB off.
  BusTraffic divisor_write() {
    const std::uint32_t step = divisor_steps_--;
    if (step == 4) return {regs::kLcrOffset, 0x80 | format_};
    if (step == 3) return {regs::kIerOffset, random_.below(30) == 0 ? 1u : 0u};
    if (step == 2) return {regs::kRbrOffset, divisor_};
    format_ = random_.below(64);
    return {regs::kLcrOffset, format_};
  }

  std::uint16_t random_read() override {
    if (random_.below(20) == 0) return static_cast<std::uint16_t>(random_.below(0x10000));
    return static_cast<std::uint16_t>(0x1000 + 4 * random_.below(9));
  }

  void change_inputs() override {
    inputs_.rxd = far_end_.next(random_, 16 * divisor_);
    const auto flips = [this] { return random_.below(modem_rest_) == 0; };
    if (flips()) inputs_.cts_n = !inputs_.cts_n;
    if (flips()) inputs_.dsr_n = !inputs_.dsr_n;
    if (flips()) inputs_.dcd_n = !inputs_.dcd_n;
    if (flips()) inputs_.ri_n = !inputs_.ri_n;
  }
  void drive_inputs(Vaxi_uart16550& dut, const UartInputs& in) override {
    dut.rxd_i = in.rxd;
    dut.cts_ni = in.cts_n;
    dut.dsr_ni = in.dsr_n;
    dut.dcd_ni = in.dcd_n;
    dut.ri_ni = in.ri_n;
  }
  std::string difference(const Vaxi_uart16550& dut, const AxiUart16550& uart) override {
    sent_edges_ += dut.txd_o != txd_before_;
    txd_before_ = dut.txd_o;
    interrupts_ += dut.irq_o && !irq_before_;
    irq_before_ = dut.irq_o;
    const auto differs = [](const char* name, bool rtl, bool model) { return std::string{rtl == model ? "" : name}; };
    return differs("txd_o ", dut.txd_o, uart.txd()) + differs("rts_no ", dut.rts_no, uart.rts_n()) +
           differs("dtr_no ", dut.dtr_no, uart.dtr_n()) + differs("out1_no ", dut.out1_no, uart.out1_n()) +
           differs("out2_no ", dut.out2_no, uart.out2_n()) + differs("irq_o ", dut.irq_o, uart.irq());
  }

  FarEnd far_end_;
  std::uint32_t divisor_ = 2, format_ = 3, divisor_steps_ = 4, rare_ = 4, modem_rest_ = 500;
  int sent_edges_ = 0, interrupts_ = 0;  // seen
  bool txd_before_ = true, irq_before_ = false;
};

TEST_F(UartLockstep, RandomTrafficWithSmallDivisors) {
  for (const std::uint32_t divisor : {1u, 2u, 3u}) {
    divisor_ = divisor;
    for (const std::uint32_t gap : {3u, 40u, 400u}) {
      divisor_steps_ = 4;
      run(60'000, gap, 1);
    }
  }
  EXPECT_GT(sent_edges_, 2'000);
  EXPECT_GT(interrupts_, 500);
}

TEST_F(UartLockstep, ALineOf115200Baud) {
  divisor_ = 27;
  rare_ = 40;
  run(600'000, 1'000, 1);
  EXPECT_GT(sent_edges_, 200);
  EXPECT_LT(needed_.computed, 600'000 / 20);
}

TEST_F(UartLockstep, AGatedClockThatStops) {
  run(20'000, 10, 1);
  stop_gated_clock();
  run(5'000, 10, 1);
}

}  // namespace
}  // namespace armature::test
