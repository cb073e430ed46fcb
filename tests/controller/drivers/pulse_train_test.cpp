#include "controller/drivers/pulse_train.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;

constexpr RegAddr pulse_train_at(std::uint32_t offset) {
  return RegAddr{0x43C1'0000} + offset;
}

class PulseTrainDriver : public testing::Test {
 protected:
  testing::StrictMock<test::MockRegisterBus> bus;
  PulseTrain pulse_train{bus};
};

TEST_F(PulseTrainDriver, KnowsItsBlockById) {
  EXPECT_CALL(bus, read32(pulse_train_at(0x00))).WillOnce(Return(0x5054'0106u));
  EXPECT_TRUE(pulse_train.identified());
}

TEST_F(PulseTrainDriver, RefusesAnotherBlockVersionOrAxisCount) {
  for (const std::uint32_t id : {0x454E'0106u, 0x5054'0206u, 0x5054'0105u, 0u, 0xBADA'CCE5u}) {
    EXPECT_CALL(bus, read32(pulse_train_at(0x00))).WillOnce(Return(id));
    EXPECT_FALSE(pulse_train.identified()) << std::hex << id;
  }
}

TEST_F(PulseTrainDriver, ConfiguresEveryTime) {
  EXPECT_CALL(bus, write32(pulse_train_at(0x1C), 2'500u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x20), 30u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x24), 40u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x14), 7u));
  pulse_train.configure(
      {.tick = Cycles{2'500}, .dir_setup = Cycles{30}, .dir_hold = Cycles{40}, .watchdog_limit = Ticks{7}});
}

TEST_F(PulseTrainDriver, ControlsServoAndRunTogether) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_train_at(0x04), 0x0000'013Fu));
  EXPECT_CALL(bus, write32(pulse_train_at(0x04), 0x0000'0100u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x04), 0x0000'0005u));
  pulse_train.control(PulseTrain::kAllAxes, true);
  pulse_train.control(0, true);
  pulse_train.control(0b000101, false);
}

TEST_F(PulseTrainDriver, CommitsAfterAllSixCountsAreStaged) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_train_at(0x40), 200u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x44), 0x0000'FF38u));  // -200 in 16 bits
  EXPECT_CALL(bus, write32(pulse_train_at(0x48), 0u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x4C), 1u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x50), 0x0000'FFFFu));
  EXPECT_CALL(bus, write32(pulse_train_at(0x54), 17u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x28), 0xBEEFu));
  pulse_train.commit({Pulses{200}, Pulses{-200}, Pulses{0}, Pulses{1}, Pulses{-1}, Pulses{17}}, 0xBEEF);
}

TEST_F(PulseTrainDriver, DecodesEachStatusBit) {
  for (int bit = 0; bit < 4; ++bit) {
    EXPECT_CALL(bus, read32(pulse_train_at(0x08))).WillOnce(Return(0xABCD'0000u | (1u << bit)));
    const PulseTrain::Status status = pulse_train.status();
    EXPECT_EQ(status.estop, bit == 0);
    EXPECT_EQ(status.watchdog, bit == 1);
    EXPECT_EQ(status.estop_pin, bit == 2);
    EXPECT_EQ(status.pending, bit == 3);
    EXPECT_EQ(status.sequence, 0xABCD);
  }
}

TEST_F(PulseTrainDriver, DecodesAndClearsEachFaultFlagAlone) {
  for (int bit = 0; bit < 6; ++bit) {
    const InSequence in_order;
    EXPECT_CALL(bus, read32(pulse_train_at(0x10))).WillOnce(Return(1u << bit));
    EXPECT_CALL(bus, write32(pulse_train_at(0x10), 1u << bit));
    const PulseTrain::Faults faults = pulse_train.faults();
    EXPECT_EQ(faults.estop, bit == 0);
    EXPECT_EQ(faults.watchdog, bit == 1);
    EXPECT_EQ(faults.underrun, bit == 2);
    EXPECT_EQ(faults.residual, bit == 3);
    EXPECT_EQ(faults.clipped, bit == 4);
    EXPECT_EQ(faults.recommit, bit == 5);
    pulse_train.clear(faults);
  }
}

TEST_F(PulseTrainDriver, ReadsSignedCountersOfAllAxes) {
  for (std::uint32_t axis = 0; axis < 6; ++axis) {
    EXPECT_CALL(bus, read32(pulse_train_at(0x60 + 4 * axis))).WillOnce(Return(0u - axis));
    EXPECT_CALL(bus, read32(pulse_train_at(0x80 + 4 * axis))).WillOnce(Return(0x8000'0000u + axis));
  }
  const auto emitted = pulse_train.emitted();
  const auto residual = pulse_train.residual();
  for (std::int32_t axis = 0; axis < 6; ++axis) {
    EXPECT_EQ(emitted[static_cast<std::size_t>(axis)], -axis);
    EXPECT_EQ(residual[static_cast<std::size_t>(axis)], std::int32_t{-2'147'483'647} - 1 + axis);
  }
}

TEST_F(PulseTrainDriver, ReadsUnderrunsSwitchesAndDrives) {
  EXPECT_CALL(bus, read32(pulse_train_at(0x18))).WillOnce(Return(123'456u));
  EXPECT_CALL(bus, read32(pulse_train_at(0x30))).WillOnce(Return(0x0021'1203u));
  EXPECT_CALL(bus, read32(pulse_train_at(0x34))).WillOnce(Return(0x0015'3F20u));
  EXPECT_EQ(pulse_train.underruns(), 123'456u);
  const auto switches = pulse_train.switches();
  EXPECT_EQ(switches.home, 0x03);
  EXPECT_EQ(switches.limit_pos, 0x12);
  EXPECT_EQ(switches.limit_neg, 0x21);
  const auto drives = pulse_train.drives();
  EXPECT_EQ(drives.alarm, 0x20);
  EXPECT_EQ(drives.in_position, 0x3F);
  EXPECT_EQ(drives.servo_on, 0x15);
}

TEST_F(PulseTrainDriver, StopsAndClearsBothLatches) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_train_at(0x0C), 0b001u));
  EXPECT_CALL(bus, write32(pulse_train_at(0x0C), 0b110u));
  pulse_train.emergency_stop();
  pulse_train.clear_stops();
}

}  // namespace
}  // namespace armature
