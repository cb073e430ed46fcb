// arm_soc: a reset in the middle of any traffic leaves nothing behind. After it the chip behaves, clock by clock, as
// one that has just been switched on.
#include <cstdint>
#include <memory>

#include "cosim/logic/pin_list.hpp"
#include "tests/rtl/arm_soc_fixture.hpp"

namespace armature::test {
namespace {

namespace pulse = regs::pulse_train;

class ArmSocReset : public ArmSocTest {
 protected:
  // A chip that was just switched on. Its registers without a reset have random values of their own.
  struct Twin {
    explicit Twin(int seed) : context{seed} {
      cosim::set_clocks(dut, {});
      dut.eval();
    }
    ~Twin() {
      dut.final();
      Verilated::threadContextp(&context);  // the destructor of dut removes its scopes from this context
    }

    struct Context : PowerUpContext {
      explicit Context(int seed) { randSeed(seed); }
    } context;
    Varm_soc dut{&context};
  };

  // In each clock, each input port changes a random bit with a probability of 1/8.
  void change_pins() {
    for (const cosim::Pin& pin : cosim::kPins) {
      if (!pin.is_input() || random_.below(8) != 0) continue;
      const std::uint32_t bit = 1u << random_.below(static_cast<std::uint32_t>(pin.bits));
      pin.set(pins_, pin.get(pins_, {}) ^ bit);
    }
    pins_.estop_n = random_.below(4000) != 0;  // seldom, so that the axes move
    cosim::drive_pins(dut_, pins_);
  }

  void clock() override {
    change_pins();
    if (twin_) drive_twin();
    tick();
    if (twin_) compare();
  }

  // A random access, or those that start the timer, move the axes, clear the stops or send a character.
  void post() {
    static constexpr std::uint32_t kBlocks[] = {kGpio, kTimer, kUart, kPulse, kEncoder, kIk};
    const std::uint32_t addr = kBlocks[random_.below(6)] + 4 * random_.below(48);
    const auto data = static_cast<std::uint32_t>(random_.next());
    switch (random_.below(8)) {
      case 0:
        axi_.post_write(kTlr0, 20 + random_.below(300));
        axi_.post_write(kTcsr0, kLoad);
        axi_.post_write(kTcsr0, kTimerRun);
        break;
      case 1:
      case 2:
        axi_.post_write(kPulse + pulse::kTickCyclesOffset, 100 + random_.below(200));
        for (std::uint32_t i = 0; i < kAxes; ++i) axi_.post_write(kPulse + pulse::kCountOffset + 4 * i, data >> i);
        axi_.post_write(kPulse + pulse::kCommitOffset, data);
        break;
      case 3:
        axi_.post_write(kPulse + pulse::kEstopOffset, pulse::kEstopClearEstopMask | pulse::kEstopClearWatchdogMask);
        axi_.post_write(kPulse + pulse::kCtrlOffset, data);
        break;
      case 4:  // divisor, format, character
        axi_.post_write(kUart + 0x0C, 0x80);
        axi_.post_write(kUart + 0x00, 1 + random_.below(3));
        axi_.post_write(kUart + 0x0C, data & 0x3F);
        axi_.post_write(kUart + 0x00, data >> 8);
        break;
      case 5:
        axi_.post_write(addr, data);
        break;
      default:
        axi_.post_read(addr);
    }
  }
  void traffic(int clocks) {
    for (int i = 0; i < clocks; ++i) {
      if (random_.below(12) == 0) post();
      axi_.step();
    }
    axi_.write_answers.clear();
    axi_.read_answers.clear();
  }

  SplitMix random_{1815};
  cosim::SocInputs pins_;
  std::unique_ptr<Twin> twin_;
  std::int64_t pulses_compared_ = 0;  // clocks with a pulse while there was a twin

 private:
  void drive_twin() {
    Varm_soc& twin = twin_->dut;
    cosim::drive_pins(twin, pins_);
    twin.rst_ni = dut_.rst_ni;
    twin.s_axi_awaddr_i = dut_.s_axi_awaddr_i, twin.s_axi_awvalid_i = dut_.s_axi_awvalid_i;
    twin.s_axi_wdata_i = dut_.s_axi_wdata_i, twin.s_axi_wstrb_i = dut_.s_axi_wstrb_i;
    twin.s_axi_wvalid_i = dut_.s_axi_wvalid_i, twin.s_axi_bready_i = dut_.s_axi_bready_i;
    twin.s_axi_araddr_i = dut_.s_axi_araddr_i, twin.s_axi_arvalid_i = dut_.s_axi_arvalid_i;
    twin.s_axi_rready_i = dut_.s_axi_rready_i;
    cosim::eval_edge(twin, cosim::needed_clocks(twin, cosim::kAllGatedClocks));
  }

  // Address, data and response are compared while they are valid.
  void compare() {
    const Varm_soc& twin = twin_->dut;
    ASSERT_EQ(cosim::output_word(dut_), cosim::output_word(twin)) << "clock " << cycle_;
    ASSERT_EQ(dut_.s_axi_awready_o, twin.s_axi_awready_o) << "clock " << cycle_;
    ASSERT_EQ(dut_.s_axi_wready_o, twin.s_axi_wready_o) << "clock " << cycle_;
    ASSERT_EQ(dut_.s_axi_arready_o, twin.s_axi_arready_o) << "clock " << cycle_;
    ASSERT_EQ(dut_.s_axi_bvalid_o, twin.s_axi_bvalid_o) << "clock " << cycle_;
    ASSERT_EQ(dut_.s_axi_rvalid_o, twin.s_axi_rvalid_o) << "clock " << cycle_;
    if (dut_.s_axi_bvalid_o) {
      ASSERT_EQ(dut_.s_axi_bresp_o, twin.s_axi_bresp_o) << "clock " << cycle_;
    }
    if (dut_.s_axi_rvalid_o) {
      ASSERT_EQ(dut_.s_axi_rresp_o, twin.s_axi_rresp_o) << "clock " << cycle_;
      ASSERT_EQ(dut_.s_axi_rdata_o, twin.s_axi_rdata_o) << "clock " << cycle_;
    }
    pulses_compared_ += dut_.step_o != 0;
  }
};
INSTANTIATE_AXI_STALLS(ArmSocReset);

TEST_P(ArmSocReset, AnywhereInTheTrafficItLeavesNothingBehind) {
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    traffic(200 + static_cast<int>(random_.below(2000)));
    twin_ = std::make_unique<Twin>(1 + round);
    dut_.rst_ni = 0;
    axi_.step(1 + static_cast<int>(random_.below(4)));  // a reset of one clock is enough
    dut_.rst_ni = 1;
    cycle_ = 0;
    traffic(2000);
    twin_.reset();
    Verilated::threadContextp(&context_);
    if (HasFailure()) return;
  }
  EXPECT_GT(pulses_compared_, 1000) << "the traffic moves the axes";
}

}  // namespace
}  // namespace armature::test
