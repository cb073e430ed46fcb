// The variant of the paper, PaperFabric = 1: half periods instead of counts, one decoder behind a switch. What its
// blocks do is the subject of their own tests.
#include <cstdint>

#include "Varm_soc_paper_test.h"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/encoder_switch_regs.hpp"
#include "controller/regs/pulse_width_regs.hpp"
#include "cosim/fabric/model_pins.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace width = regs::pulse_width;
namespace enc = regs::encoder;

constexpr std::uint32_t kTimer = 0x4280'0000u, kPulse = 0x43C1'0000u, kEncoder = 0x43C2'0000u, kSwitch = 0x43C3'0000u;

class ArmSocPaperTest : public AxiStallTest<Varm_soc_paper_test> {
 protected:
  void SetUp() override {
    cosim::drive_pins(dut_, cosim::SocInputs{});
    AxiStallTest::SetUp();
  }
  void clock() override {
    const unsigned step = dut_.step_o;
    tick();
    for (std::size_t axis = 0; axis < 6; ++axis) rises_[axis] += (dut_.step_o & ~step & (1u << axis)) != 0;
    if (dut_.trigger_o) ++triggers_;
  }
  void start_timer() {
    write(kTimer + 4, 2498);
    write(kTimer, 0x020);
    write(kTimer, 0x0D6);
  }
  void run_to_trigger() {
    const int seen = triggers_;
    for (int i = 0; i < 5000 && triggers_ == seen; ++i) axi_.step();
    axi_.step();
  }

  int rises_[6] = {};
  int triggers_ = 0;
};
INSTANTIATE_AXI_STALLS(ArmSocPaperTest);

TEST_P(ArmSocPaperTest, ItsBlocksAnswerAtTheirBases) {
  EXPECT_EQ(read(kPulse), 0x5057'0106u);    // "PW", map version 1, 6 axes
  EXPECT_EQ(read(kEncoder), 0x454E'0101u);  // one decoder
  EXPECT_EQ(read(kSwitch + regs::encoder_switch::kSelectOffset), 0u);
  EXPECT_EQ(axi_.read(0x43C4'0000u).resp, AxiResp::kDecErr);
}

TEST_P(ArmSocPaperTest, HalfPeriodsBecomePulsesOfEveryAxis) {
  start_timer();
  write(kPulse + width::kCtrlOffset, 0x3F);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t half_period = 25 * (i + 1);
    write(kPulse + width::kWidthOffset + 4 * i, i % 2 == 0 ? half_period : 0u - half_period);
  }
  run_to_trigger();
  for (int& rises : rises_) rises = 0;
  run_to_trigger();
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(rises_[i], (2499 / (25 * (i + 1)) + 1) / 2) << i;
    EXPECT_EQ(dut_.dir_o >> i & 1, i % 2 == 0) << i;
  }
  EXPECT_EQ(dut_.servo_on_o, 0x3F);
}

TEST_P(ArmSocPaperTest, TheDriveEnablesProtectTheFilters) {
  for (std::uint32_t axis = 0; axis < 6; ++axis) {
    write(kPulse + width::kCtrlOffset, 1U << axis);
    EXPECT_EQ(axi_.write(kEncoder + 0x04, 6), AxiResp::kSlvErr);
  }
  write(kEncoder + 0x3C, 0x454E'4B59);
  write(kEncoder + 0x04, 6);
}

TEST_P(ArmSocPaperTest, TheDecoderSeesTheSelectedEncoder) {
  start_timer();
  const auto turn = [&](unsigned axis, int counts) {
    static constexpr unsigned kA[] = {0, 1, 1, 0}, kB[] = {0, 0, 1, 1};
    for (int i = 1; i <= counts; ++i) {
      dut_.enc_a_i = static_cast<CData>(kA[i % 4] << axis);
      dut_.enc_b_i = static_cast<CData>(kB[i % 4] << axis);
      axi_.step(40);
    }
  };
  for (unsigned axis = 0; axis < 6; ++axis) {
    write(kSwitch + regs::encoder_switch::kSelectOffset, axis);
    run_to_trigger();
    const std::uint32_t before = read(kEncoder + enc::kPositionOffset);
    turn(axis, 8);
    turn((axis + 1) % 6, 12);  // nobody looks
    run_to_trigger();
    EXPECT_EQ(read(kEncoder + enc::kPositionOffset) - before, 8u) << axis;
  }
}

}  // namespace
}  // namespace armature::test
