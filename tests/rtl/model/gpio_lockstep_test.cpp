// The model of axi_gpio against the verilated block with the parameters of arm_soc.
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include "Vaxi_gpio_soc.h"
#include "controller/regs/axi_gpio_regs.hpp"
#include "cosim/model/gpio/axi_gpio.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test {
namespace {

namespace map = regs::axi_gpio;
using cosim::model::AxiGpio;
using cosim::model::GpioInputs;

static_assert(map::kDataValueReset == 0 && map::kTriValueReset == 0xFFFF, "the verilated block has these parameters");

constexpr std::array<std::uint16_t, 7> kOffsets{map::kDataOffset, map::kTriOffset, map::kData2Offset, map::kTri2Offset,
                                                map::kGierOffset, map::kIsrOffset, map::kIerOffset};

class GpioLockstep : public BlockLockstep<Vaxi_gpio_soc, AxiGpio, GpioInputs> {
 protected:
  std::uint16_t random_address() {
    if (random_.below(16) == 0) return static_cast<std::uint16_t>(random_.below(0x10000));
    if (random_.below(16) == 0) return static_cast<std::uint16_t>(random_.below(0x208));
    return static_cast<std::uint16_t>(kOffsets[random_.below(kOffsets.size())] + (random_.below(8) == 0 ? 3 : 0));
  }
  BusTraffic random_write() override {
    BusTraffic write{.addr = random_address(), .data = static_cast<std::uint32_t>(random_.next())};
    if (random_.below(4) == 0) write.wstrb = static_cast<std::uint8_t>(random_.below(16));
    if (write.addr == map::kTriOffset && random_.below(2) != 0) write.data = random_.below(2) != 0 ? 0xFFFF : 0;
    return write;
  }
  std::uint16_t random_read() override { return random_address(); }
  void change_inputs() override {
    count();
    if (random_.below(pin_gap_) != 0) return;
    std::uint16_t& pins = random_.below(2) != 0 ? inputs_.gpio1 : inputs_.gpio2;
    switch (random_.below(4)) {
      case 0:
        pins = static_cast<std::uint16_t>(random_.next());
        break;
      case 1:
        pins = random_.below(2) != 0 ? 0xFFFF : 0;
        break;
      default:
        pins ^= static_cast<std::uint16_t>(1u << random_.below(16));
        break;
    }
  }
  void drive_inputs(Vaxi_gpio_soc& dut, const GpioInputs& in) override {
    dut.gpio_i = in.gpio1;
    dut.gpio2_i = in.gpio2;
  }
  std::string difference(const Vaxi_gpio_soc& dut, const AxiGpio& block) override {
    if (dut.gpio_driven_o == block.driven() && dut.irq_o == block.irq()) return {};
    std::ostringstream text;
    text << std::hex << "RTL/model: driven 0x" << dut.gpio_driven_o << "/0x" << block.driven() << ", irq "
         << int{dut.irq_o} << '/' << block.irq();
    return text.str();
  }

  // What the coming edge finds.
  void count() {
    if (dut_.irq_o && !irq_) ++irqs_;
    irq_ = dut_.irq_o != 0;
    if (std::exchange(driven_, dut_.gpio_driven_o) != dut_.gpio_driven_o) ++drives_;
    const cosim::model::Strobes& access = every_.port.strobes();
    const bool toggles = access.write && access.waddr == map::kIsrOffset && (access.wdata & access.wstrb & 1u) != 0;
    if (toggles) ++toggles_;
    if (toggles && samples_[2] != samples_[1]) ++changes_with_toggles_;
    samples_ = {inputs_.gpio2, samples_[0], samples_[1]};
    const cosim::AxiSlavePins& pins = every_.port.pins();
    if (pins.rvalid && every_.port.strobes().raddr == map::kIsrOffset) ++statuses_[pins.rdata & 3u];
  }

  void run(std::uint32_t pin_gap, std::int64_t clocks, std::uint32_t gap, std::uint32_t lazy) {
    pin_gap_ = pin_gap;
    BlockLockstep::run(clocks, gap, lazy);
  }
  GpioInputs random_levels() {
    const auto levels = random_.next();
    return {.gpio1 = static_cast<std::uint16_t>(levels), .gpio2 = static_cast<std::uint16_t>(levels >> 16)};
  }

  std::uint32_t pin_gap_ = 1;
  bool irq_ = false;
  std::uint16_t driven_ = 0;
  std::array<std::uint16_t, 3> samples_{};  // of channel 2, the latest first
  int irqs_ = 0, drives_ = 0, toggles_ = 0, changes_with_toggles_ = 0;
  std::array<int, 4> statuses_{};  // clocks in which a read of ISR returned this
};

TEST_F(GpioLockstep, RandomTrafficIsThatOfTheBlockInEveryClock) {
  run(1, 100'000, 1, 1);
  run(3, 200'000, 8, 2);
  run(50, 200'000, 5, 2);
  run(100, 300'000, 20, 4);
  run(500, 200'000, 100, 1);
  const std::pair<const char*, int> counts[]{
      {"interrupts", irqs_},
      {"changes of an output", drives_},
      {"writes that toggle ISR", toggles_},
      {"writes of ISR with a change", changes_with_toggles_},
      {"reads of ISR 0", statuses_[0]},
      {"reads of ISR 1", statuses_[1]},
      {"reads of ISR 2", statuses_[2]},
      {"reads of ISR 3", statuses_[3]},
  };
  for (const auto& [what, count] : counts) {
    RecordProperty(what, count);
    EXPECT_GE(count, 300) << "too few " << what;
  }
}

TEST_F(GpioLockstep, LevelsInResetAreNoChange) {
  for (int i = 0; i < 2'000 && !HasFatalFailure(); ++i) {
    inputs_ = random_levels();
    restart();
    pin_gap_ = random_.below(2) != 0 ? 1 + random_.below(6) : 1'000;
    for (const std::uint32_t offset : {map::kDataOffset, map::kData2Offset, map::kIsrOffset}) {
      if (random_.below(4) == 0) continue;
      master_.read(static_cast<std::uint16_t>(offset));
      while (master_.reads()) {
        change_inputs();
        master_.drive(1);
        step();
        ASSERT_EQ(compare(), "") << "reset " << i << ", edge " << cycle_;
      }
    }
  }
}

TEST_F(GpioLockstep, WithoutTheGatedClockNothingChanges) {
  for (int i = 0; i < 300 && !HasFatalFailure(); ++i) {
    restart();
    run(1 + random_.below(20), 20 + random_.below(200), 1 + random_.below(8), 1);
    stop_gated_clock();
    run(1 + random_.below(20), 200, 1 + random_.below(8), 1);
  }
}

TEST_F(GpioLockstep, ABlockAtRestIsNotComputed) {
  run(3, 10'000, 8, 2);
  pin_gap_ = 2'000;
  const std::int64_t before = needed_.computed;
  for (int clock = 0; clock < 200'000; ++clock) {
    change_inputs();
    master_.drive(1);
    step();
    ASSERT_EQ(compare(), "") << "edge " << cycle_;
  }
  EXPECT_LT(needed_.computed - before, 5 * 200);
}

}  // namespace
}  // namespace armature::test
