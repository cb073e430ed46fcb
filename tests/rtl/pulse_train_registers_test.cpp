// pulse_train through its AXI port under every stall pattern: what is stored, what is refused, and that a set gets
// through.
#include <array>

#include "Vpulse_train.h"
#include "controller/regs/field.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_train;

constexpr std::uint32_t kAxisRegisters = 6;

struct Writable {
  std::uint32_t offset, mask, reset;
};
// Written out on purpose, as the register table states them.
constexpr std::array<Writable, 12> kWritable = {{{0x04, 0x013F, 0},
                                                 {0x14, 0x00FF, 4},
                                                 {0x1C, 0x0FFF, 2500},
                                                 {0x20, 0x03FF, 25},
                                                 {0x24, 0x03FF, 25},
                                                 {0x28, 0xFFFF, 0},
                                                 {0x40, 0xFFFF, 0},
                                                 {0x44, 0xFFFF, 0},
                                                 {0x48, 0xFFFF, 0},
                                                 {0x4C, 0xFFFF, 0},
                                                 {0x50, 0xFFFF, 0},
                                                 {0x54, 0xFFFF, 0}}};
constexpr std::uint32_t kKey = 0x3C, kKeyWord = 0x5054'4B59;
constexpr std::array<std::uint32_t, 4> kProtected = {0x14, 0x1C, 0x20, 0x24};

class PulseTrainRegisters : public AxiStallTest<Vpulse_train> {
 protected:
  void SetUp() override {
    dut_.estop_ni = 1;
    dut_.trigger_i = 0;
    dut_.home_i = dut_.limit_pos_i = dut_.limit_neg_i = dut_.drive_alarm_i = dut_.in_position_i = 0;
    AxiStallTest::SetUp();
  }

  void trigger() {
    dut_.trigger_i = 1;
    axi_.step();
    dut_.trigger_i = 0;
  }
};
INSTANTIATE_AXI_STALLS(PulseTrainRegisters);

TEST_P(PulseTrainRegisters, ResetValuesReadBack) {
  for (const Writable& r : kWritable) EXPECT_EQ(read(r.offset), r.reset) << std::hex << r.offset;
  for (const std::uint32_t offset : {reg::kStatusOffset, reg::kEstopOffset, reg::kFaultOffset, reg::kUnderrunsOffset,
                                     reg::kSwitchesOffset, reg::kDrivesOffset}) {
    EXPECT_EQ(read(offset), 0U) << std::hex << offset;
  }
  for (const std::uint32_t first : {reg::kEmittedOffset, reg::kResidualOffset, reg::kFaultTimeOffset}) {
    for (std::uint32_t i = 0; i < kAxisRegisters; ++i) EXPECT_EQ(read(first + 4 * i), 0U) << std::hex << first + 4 * i;
  }
}

