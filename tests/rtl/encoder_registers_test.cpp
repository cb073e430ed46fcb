// encoder through its AXI port: every register shows or sets the thing it is named after, on the right axis.
#include "Vencoder.h"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/field.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace reg = regs::encoder;

constexpr int kAxes = 6;

class EncoderRegisters : public AxiStallTest<Vencoder> {
 protected:
  void SetUp() override {
    dut_.enc_a_i = dut_.enc_b_i = dut_.enc_z_i = 0;
    dut_.trigger_i = dut_.servo_on_i = 0;
    AxiStallTest::SetUp();
    tick(20);
  }

  std::uint32_t read_axis(std::uint32_t first, int axis) { return read(first + 4 * static_cast<std::uint32_t>(axis)); }

  // Lines B that change with every clock, one bit per axis.
  void clock() override {
    dut_.enc_b_i ^= chatter_;
    tick();
  }

  // A, B and Z of one axis.
  void pins(int axis, bool a, bool b, bool z = false) {
    const auto put = [axis](std::uint8_t word, bool level) {
      return static_cast<std::uint8_t>((word & ~(1 << axis)) | level << axis);
    };
    dut_.enc_a_i = put(dut_.enc_a_i, a);
    dut_.enc_b_i = put(dut_.enc_b_i, b);
    dut_.enc_z_i = put(dut_.enc_z_i, z);
    tick(20);
  }

  void turn(int axis, int counts) {
    for (int i = 1; i <= counts; ++i) pins(axis, i % 4 == 1 || i % 4 == 2, i % 4 == 2 || i % 4 == 3);
  }

  std::uint32_t snapshot() {
    dut_.trigger_i = 1;
    tick();
    dut_.trigger_i = 0;
    return static_cast<std::uint32_t>(cycle_ - 1);
  }

  std::uint8_t chatter_ = 0;
};
INSTANTIATE_AXI_STALLS(EncoderRegisters);

