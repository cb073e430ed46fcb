// The whole programmable logic: where each block answers, which pin belongs to which axis and block, and that the
// trigger ties timer, pulses and positions together. What a block does is the subject of its own tests.
#include <array>
#include <functional>
#include <vector>

#include "Varm_soc.h"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/field.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace pulse = regs::pulse_train;
namespace enc = regs::encoder;

// Written out on purpose: software and documents rely on these numbers.
constexpr std::uint32_t kGpio = 0x4120'0000u, kUart = 0x43C0'1000u;
constexpr std::uint32_t kTimer = 0x4280'0000u, kPulse = 0x43C1'0000u, kEncoder = 0x43C2'0000u;
constexpr std::uint32_t kTcsr0 = kTimer + 0x00, kTlr0 = kTimer + 0x04;
constexpr std::uint32_t kLoad = 0x020, kTimerAck = 0x1D6, kTimerRun = 0x0D6;  // down, GENT, ARHT, ENIT, ENT
constexpr std::uint32_t kAxes = 6, kAllAxes = 0x3F;
constexpr std::int64_t kTick = 2500;

class ArmSocTest : public AxiStallTest<Varm_soc> {
 protected:
  void SetUp() override {
    for (CData* pin : axis_pins_) *pin = 0;
    dut_.estop_ni = 1;
    dut_.uart_rxd_i = 1;
    dut_.capture_trig_i = 0;
    dut_.gpio_i = 0;
    AxiStallTest::SetUp();
  }

