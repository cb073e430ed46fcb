// encoder_switch alone, and in front of an encoder block with one axis: what one decoder sees of six encoders.
#include <array>
#include <cstdint>
#include <optional>

#include "Vencoder_single.h"
#include "Vencoder_switch.h"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/encoder_switch_regs.hpp"
#include "tests/rtl/encoder_fixture.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace sw = regs::encoder_switch;
namespace en = regs::encoder;

class EncoderSwitchRegisters : public AxiStallTest<Vencoder_switch> {
 protected:
  void SetUp() override {
    dut_.enc_a_i = dut_.enc_b_i = dut_.enc_z_i = 0;
    AxiStallTest::SetUp();
  }
};
INSTANTIATE_AXI_STALLS(EncoderSwitchRegisters);

TEST_P(EncoderSwitchRegisters, IdentifiesItselfAndKeepsItsSelection) {
  EXPECT_EQ(axi_.read(0x00), (AxiReadResult{AxiResp::kOkay, 0x5357'0106U}));
  EXPECT_EQ(axi_.read(0x04), (AxiReadResult{AxiResp::kOkay, 0U}));
  for (std::uint32_t axis = 0; axis < 8; ++axis) {
    EXPECT_EQ(axi_.write(0x04, 0xFFFF'FFF8U | axis), AxiResp::kOkay);
    EXPECT_EQ(axi_.read(0x04), (AxiReadResult{AxiResp::kOkay, axis}));
  }
  EXPECT_EQ(axi_.write(0x04, 0, 0xE), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(0x04).data, 7U) << "byte 0 not enabled";
  EXPECT_EQ(axi_.write(0x00, 0), AxiResp::kSlvErr);
  EXPECT_EQ(axi_.write(0x08, 0), AxiResp::kSlvErr);
  EXPECT_EQ(axi_.read(0x08), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5}));
}

TEST_P(EncoderSwitchRegisters, PassesTheLinesOfTheSelectedEncoderOneEdgeLater) {
  for (std::uint32_t axis = 0; axis < 8; ++axis) {
    ASSERT_EQ(axi_.write(sw::kSelectOffset, axis), AxiResp::kOkay);
    for (int bits = 0; bits < 1 << 18; bits = 5 * bits / 3 + 1) {
      dut_.enc_a_i = static_cast<std::uint8_t>(bits & kAllAxes);
      dut_.enc_b_i = static_cast<std::uint8_t>(bits >> 6 & kAllAxes);
      dut_.enc_z_i = static_cast<std::uint8_t>(bits >> 12 & kAllAxes);
      axi_.step();
      const bool exists = axis < kAxes;
      ASSERT_EQ(dut_.enc_a_o, exists && (dut_.enc_a_i >> axis & 1)) << axis;
      ASSERT_EQ(dut_.enc_b_o, exists && (dut_.enc_b_i >> axis & 1)) << axis;
      ASSERT_EQ(dut_.enc_z_o, exists && (dut_.enc_z_i >> axis & 1)) << axis;
    }
  }
}

// The switch, the decoder and six discs on one clock.
class OneDecoder : public VerilatedTest<Vencoder_switch> {
 protected:
  OneDecoder() {
    decoder_.trigger_i = decoder_.servo_on_i = 0;
    restart();
  }
  ~OneDecoder() override { decoder_.final(); }

  void restart() {
    drive_pins();
    switch_bus_.reset();
    decoder_bus_.reset();
    dut_.rst_ni = decoder_.rst_ni = 0;
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = dut_.s_axi_arvalid_i = 0;
    decoder_.s_axi_awvalid_i = decoder_.s_axi_wvalid_i = decoder_.s_axi_arvalid_i = 0;
    clock(kResetCycles);
    dut_.rst_ni = decoder_.rst_ni = 1;
    switch_bus_.emplace(
        dut_, [this] { clock(); }, AxiStall::kNone, 1);
    decoder_bus_.emplace(
        decoder_, [this] { clock(); }, AxiStall::kNone, 2);
    clock(20);
  }

  void drive_pins() {
    int a = 0, b = 0, z = 0;
    for (std::size_t i = 0; i < kAxes; ++i) {
      a |= discs_[i].a() << i;
      b |= discs_[i].b() << i;
      z |= discs_[i].z() << i;
    }
    dut_.enc_a_i = static_cast<std::uint8_t>(a);
    dut_.enc_b_i = static_cast<std::uint8_t>(b);
    dut_.enc_z_i = static_cast<std::uint8_t>(z);
  }

  void clock() {
    ++now_;
    if (moving_) {
      for (std::size_t i = 0; i < kAxes; ++i) discs_[i].position = 2 * now_ / 25 + static_cast<int>(i);  // 4 Mcount/s
    }
    drive_pins();
    decoder_.enc_a_i = dut_.enc_a_o;
    decoder_.enc_b_i = dut_.enc_b_o;
    decoder_.enc_z_i = dut_.enc_z_o;
    decoder_.clk_i = decoder_.clk_gated_i = 1;
    decoder_.eval();
    decoder_.clk_i = decoder_.clk_gated_i = 0;
    decoder_.eval();
    tick();
  }

  void clock(int cycles) {
    for (int i = 0; i < cycles; ++i) clock();
  }

  void select(std::uint32_t axis) {
    EXPECT_EQ(switch_bus_->write(sw::kSelectOffset, axis), AxiResp::kOkay);
    clock(20);
  }

  void turn(std::size_t axis, int counts) {
    for (int i = 0; i != counts; i += counts > 0 ? 1 : -1) {
      discs_[axis].position += counts > 0 ? 1 : -1;
      clock(13);
    }
    clock(20);
  }

  std::uint32_t read(std::uint32_t offset) {
    const AxiReadResult result = decoder_bus_->read(offset);
    EXPECT_EQ(result.resp, AxiResp::kOkay);
    return result.data;
  }

  std::int32_t position() {
    decoder_.trigger_i = 1;
    clock();
    decoder_.trigger_i = 0;
    return static_cast<std::int32_t>(read(en::kPositionOffset));
  }

  Vencoder_single decoder_{&context_};
  std::array<Disc, kAxes> discs_;
  std::optional<AxiLiteDriver<Vencoder_switch>> switch_bus_;
  std::optional<AxiLiteDriver<Vencoder_single>> decoder_bus_;
  std::int64_t now_ = 0;
  bool moving_ = false;
};

TEST_F(OneDecoder, SaysThatItHasOneAxis) {
  EXPECT_EQ(read(en::kIdOffset), 0x454E'0101U);
  EXPECT_EQ(read(en::kKnownOffset), 1U);
  for (std::uint32_t i = 1; i < kAxes; ++i) EXPECT_EQ(read(en::kPositionOffset + 4 * i), 0U);
}

TEST_F(OneDecoder, CountsOfDeselectedEncodersAreLost) {
  const int turns[] = {12, -8, 40, -44, 100, 4};  // whole quadrature periods: the switching itself counts nothing
  std::int32_t expected = 0;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
    select(axis);
    EXPECT_EQ(position(), expected) << "nothing moved";
    for (std::size_t i = 0; i < kAxes; ++i) turn(i, turns[i]);
    expected += turns[axis];
    EXPECT_EQ(position(), expected) << "axis " << axis + 1;
  }
  EXPECT_EQ(read(en::kFaultOffset), 0U);
}

TEST_F(OneDecoder, SwitchBetweenRestingEncodersIsDecodedAsAMove) {
  int moves = 0, illegals = 0;
  for (int from = 0; from < 4; ++from) {
    for (int to = 0; to < 4; ++to) {
      discs_[1].position = from;
      discs_[4].position = to;
      restart();
      select(1);
      EXPECT_EQ(decoder_bus_->write(en::kFaultOffset, 0x3F3F), AxiResp::kOkay);
      const std::int32_t before = position();
      select(4);
      const int step = (to - from + 4) % 4;  // 3: one back, 2: both lines
      EXPECT_EQ(position() - before, step == 1 ? 1 : step == 3 ? -1 : 0) << from << " to " << to;
      EXPECT_EQ(read(en::kFaultOffset), step == 2 ? 1U : 0U) << from << " to " << to;
      moves += step % 2;
      illegals += step == 2;
    }
  }
  EXPECT_EQ(moves, 8);
  EXPECT_EQ(illegals, 4);
}

// Six encoders at 4 Mcount/s, each seen for a sixth of the time.
TEST_F(OneDecoder, SixMovingEncodersInTurnKeepASixthOfTheirCounts) {
  moving_ = true;
  restart();
  select(0);
  const std::int64_t began = now_;
  const std::int32_t first = position();
  for (int round = 0; round < 20; ++round) {
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      select(axis);
      clock(380);
    }
  }
  const std::int64_t turned = kAxes * 2 * (now_ - began) / 25;
  const std::int64_t seen = position() - first;
  EXPECT_NEAR(static_cast<double>(seen) / static_cast<double>(turned), 1.0 / 6, 0.01);
}

TEST_F(OneDecoder, NoSelectedEncoderMeansLowLines) {
  discs_[0].position = 1;  // A high
  restart();
  select(0);
  const std::int32_t before = position();
  select(6);
  EXPECT_EQ(position() - before, -1);
  turn(0, 40);
  EXPECT_EQ(position() - before, -1);
}

}  // namespace
}  // namespace armature::test