TEST_P(EncoderRegisters, IdentifiesItself) {
  EXPECT_EQ(read(reg::kIdOffset), 0x454E'0106U);
}

TEST_P(EncoderRegisters, ResetValuesReadBack) {
  EXPECT_EQ(read(reg::kDebounceOffset), reg::kDebounceTimeReset);
  EXPECT_EQ(read(reg::kIndexCheckOffset), 0U);
  EXPECT_EQ(read(reg::kFaultOffset), 0U);
  EXPECT_EQ(read(reg::kTriggerTimeOffset), 0U);
  EXPECT_EQ(read(reg::kIndexSeenOffset), 0U);
  for (int axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(read_axis(reg::kCountsPerRevOffset, axis), reg::kCountsPerRevValueReset);
    for (const std::uint32_t first : {reg::kPositionOffset, reg::kEdgeTimeOffset, reg::kIndexPositionOffset,
                                      reg::kIllegalCountOffset, reg::kGlitchCountOffset}) {
      EXPECT_EQ(read_axis(first, axis), 0U) << std::hex << first;
    }
  }
}

// The levels of a line that never rests are never accepted: its axis counts nothing, and says so.
TEST_P(EncoderRegisters, ShowsWhichAxesAreKnown) {
  EXPECT_EQ(read(reg::kKnownOffset), 0x3FU);
  EXPECT_EQ(axi_.write(reg::kKnownOffset, 0), AxiResp::kSlvErr);
  dut_.rst_ni = 0;
  axi_.step(kResetCycles);
  dut_.rst_ni = 1;
  chatter_ = 1 << 4;
  axi_.step(100);
  EXPECT_EQ(read(reg::kKnownOffset), 0x2FU);
  EXPECT_EQ(read(reg::kFaultOffset), 0U);
  chatter_ = 0;
  axi_.step(20);
  EXPECT_EQ(read(reg::kKnownOffset), 0x3FU);
}

TEST_P(EncoderRegisters, ShowsPositionAndTimesPerAxis) {
  for (int axis = 0; axis < kAxes; ++axis) turn(axis, 4 * axis + 1);
  const std::uint32_t time = snapshot();
  EXPECT_EQ(read(reg::kTriggerTimeOffset), time);
  std::uint32_t last = 0;
  for (int axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(read_axis(reg::kPositionOffset, axis), static_cast<std::uint32_t>(4 * axis + 1));
    const std::uint32_t edge_time = read_axis(reg::kEdgeTimeOffset, axis);
    EXPECT_GT(edge_time, last);
    EXPECT_LT(edge_time, time);
    last = edge_time;
  }
}

TEST_P(EncoderRegisters, LatchesIndexAndChecksItPerAxis) {
  write(reg::kIndexCheckOffset, 0x3F);
  for (int axis = 0; axis < kAxes; ++axis) {
    write(reg::kCountsPerRevOffset + 4 * static_cast<std::uint32_t>(axis), static_cast<std::uint32_t>(axis + 1));
  }
  std::uint32_t seen = 0;
  for (int axis = 0; axis < kAxes; ++axis) {
    pins(axis, false, false, true);
    pins(axis, false, false, false);
    seen |= 1U << axis;
    EXPECT_EQ(read(reg::kIndexSeenOffset), seen);
    turn(axis, axis + 1);
    const bool a = dut_.enc_a_i >> axis & 1, b = dut_.enc_b_i >> axis & 1;
    pins(axis, a, b, true);
    EXPECT_EQ(read_axis(reg::kIndexPositionOffset, axis), static_cast<std::uint32_t>(axis + 1));
  }
  EXPECT_EQ(read(reg::kFaultOffset), 0U);
  // Axis 3 again, one count later.
  const auto event_after = static_cast<std::uint32_t>(cycle_);
  pins(2, false, true, false);
  pins(2, false, false, true);
  EXPECT_EQ(read(reg::kFaultOffset), 1U << (8 + 2));
  EXPECT_GT(read(reg::kFaultTimeOffset + 4), event_after);
  EXPECT_EQ(read(reg::kFaultTimeOffset), 0U);
  write(reg::kFaultOffset, 1U << (8 + 2));
  EXPECT_EQ(read(reg::kFaultOffset), 0U);
}

TEST_P(EncoderRegisters, CountsIllegalTransitionsAndGlitchesPerAxis) {
  for (int axis = 0; axis < kAxes; ++axis) {
    for (int i = 0; i <= axis; ++i) pins(axis, i % 2 == 0, i % 2 == 0);
    for (int i = 0; i < 2 * axis; ++i) {
      dut_.enc_z_i = static_cast<std::uint8_t>(1 << axis);
      tick(2);
      dut_.enc_z_i = 0;
      tick(10);
    }
  }
  EXPECT_EQ(read(reg::kFaultOffset), 0x3FU);
  for (int axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(read_axis(reg::kIllegalCountOffset, axis), static_cast<std::uint32_t>(axis + 1));
    EXPECT_EQ(read_axis(reg::kGlitchCountOffset, axis), static_cast<std::uint32_t>(2 * axis));
  }
  write(reg::kFaultOffset, 0x15);
  EXPECT_EQ(read(reg::kFaultOffset), 0x2AU);
}

TEST_P(EncoderRegisters, DebounceTimeIsSettable) {
  write(reg::kDebounceOffset, 50);
  EXPECT_EQ(read(reg::kDebounceOffset), 50U);
  dut_.enc_a_i = 1;
  tick(49);
  dut_.enc_a_i = 0;
  tick(60);
  EXPECT_EQ(read_axis(reg::kGlitchCountOffset, 0), 1U);
}

TEST_P(EncoderRegisters, FiltersAreProtectedWhileADriveIsEnabled) {
  constexpr std::uint32_t kKey = 0x3C, kKeyWord = 0x454E'4B59;
  const auto expect_protected = [this](bool is) {
    for (const std::uint32_t offset : {0x04U, 0x0CU}) {
      const std::uint32_t before = read(offset);
      EXPECT_EQ(axi_.write(offset, before ^ 1), is ? AxiResp::kSlvErr : AxiResp::kOkay) << std::hex << offset;
      EXPECT_EQ(read(offset), is ? before : before ^ 1) << std::hex << offset;
    }
    EXPECT_EQ(axi_.write(reg::kIndexCheckOffset, 0x3F), AxiResp::kOkay) << "not protected";
  };
  expect_protected(false);
  for (int axis = 0; axis < kAxes; ++axis) {
    dut_.servo_on_i = static_cast<std::uint8_t>(1 << axis);
    expect_protected(true);
  }
  EXPECT_EQ(read(kKey), 0U);
  write(kKey, kKeyWord);
  EXPECT_EQ(read(kKey), 1U);
  expect_protected(false);
  write(kKey, kKeyWord ^ 0x80);
  expect_protected(true);
  dut_.servo_on_i = 0;
  expect_protected(false);
}

// Line A of axis 1 rises and then chatters: low in one cycle of five, for ever.
TEST_P(EncoderRegisters, FilterModeIsSettable) {
  EXPECT_EQ(read(reg::kFilterOffset), reg::kFilterModeReset);
  for (const std::uint32_t mode : {0U, 1U}) {
    write(reg::kFilterOffset, mode);
    EXPECT_EQ(read(reg::kFilterOffset), mode);
    dut_.enc_a_i = dut_.enc_b_i = 0;
    tick(100);
    snapshot();
    const std::uint32_t before = read_axis(reg::kPositionOffset, 0);
    for (int cycle = 0; cycle < 1000; ++cycle) {
      dut_.enc_a_i = cycle % 5 != 4;
      tick();
    }
    snapshot();
    dut_.enc_a_i = 0;
    EXPECT_EQ(read_axis(reg::kPositionOffset, 0) - before, mode);
    EXPECT_EQ(read(reg::kFaultOffset), 0U);
  }
  EXPECT_EQ(axi_.write(reg::kFilterOffset, 0xFFFF'FFFE), AxiResp::kOkay);
  EXPECT_EQ(read(reg::kFilterOffset), 0U);
}

}  // namespace
}  // namespace armature::test