  void clock() override {
    const unsigned step = dut_.step_o;
    if (surroundings_) surroundings_();
    tick();
    if (dut_.trigger_o) triggers_.push_back(cycle_);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (dut_.step_o & ~step & (1u << axis)) rises_[axis].push_back(cycle_);
    }
  }

  void write(std::uint32_t addr, std::uint32_t value) {
    EXPECT_EQ(axi_.write(addr, value), AxiResp::kOkay) << std::hex << addr;
  }
  std::uint32_t read(std::uint32_t addr) {
    const AxiReadResult result = axi_.read(addr);
    EXPECT_EQ(result.resp, AxiResp::kOkay) << std::hex << addr;
    return result.data;
  }

  void start_timer() {
    write(kTlr0, kTick - 2);
    write(kTcsr0, kLoad);
    write(kTcsr0, kTimerRun);
  }
  void run_to_trigger() {
    const std::size_t seen = triggers_.size();
    for (int i = 0; i < 2 * kTick && triggers_.size() == seen; ++i) axi_.step();
    ASSERT_GT(triggers_.size(), seen) << "no trigger";
    axi_.step();  // the edge on which the blocks see it
  }
  // Cycle of the last trigger; -1 if there was none.
  std::int64_t last_trigger() const { return triggers_.empty() ? -1 : triggers_.back(); }
  void commit(const std::array<int, kAxes>& counts) {
    for (std::uint32_t i = 0; i < kAxes; ++i) {
      write(kPulse + pulse::kCountOffset + 4 * i, static_cast<std::uint32_t>(counts[i]) & 0xFFFFu);
    }
    write(kPulse + pulse::kCommitOffset, 1);
  }

  // Input pins with one bit per axis.
  const std::array<CData*, 8> axis_pins_{&dut_.enc_a_i,       &dut_.enc_b_i,      &dut_.enc_z_i,
                                         &dut_.home_i,        &dut_.limit_pos_i,  &dut_.limit_neg_i,
                                         &dut_.drive_alarm_i, &dut_.in_position_i};
  std::vector<std::int64_t> triggers_;                  // cycles in which trigger_o was high
  std::array<std::vector<std::int64_t>, kAxes> rises_;  // first cycles of each pulse
  std::function<void()> surroundings_;                  // drives input pins before each edge
};
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
  write(kTlr0, 0xCAFE'F00Du);
  EXPECT_EQ(read(kTlr0), 0xCAFE'F00Du);
  EXPECT_EQ(read(kPulse + pulse::kTickCyclesOffset), static_cast<std::uint32_t>(kTick));
}

TEST_P(ArmSocTest, GapsOfTheMapAnswerDecErr) {
  for (const std::uint32_t addr : {0x0000'0000u, 0x411F'FFFCu, 0x4121'0000u, 0x427F'FFFCu, 0x4281'0000u, 0x43BF'FFFCu,
                                   0x43C3'0000u, 0x43C4'0000u, 0xC280'0000u, 0xFFFF'FFFCu}) {
    EXPECT_EQ(axi_.read(addr).resp, AxiResp::kDecErr) << std::hex << addr;
    EXPECT_EQ(axi_.write(addr, 0xFFFF'FFFFu), AxiResp::kDecErr) << std::hex << addr;
  }
  EXPECT_EQ(read(kTcsr0), 0u);
}

TEST_P(ArmSocTest, UnmappedOffsetsOfABlockAnswerSlvErr) {
  for (const std::uint32_t base : {kTimer, kPulse, kEncoder}) {
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

// 8N1, divisor 1: 16 clocks a bit. What is sent comes back through a wire between the pins.
TEST_P(ArmSocTest, SerialPinsAndTheirInterruptBelongToTheUart) {
  surroundings_ = [this] { dut_.uart_rxd_i = dut_.uart_txd_o; };
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

// A new block is on the read path while another one is on the write path.
TEST_P(ArmSocTest, ReadsAndWritesOfDifferentBlocksOverlap) {
  for (std::uint32_t i = 0; i < 24; ++i) {
    axi_.post_write(i % 4 == 3 ? 0x4000'0000u : kPulse + pulse::kCountOffset + 4 * (i % kAxes), i);
    axi_.post_read(i % 3 == 0 ? kEncoder : i % 3 == 1 ? kPulse : 0x43C4'0000u);
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

TEST_P(ArmSocTest, NoOutputFollowsAnInputPinWithoutAClock) {
  start_timer();
  commit({200, -200, 50, -50, 7, 0});
  SplitMix random{3};
  surroundings_ = [&] {
    const unsigned before = static_cast<unsigned>(dut_.step_o | dut_.dir_o << 6 | dut_.servo_on_o << 12 |
                                                  dut_.trigger_o << 18 | dut_.irq_o << 19);
    for (CData* pin : axis_pins_) {
      *pin = static_cast<CData>(random.below(64));
    }
    dut_.estop_ni = 0;
    dut_.eval();
    EXPECT_EQ(before, static_cast<unsigned>(dut_.step_o | dut_.dir_o << 6 | dut_.servo_on_o << 12 |
                                            dut_.trigger_o << 18 | dut_.irq_o << 19));
    dut_.estop_ni = 1;  // before the clock edge: the pulses go on
  };
  axi_.step(3 * static_cast<int>(kTick));
  EXPECT_EQ(rises_[0].size(), 200u);
}

TEST_P(ArmSocTest, TriggerComesEvery2500ClocksAndRaisesTheInterrupt) {
  start_timer();
  for (int i = 0; i < 8; ++i) {
    EXPECT_FALSE(dut_.irq_o);
    run_to_trigger();
    EXPECT_FALSE(dut_.trigger_o) << "wider than one clock";
    EXPECT_TRUE(dut_.irq_o) << "in the clock after the trigger";
    write(kTcsr0, kTimerAck);
  }
  for (std::size_t i = 1; i < triggers_.size(); ++i) EXPECT_EQ(triggers_[i] - triggers_[i - 1], kTick);
}

TEST_P(ArmSocTest, SixAxesStartOnTheSameClockAndEmitWhatWasCommitted) {
  start_timer();
  run_to_trigger();
  commit({200, 200, 200, 200, 200, 200});
  axi_.step(100);
  for (const auto& axis : rises_) EXPECT_TRUE(axis.empty()) << "pulses before the trigger";
  run_to_trigger();
  const std::int64_t start = last_trigger();
  commit({0, 0, 0, 0, 0, 0});
  run_to_trigger();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    ASSERT_EQ(rises_[axis].size(), 200u) << "axis " << axis + 1;
    EXPECT_EQ(rises_[axis], rises_[0]) << "axis " << axis + 1;
    EXPECT_GT(rises_[axis].front(), start);
    EXPECT_LE(rises_[axis].back(), last_trigger());
    EXPECT_EQ(read(kPulse + pulse::kEmittedOffset + 4 * static_cast<std::uint32_t>(axis)), 200u);
  }
}

TEST_P(ArmSocTest, EachCountAndServoBitDrivesThePinsOfItsAxis) {
  start_timer();
  run_to_trigger();
  commit({1, -2, 3, -4, 5, -6});
  run_to_trigger();
  commit({0, 0, 0, 0, 0, 0});
  run_to_trigger();
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(rises_[axis].size(), axis + 1) << "axis " << axis + 1;
  EXPECT_EQ(dut_.dir_o, 0b010101);
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    write(kPulse + pulse::kCtrlOffset, 1u << axis);
    axi_.step(4);
    EXPECT_EQ(dut_.servo_on_o, 1u << axis);
  }
}

TEST_P(ArmSocTest, EachSwitchAndDrivePinReachesItsRegisterBit) {
  struct Pin {
    CData& port;
    std::uint32_t offset;
    regs::Field field;
  };
  for (const Pin& pin : {Pin{dut_.home_i, pulse::kSwitchesOffset, pulse::kSwitchesHome},
                         Pin{dut_.limit_pos_i, pulse::kSwitchesOffset, pulse::kSwitchesLimitPos},
                         Pin{dut_.limit_neg_i, pulse::kSwitchesOffset, pulse::kSwitchesLimitNeg},
                         Pin{dut_.drive_alarm_i, pulse::kDrivesOffset, pulse::kDrivesAlarm},
                         Pin{dut_.in_position_i, pulse::kDrivesOffset, pulse::kDrivesInPosition}}) {
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      pin.port = static_cast<CData>(1u << axis);
      axi_.step(8);
      EXPECT_EQ(read(kPulse + pin.offset), 1u << (pin.field.lsb + axis));
    }
    pin.port = 0;
    axi_.step(8);
  }
}

TEST_P(ArmSocTest, EmergencyStopPinStopsThePulsesOfAllAxes) {
  start_timer();
  write(kPulse + pulse::kCtrlOffset, kAllAxes);
  run_to_trigger();
  commit({200, 200, 200, -200, -200, -200});
  run_to_trigger();
  axi_.step(500);
  EXPECT_EQ(dut_.servo_on_o, kAllAxes);
  dut_.estop_ni = 0;
  axi_.step(4);
  EXPECT_EQ(dut_.servo_on_o, 0);
  for (auto& axis : rises_) axis.clear();
  axi_.step(5000);
  for (const auto& axis : rises_) EXPECT_TRUE(axis.empty());
  EXPECT_TRUE(read(kPulse + pulse::kStatusOffset) & pulse::kStatusEstopMask);
}

// Axis i turns i+1 counts forward (even i) or back (odd i), one count every 40 clocks.
TEST_P(ArmSocTest, EachEncoderCountsOnItsAxisAndTheTriggerSnapshotsAll) {
  start_timer();
  axi_.step(50);
  std::array<int, kAxes> phase{};
  const auto turn = [&](std::size_t axis, int counts) {
    phase[axis] += counts;
    const unsigned gray = static_cast<unsigned>(phase[axis]) & 3u;  // 00 01 11 10: A leads B
    const CData mask = static_cast<CData>(1u << axis);
    const bool a = gray == 1 || gray == 2, b = gray >= 2;
    dut_.enc_a_i = static_cast<CData>(a ? dut_.enc_a_i | mask : dut_.enc_a_i & ~mask);
    dut_.enc_b_i = static_cast<CData>(b ? dut_.enc_b_i | mask : dut_.enc_b_i & ~mask);
  };
  std::array<std::uint32_t, kAxes> expected{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::size_t i = 0; i <= axis; ++i) {
      turn(axis, axis % 2 == 0 ? 1 : -1);
      axi_.step(40);
    }
    expected[axis] =
        static_cast<std::uint32_t>(axis % 2 == 0 ? static_cast<int>(axis) + 1 : -static_cast<int>(axis) - 1);
  }
  const auto positions = [&] {
    std::array<std::uint32_t, kAxes> all{};
    for (std::uint32_t i = 0; i < kAxes; ++i) all[i] = read(kEncoder + enc::kPositionOffset + 4 * i);
    return all;
  };
  EXPECT_EQ(positions(), (std::array<std::uint32_t, kAxes>{})) << "positions are snapshots";
  run_to_trigger();
  EXPECT_EQ(read(kEncoder + enc::kFaultOffset), 0u);
  // The direction that counts up is the decoder's business; here all axes must agree on one.
  const auto seen = positions();
  const std::uint32_t sign = seen[0] == 1u ? 1u : 0xFFFF'FFFFu;
  for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(seen[i] * sign, expected[i]) << "axis " << i + 1;
}

TEST_P(ArmSocTest, EachIndexPinLatchesOnItsAxis) {
  axi_.step(50);
  std::uint32_t seen = 0;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    dut_.enc_z_i = static_cast<CData>(1u << axis);
    axi_.step(40);
    seen |= 1u << axis;
    EXPECT_EQ(read(kEncoder + enc::kIndexSeenOffset), seen);
    dut_.enc_z_i = 0;
    axi_.step(40);
  }
}

// The trigger pin is the trigger of the blocks: TRIGGER_TIME is the clock in which it was high.
TEST_P(ArmSocTest, SnapshotsAreTakenByTheEdgeAfterTheTriggerPin) {
  start_timer();
  run_to_trigger();
  run_to_trigger();
  EXPECT_EQ(static_cast<std::int64_t>(read(kEncoder + enc::kTriggerTimeOffset)), last_trigger());
}

}  // namespace
}  // namespace armature::test
