// The axes of the whole programmable logic: which pin belongs to which axis, and that the trigger ties timer, pulses
// and positions together.
#include <array>

#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/field.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/rtl/arm_soc_fixture.hpp"

namespace armature::test {
namespace {

namespace pulse = regs::pulse_train;
namespace enc = regs::encoder;

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
    EXPECT_EQ(read(kPulse + pulse::kDrivesOffset), 1u << (pulse::kDrivesServoOn.lsb + axis));
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