TEST_P(PulseTrainRegisters, EveryWritableBitIsItsOwn) {
  const auto pattern = [](std::uint32_t offset) { return 0x9E37'79B9U * (offset + 1); };
  write(kKey, kKeyWord);  // CTRL enables drives
  for (const Writable& r : kWritable) write(r.offset, pattern(r.offset));
  for (const Writable& r : kWritable) EXPECT_EQ(read(r.offset), pattern(r.offset) & r.mask) << std::hex << r.offset;
  for (const Writable& r : kWritable) write(r.offset, ~pattern(r.offset), 0x2);
  for (const Writable& r : kWritable) {
    EXPECT_EQ(read(r.offset), (pattern(r.offset) ^ 0xFF00U) & r.mask) << std::hex << r.offset;
  }
}

TEST_P(PulseTrainRegisters, ReadOnlyAndUnmappedOffsetsRefuseWrites) {
  for (const std::uint32_t offset : {reg::kIdOffset, reg::kStatusOffset, reg::kUnderrunsOffset, reg::kTimeOffset,
                                     reg::kSwitchesOffset, reg::kDrivesOffset, reg::kEmittedOffset,
                                     reg::kResidualOffset, reg::kFaultTimeOffset, 0x38U, 0x58U, 0xB8U, 0x1004U}) {
    EXPECT_EQ(axi_.write(offset, 0xFFFF'FFFFU), AxiResp::kSlvErr) << std::hex << offset;
  }
  EXPECT_EQ(read(reg::kCtrlOffset), 0U);
}

TEST_P(PulseTrainRegisters, TimesAndWatchdogAreProtectedWhileADriveIsEnabled) {
  const auto expect_protected = [this](bool is) {
    for (const std::uint32_t offset : kProtected) {
      const std::uint32_t before = read(offset);
      EXPECT_EQ(axi_.write(offset, before ^ 1), is ? AxiResp::kSlvErr : AxiResp::kOkay) << std::hex << offset;
      EXPECT_EQ(read(offset), is ? before : before ^ 1) << std::hex << offset;
    }
    EXPECT_EQ(axi_.write(reg::kCountOffset, 3), AxiResp::kOkay) << "not protected";
  };
  expect_protected(false);
  for (std::uint32_t axis = 0; axis < kAxisRegisters; ++axis) {
    write(reg::kCtrlOffset, 1U << axis);
    expect_protected(true);
  }
  write(reg::kEstopOffset, reg::kEstopStopMask);
  expect_protected(false);  // the stop has disabled the drives
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  expect_protected(true);
  write(reg::kCtrlOffset, 0);
  expect_protected(false);
}

TEST_P(PulseTrainRegisters, RunCannotBeClearedWhileADriveIsEnabled) {
  constexpr std::uint32_t kRun = reg::kCtrlRunMask, kAll = 0x3F;
  const auto expect_write = [this](std::uint32_t word, AxiResp answer, std::uint32_t then) {
    EXPECT_EQ(axi_.write(reg::kCtrlOffset, word), answer) << std::hex << word;
    EXPECT_EQ(read(reg::kCtrlOffset), then) << std::hex << word;
  };
  expect_write(kRun | kAll, AxiResp::kOkay, kRun | kAll);
  expect_write(kAll, AxiResp::kSlvErr, kRun | kAll);
  expect_write(kRun | 1, AxiResp::kOkay, kRun | 1);
  expect_write(0, AxiResp::kSlvErr, kRun);  // the drives are switched off all the same
  expect_write(0, AxiResp::kOkay, 0);

  expect_write(kRun | kAll, AxiResp::kOkay, kRun | kAll);
  write(kKey, kKeyWord);
  expect_write(kAll, AxiResp::kOkay, kAll);
  write(kKey, 0);
  expect_write(kRun | kAll, AxiResp::kOkay, kRun | kAll);

  write(reg::kEstopOffset, reg::kEstopStopMask);
  expect_write(kAll, AxiResp::kOkay, kAll);  // the stop has disabled the drives
}

TEST_P(PulseTrainRegisters, OnlyTheWholeKeyUnlocks) {
  const auto expect_locked = [this](bool is) {
    EXPECT_EQ(read(kKey), is ? 0U : 1U);
    EXPECT_EQ(axi_.write(reg::kDirHoldOffset, 25), is ? AxiResp::kSlvErr : AxiResp::kOkay);
  };
  write(reg::kCtrlOffset, 0x3F);
  expect_locked(true);
  for (unsigned strobe = 0; strobe < 0xF; ++strobe) {
    write(kKey, kKeyWord, strobe);
    expect_locked(true);
  }
  for (int bit = 0; bit < 32; ++bit) {
    write(kKey, kKeyWord ^ 1U << bit);
    expect_locked(true);
  }
  write(kKey, kKeyWord);
  expect_locked(false);
  expect_locked(false);  // an access does not lock
  write(kKey, 1);
  expect_locked(true);
}

TEST_P(PulseTrainRegisters, CommitNeedsAByteStrobe) {
  write(reg::kCommitOffset, 0x1234, 0x0);
  EXPECT_EQ(read(reg::kStatusOffset), 0U);
  EXPECT_EQ(read(reg::kCommitOffset), 0U);
  write(reg::kCommitOffset, 0x1234, 0x3);
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusPendingMask);
  trigger();
  EXPECT_EQ(read(reg::kStatusOffset), 0x1234'0000U);
}

TEST_P(PulseTrainRegisters, CommittedSetIsEmittedAndRead) {
  const auto count = [](std::uint32_t i) { return (i % 2 == 0 ? 1 : -1) * static_cast<int>(30 * i + 7); };
  for (std::uint32_t i = 0; i < kAxisRegisters; ++i) {
    axi_.post_write(reg::kCountOffset + 4 * i, static_cast<std::uint32_t>(count(i)));  // bits 31:16 do not matter
  }
  axi_.post_write(reg::kCommitOffset, 1);
  axi_.drain();
  EXPECT_EQ(axi_.write_answers.size(), kAxisRegisters + 1);
  trigger();
  axi_.step(2499);
  trigger();
  axi_.write_answers.clear();
  for (std::uint32_t i = 0; i < kAxisRegisters; ++i) {
    EXPECT_EQ(static_cast<std::int32_t>(read(reg::kEmittedOffset + 4 * i)), count(i)) << "axis " << i + 1;
    EXPECT_EQ(read(reg::kResidualOffset + 4 * i), 0U) << "axis " << i + 1;
  }
  EXPECT_EQ(read(reg::kFaultOffset), 0U);
}

}  // namespace
}  // namespace armature::test
