// The whole programmable logic: where each block answers, and which pin and interrupt belongs to which block of the
// bus' standard cores. What a block does is the subject of its own tests.
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/logic/pin_list.hpp"
#include "tests/rtl/arm_soc_fixture.hpp"

namespace armature::test {
namespace {

namespace pulse = regs::pulse_train;
namespace enc = regs::encoder;

INSTANTIATE_AXI_STALLS(ArmSocTest);

TEST_P(ArmSocTest, EveryOutputIsLowInAndAfterReset) {
  for (const bool in_reset : {true, false}) {
    dut_.rst_ni = !in_reset;
    for (int i = 0; i < 10; ++i) {
      axi_.step();
      EXPECT_EQ(dut_.step_o | dut_.dir_o | dut_.servo_on_o | dut_.trigger_o | dut_.irq_o, 0);
      EXPECT_FALSE(dut_.s_axi_bvalid_o || dut_.s_axi_rvalid_o);
    }
  }
}

TEST_P(ArmSocTest, EveryBlockAnswersAtItsBase) {
  EXPECT_EQ(read(kPulse), 0x5054'0106u);    // "PT", map version 1, 6 axes
  EXPECT_EQ(read(kEncoder), 0x454E'0106u);  // "EN"
  EXPECT_EQ(read(kIk), 0x494B'0108u);       // "IK", 8 branches
  EXPECT_EQ(read(kPolicy), 0x504D'0108u);   // "PM", 8 lanes
  write(kTlr0, 0xCAFE'F00Du);
  EXPECT_EQ(read(kTlr0), 0xCAFE'F00Du);
  EXPECT_EQ(read(kPulse + pulse::kTickCyclesOffset), static_cast<std::uint32_t>(kTick));
}

TEST_P(ArmSocTest, GapsOfTheMapAnswerDecErr) {
  for (const std::uint32_t addr : {0x0000'0000u, 0x411F'FFFCu, 0x4121'0000u, 0x427F'FFFCu, 0x4281'0000u, 0x43BF'FFFCu,
                                   0x43C3'0000u, 0x43C6'0000u, 0xC280'0000u, 0xFFFF'FFFCu}) {
    EXPECT_EQ(axi_.read(addr).resp, AxiResp::kDecErr) << std::hex << addr;
    EXPECT_EQ(axi_.write(addr, 0xFFFF'FFFFu), AxiResp::kDecErr) << std::hex << addr;
  }
  EXPECT_EQ(read(kTcsr0), 0u);
}

TEST_P(ArmSocTest, UnmappedOffsetsOfABlockAnswerSlvErr) {
  for (const std::uint32_t base : {kTimer, kPulse, kEncoder, kIk, kPolicy}) {
    for (const std::uint32_t offset : {0xFF0u, 0x1000u, 0x8000u, 0xFFFCu}) {
      EXPECT_EQ(axi_.read(base + offset), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5u})) << std::hex << base + offset;
      EXPECT_EQ(axi_.write(base + offset, 1), AxiResp::kSlvErr) << std::hex << base + offset;
    }
  }
  EXPECT_EQ(axi_.write(kPulse, 1), AxiResp::kSlvErr) << "the ID is read-only";
}

TEST_P(ArmSocTest, GeneralPurposePinsAndTheirInterruptBelongToTheGpio) {
  write(kGpio + 0x128, 2);             // IER: channel 2
  write(kGpio + 0x11C, 0x8000'0000u);  // GIER
  write(kGpio + 0x04, 0);              // TRI: outputs
  write(kGpio + 0x00, 0xA5C3);
  axi_.step(4);
  EXPECT_EQ(dut_.gpio_o, 0xA5C3);
  EXPECT_EQ(dut_.irq_o, 0);
  dut_.gpio_i = 0x1234;
  axi_.step(6);
  EXPECT_EQ(dut_.irq_o, 0b100);
  EXPECT_EQ(read(kGpio + 0x08), 0x1234u);
  write(kGpio + 0x120, 2);
  axi_.step(4);
  EXPECT_EQ(dut_.irq_o, 0);
}

// Its clock stands still before the start and after the end.
TEST_P(ArmSocTest, TheInverseKinematicsRunsAndInterrupts) {
  axi_.step(50);
  write(kIk + 0x28, 20u << 24);  // A2
  write(kIk + 0x2C, 10u << 24);  // FOREARM
  write(kIk + 0x40, 1u << 30);   // the approach is x
  write(kIk + 0x80, 25u << 24);  // POSITION
  write(kIk + 0x04, 0b111);      // CTRL: interrupt, five axes, start
  EXPECT_EQ(read(kIk + 0x08), 1u);
  EXPECT_EQ(dut_.irq_o, 0);
  axi_.step(701);
  EXPECT_EQ(dut_.irq_o, 0b1000);
  EXPECT_EQ(read(kIk + 0x08), 2u);
  EXPECT_EQ(read(kIk + 0x10), 701u) << "clocks";
  EXPECT_EQ(read(kIk + 0x14), 0x55u);
  write(kIk + 0x0C, 1);
  axi_.step(2);
  EXPECT_EQ(dut_.irq_o, 0);
}

// Likewise.
TEST_P(ArmSocTest, TheNetworkRunsAndInterrupts) {
  axi_.step(50);
  const std::uint32_t image[] = {0x0002'0000, 0, 0x0000'0000, 0x8000, 0x02, 0};  // one neuron: half of 2 x
  for (const std::uint32_t word : image) write(kPolicy + 0x24, word);            // DATA
  write(kPolicy + 0x40, 25);                                                     // INPUT
  write(kPolicy + 0x14, 127);                                                    // BOUND
  write(kPolicy + 0x18, 0xB855'3142);
  write(kPolicy + 0x04, 0b11);  // CTRL: interrupt, start
  EXPECT_EQ(dut_.irq_o, 0);
  axi_.step(12);
  EXPECT_EQ(dut_.irq_o, 0b1'0000);
  EXPECT_EQ(read(kPolicy + 0x08), 2u);
  EXPECT_EQ(read(kPolicy + 0x10), 9u) << "clocks";
  EXPECT_EQ(read(kPolicy + 0x60), 25u);
  write(kPolicy + 0x0C, 1);
  axi_.step(2);
  EXPECT_EQ(dut_.irq_o, 0);
}

// The outputs of the tool have no tri-state buffer.
TEST_P(ArmSocTest, AReleasedOutputOfTheToolIsLowAndReadsItsPin) {
  EXPECT_EQ(read(kGpio + 0x04), 0xFFFFU) << "nothing is driven from reset on";
  EXPECT_EQ(read(kGpio + 0x0C), 0xFFFFU);
  write(kGpio + 0x00, 0xA5);
  EXPECT_EQ(read(kGpio + 0x00), 0U);
  EXPECT_EQ(dut_.gpio_o, 0);
  write(kGpio + 0x04, 0xFFF0);
  EXPECT_EQ(read(kGpio + 0x00), 0x05U);
  axi_.step(2);
  EXPECT_EQ(dut_.gpio_o, 0x05);
  write(kGpio + 0x04, 0);
  EXPECT_EQ(read(kGpio + 0x00), 0xA5U);
  write(kGpio + 0x08, 0xFFFF);
  write(kGpio + 0x0C, 0);
  EXPECT_EQ(read(kGpio + 0x08), 0U) << "channel 2 has inputs only";
  EXPECT_EQ(read(kGpio + 0x0C), 0xFFFFU);
  EXPECT_EQ(read(kGpio + 0x120), 0U);
}

// As the vendor's interrupt example uses channel 1: inputs by the reset value, an acknowledge by a toggling write.
TEST_P(ArmSocTest, ChannelOneOfTheGpioHasInputsAndInterruptsToo) {
  write(kGpio + 0x128, 1);             // IER: channel 1
  write(kGpio + 0x11C, 0x8000'0000u);  // GIER
  axi_.step(8);
  EXPECT_EQ(dut_.irq_o, 0);
  for (const std::uint32_t levels : {0x8001U, 0x0001U, 0x1234U, 0U}) {
    dut_.gpio1_i = static_cast<SData>(levels);
    axi_.step(8);
    EXPECT_EQ(dut_.irq_o, 0b100);
    EXPECT_EQ(read(kGpio + 0x00), levels);
    EXPECT_EQ(read(kGpio + 0x120), 1U);
    write(kGpio + 0x120, 1);
    axi_.step(4);
    EXPECT_EQ(dut_.irq_o, 0);
    EXPECT_EQ(read(kGpio + 0x120), 0U);
    write(kGpio + 0x120, 1);  // toggles: sets the status again
    axi_.step(4);
    EXPECT_EQ(dut_.irq_o, 0b100);
    write(kGpio + 0x120, 1);
  }
  dut_.gpio_i = 0xFFFF;
  axi_.step(8);
  EXPECT_EQ(dut_.irq_o, 0) << "channel 2 is not enabled";
  EXPECT_EQ(read(kGpio + 0x00), 0U);
  write(kGpio + 0x120, 2);
  write(kGpio + 0x04, 0);  // outputs again
  dut_.gpio1_i = 0xFFFF;
  axi_.step(8);
  EXPECT_EQ(read(kGpio + 0x120), 0U);
  EXPECT_EQ(read(kGpio + 0x00), 0U) << "the written value";
}

TEST_P(ArmSocTest, TheModemLinesOfTheUartHavePins) {
  EXPECT_EQ(read(kUart + 0x18), 0U) << "inactive without a connection";
  struct Input {
    CData* pin;
    std::uint32_t status;  // level and change in MSR
  };
  for (const auto& [pin, status] : {Input{&dut_.uart_cts_ni, 0x11}, Input{&dut_.uart_dsr_ni, 0x22},
                                    Input{&dut_.uart_ri_ni, 0x40}, Input{&dut_.uart_dcd_ni, 0x88}}) {
    *pin = 0;
    axi_.step(8);
    EXPECT_EQ(read(kUart + 0x18), status);
    *pin = 1;
    axi_.step(8);
    EXPECT_EQ(read(kUart + 0x18), status == 0x40 ? 0x04U : status & 0x0FU);
  }
  write(kUart + 0x04, 0x08);  // IER: modem status
  dut_.uart_cts_ni = 0;
  axi_.step(8);
  EXPECT_EQ(dut_.irq_o, 0b010);
  for (std::uint32_t outputs = 0; outputs < 4; ++outputs) {  // MCR: DTR, RTS
    write(kUart + 0x10, outputs);
    axi_.step(4);
    EXPECT_EQ(dut_.uart_dtr_no, (outputs & 1) == 0);
    EXPECT_EQ(dut_.uart_rts_no, (outputs & 2) == 0);
  }
}

// 8N1, divisor 1: 16 clocks a bit. What is sent comes back through a wire between the pins.
TEST_P(ArmSocTest, SerialPinsAndTheirInterruptBelongToTheUart) {
  environment_ = [this] { dut_.uart_rxd_i = dut_.uart_txd_o; };
  write(kUart + 0x0C, 0x83);
  write(kUart + 0x00, 1);
  write(kUart + 0x04, 0);
  write(kUart + 0x0C, 0x03);
  write(kUart + 0x04, 0x01);
  bool was_low = false;
  write(kUart + 0x00, 0x5A);
  for (int i = 0; i < 16 * 12; ++i) {
    axi_.step();
    was_low = was_low || !dut_.uart_txd_o;
  }
  EXPECT_TRUE(was_low);
  EXPECT_EQ(dut_.irq_o, 0b010);
  EXPECT_EQ(read(kUart + 0x00), 0x5Au);
  axi_.step(4);
  EXPECT_EQ(dut_.irq_o, 0);
}

TEST_P(ArmSocTest, BothTimersCaptureFromTheirPin) {
  for (const std::uint32_t timer : {0x00u, 0x10u}) write(kTimer + timer, 0x089);  // MDT, CAPT, ENT
  axi_.step(20);
  dut_.capture_trig_i = 1;
  axi_.step(8);
  for (const std::uint32_t timer : {0x00u, 0x10u}) {
    EXPECT_EQ(read(kTimer + timer), 0x189u) << timer;
    EXPECT_NE(read(kTimer + timer + 4), 0u) << timer;
  }
}

TEST_P(ArmSocTest, ThePwmOfTheTimersHasAPin) {
  write(kTlr0, 98);
  write(kTlr0 + 0x10, 23);
  for (const std::uint32_t timer : {0x00u, 0x10u}) write(kTimer + timer, 0x226);  // PWM, LOAD, GENT, UDT
  for (const std::uint32_t timer : {0x00u, 0x10u}) write(kTimer + timer, 0x216);  // ARHT
  write(kTcsr0, 0x616);                                                           // ENALL
  axi_.step(150);
  int high = 0;
  for (int i = 0; i < 1000; ++i) {
    axi_.step();
    high += dut_.pwm_o;
  }
  EXPECT_EQ(high, 250);
}

TEST_P(ArmSocTest, ByteStrobesAndUnalignedAddressesReachTheBlocks) {
  const std::uint32_t addr = kEncoder + enc::kCountsPerRevOffset;
  write(addr, 0x0011'2233u);
  EXPECT_EQ(axi_.write(addr + 1, 0xAABB'CCDDu, 0x2), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(addr + 3), (AxiReadResult{AxiResp::kOkay, 0x0011'CC33u}));
  EXPECT_EQ(axi_.write(addr, 0, 0x0), AxiResp::kOkay);
  EXPECT_EQ(read(addr), 0x0011'CC33u);
}

TEST_P(ArmSocTest, TheDriveEnablesProtectTimesAndFilters) {
  constexpr std::uint32_t kDirHold = kPulse + 0x24, kDebounce = kEncoder + 0x04;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    write(kPulse + pulse::kCtrlOffset, 1U << axis);
    EXPECT_EQ(axi_.write(kDirHold, 30), AxiResp::kSlvErr);
    EXPECT_EQ(axi_.write(kDebounce, 6), AxiResp::kSlvErr);
  }
  write(kPulse + 0x3C, 0x5054'4B59);
  write(kDirHold, 30);
  EXPECT_EQ(axi_.write(kDebounce, 6), AxiResp::kSlvErr) << "each block has a key of its own";
  write(kEncoder + 0x3C, 0x454E'4B59);
  write(kDebounce, 6);
  for (const std::uint32_t block : {kPulse, kEncoder}) write(block + 0x3C, 0);
  EXPECT_EQ(axi_.write(kDebounce, 7), AxiResp::kSlvErr);
  write(kPulse + pulse::kCtrlOffset, 0);
  write(kDirHold, 31);
  write(kDebounce, 7);
}

// A new block is on the read path while another one is on the write path.
TEST_P(ArmSocTest, ReadsAndWritesOfDifferentBlocksOverlap) {
  for (std::uint32_t i = 0; i < 24; ++i) {
    axi_.post_write(i % 4 == 3 ? 0x4000'0000u : kPulse + pulse::kCountOffset + 4 * (i % kAxes), i);
    axi_.post_read(i % 3 == 0 ? kEncoder : i % 3 == 1 ? kPulse : 0x43C6'0000u);
  }
  axi_.drain();
  ASSERT_EQ(axi_.write_answers.size(), 24u);
  ASSERT_EQ(axi_.read_answers.size(), 24u);
  for (std::uint32_t i = 0; i < 24; ++i) {
    EXPECT_EQ(axi_.write_answers[i], i % 4 == 3 ? AxiResp::kDecErr : AxiResp::kOkay) << i;
    const AxiReadResult expected = i % 3 == 0   ? AxiReadResult{AxiResp::kOkay, 0x454E'0106u}
                                   : i % 3 == 1 ? AxiReadResult{AxiResp::kOkay, 0x5054'0106u}
                                                : AxiReadResult{AxiResp::kDecErr, 0};
    EXPECT_EQ(axi_.read_answers[i], expected) << i;
  }
}

// Clocks from the acceptance of a request to VALID of its response, as rtl/axi/README.md states them.
TEST_P(ArmSocTest, AnUnstalledAccessTakesTheDocumentedNumberOfClocks) {
  dut_.s_axi_bready_i = dut_.s_axi_rready_i = 1;
  struct Access {
    std::uint32_t addr;
    int write_clocks, read_clocks;
  };
  for (const Access& access : {Access{kTlr0, 6, 5}, Access{kEncoder + enc::kDebounceOffset, 6, 5}, Access{0, 2, 2}}) {
    int clocks = 0;
    dut_.s_axi_awaddr_i = access.addr;
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 1;
    for (clocks = 0; clocks < 20 && !dut_.s_axi_bvalid_o; ++clocks) {
      clock();
      dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 0;
    }
    EXPECT_EQ(clocks, access.write_clocks) << "write " << std::hex << access.addr;
    clock();
    dut_.s_axi_araddr_i = access.addr;
    dut_.s_axi_arvalid_i = 1;
    for (clocks = 0; clocks < 20 && !dut_.s_axi_rvalid_o; ++clocks) {
      clock();
      dut_.s_axi_arvalid_i = 0;
    }
    EXPECT_EQ(clocks, access.read_clocks) << "read " << std::hex << access.addr;
    clock();
  }
}

// The clock of axi_gpio and axi_uart16550 has stopped: their bus ports hang.
class ArmSocHang : public ArmSocTest {
 protected:
  void clock() override {
    if (!hung_) return ArmSocTest::clock();
    cosim::eval_edge(dut_, cosim::needed_clocks(dut_, 0, cosim::kIoClock));
    ++cycle_;
  }
  bool hung_ = false;
};
INSTANTIATE_AXI_STALLS(ArmSocHang);

TEST_P(ArmSocHang, ABlockThatHangsAnswersAnErrorAndTheOthersGoOn) {
  write(kGpio, 1);
  hung_ = true;
  EXPECT_EQ(axi_.write(kGpio, 2), AxiResp::kSlvErr);
  EXPECT_EQ(axi_.read(kUart + 0x14), (AxiReadResult{AxiResp::kSlvErr, 0}));
  write(kPulse + regs::pulse_train::kDirHoldOffset, 77);
  EXPECT_EQ(read(kPulse + regs::pulse_train::kDirHoldOffset), 77u);
  EXPECT_EQ(axi_.read(kGpio), (AxiReadResult{AxiResp::kSlvErr, 0}));
}

// The clock stops at any clock of an access. The access after it never gets the response of this one.
TEST_P(ArmSocHang, ABlockThatStopsDuringAnAccessAnswersAnErrorToTheNext) {
  for (int clocks = 0; clocks < 16; ++clocks) {
    for (const bool is_read : {false, true}) {
      SCOPED_TRACE(testing::Message() << (is_read ? "read" : "write") << ", clocks " << clocks);
      dut_.rst_ni = 0;
      hung_ = false;
      axi_.step(kResetCycles);
      dut_.rst_ni = 1;
      if (is_read) {
        axi_.post_read(kGpio);
      } else {
        axi_.post_write(kGpio, 1);
      }
      axi_.step(clocks);
      hung_ = true;
      axi_.step(400);
      EXPECT_EQ(axi_.read_answers.size() + axi_.write_answers.size(), 1u);
      axi_.read_answers.clear();
      axi_.write_answers.clear();
      EXPECT_EQ(axi_.write(kGpio, 2), AxiResp::kSlvErr);
      EXPECT_EQ(axi_.read(kGpio), (AxiReadResult{AxiResp::kSlvErr, 0}));
    }
  }
}

TEST_P(ArmSocTest, NoOutputFollowsAnInputPinWithoutAClock) {
  start_timer();
  commit({200, -200, 50, -50, 7, 0});
  SplitMix random{3};
  environment_ = [&] {
    const std::uint64_t before = cosim::output_word(dut_);
    cosim::SocInputs inputs;
    for (const cosim::Pin& pin : cosim::kPins) {
      if (pin.is_input()) pin.set(inputs, static_cast<std::uint32_t>(random.next()) & pin.max_value());
    }
    inputs.estop_n = false;
    cosim::drive_pins(dut_, inputs);
    dut_.eval();
    EXPECT_EQ(cosim::output_word(dut_), before);
    dut_.estop_ni = 1;  // before the clock edge: the pulses go on
  };
  axi_.step(3 * static_cast<int>(kTick));
  EXPECT_EQ(rises_[0].size(), 200u);
}

}  // namespace
}  // namespace armature::test
