#include "controller/drivers/pulse_width.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;

constexpr RegAddr pulse_width_at(std::uint32_t offset) {
  return RegAddr{0x43C1'0000} + offset;
}

class PulseWidthDriver : public testing::Test {
 protected:
  testing::StrictMock<test::MockRegisterBus> bus;
  PulseWidth pulse_width{bus};
};

TEST_F(PulseWidthDriver, KnowsItsBlockById) {
  EXPECT_CALL(bus, read32(pulse_width_at(0x00))).WillOnce(Return(0x5057'0106u));
  EXPECT_TRUE(pulse_width.identified());
}

TEST_F(PulseWidthDriver, RefusesAnotherBlockVersionOrAxisCount) {
  for (const std::uint32_t id : {0x5054'0106u, 0x5057'0206u, 0x5057'0105u, 0u, 0xBADA'CCE5u}) {
    EXPECT_CALL(bus, read32(pulse_width_at(0x00))).WillOnce(Return(id));
    EXPECT_FALSE(pulse_width.identified()) << std::hex << id;
  }
}

TEST_F(PulseWidthDriver, WritesSixSignedWidthsInOrder) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_width_at(0x40), 7u));
  EXPECT_CALL(bus, write32(pulse_width_at(0x44), 0xFFFF'FFF9u));
  EXPECT_CALL(bus, write32(pulse_width_at(0x48), 0u));
  EXPECT_CALL(bus, write32(pulse_width_at(0x4C), 1250u));
  EXPECT_CALL(bus, write32(pulse_width_at(0x50), 0xFFFF'F63Du));
  EXPECT_CALL(bus, write32(pulse_width_at(0x54), 625u));
  pulse_width.set_widths({Cycles{7}, Cycles{-7}, Cycles{0}, Cycles{1250}, Cycles{-2499}, Cycles{625}});
}

TEST_F(PulseWidthDriver, RequestsServoEnables) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_width_at(0x04), 0x3Fu));
  EXPECT_CALL(bus, write32(pulse_width_at(0x04), 0x05u));
  pulse_width.set_servo(PulseWidth::kAllAxes);
  pulse_width.set_servo(0b000101);
}

TEST_F(PulseWidthDriver, DecodesEachStatusField) {
  EXPECT_CALL(bus, read32(pulse_width_at(0x08))).WillOnce(Return(0x0000'0001u)).WillOnce(Return(0xFFFF'E5F4u));
  PulseWidth::Status status = pulse_width.status();
  EXPECT_TRUE(status.estop);
  EXPECT_FALSE(status.estop_pin);
  EXPECT_EQ(status.armed, 0);
  status = pulse_width.status();
  EXPECT_FALSE(status.estop);
  EXPECT_TRUE(status.estop_pin);
  EXPECT_EQ(status.armed, 0x25);
}

TEST_F(PulseWidthDriver, ClearsTheStickyStopFlag) {
  EXPECT_CALL(bus, write32(pulse_width_at(0x10), 1u));
  pulse_width.clear_estop_flag();
}

TEST_F(PulseWidthDriver, ReadsTimeAndSignedCountersOfAllAxes) {
  EXPECT_CALL(bus, read32(pulse_width_at(0x2C))).WillOnce(Return(0xFEDC'BA98u));
  for (std::uint32_t axis = 0; axis < 6; ++axis) {
    EXPECT_CALL(bus, read32(pulse_width_at(0x60 + 4 * axis))).WillOnce(Return(0u - axis));
  }
  EXPECT_EQ(pulse_width.time(), 0xFEDC'BA98u);
  EXPECT_EQ(pulse_width.emitted(), (PerAxis<std::int32_t>{0, -1, -2, -3, -4, -5}));
}

TEST_F(PulseWidthDriver, ReadsSwitchesAndDrives) {
  EXPECT_CALL(bus, read32(pulse_width_at(0x30))).WillOnce(Return(0x0021'1203u));
  EXPECT_CALL(bus, read32(pulse_width_at(0x34))).WillOnce(Return(0x0015'3F20u));
  const auto switches = pulse_width.switches();
  EXPECT_EQ(switches.home, 0x03);
  EXPECT_EQ(switches.limit_pos, 0x12);
  EXPECT_EQ(switches.limit_neg, 0x21);
  const auto drives = pulse_width.drives();
  EXPECT_EQ(drives.alarm, 0x20);
  EXPECT_EQ(drives.in_position, 0x3F);
  EXPECT_EQ(drives.servo_on, 0x15);
}

TEST_F(PulseWidthDriver, StopsAndClearsTheLatch) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(pulse_width_at(0x0C), 0b01u));
  EXPECT_CALL(bus, write32(pulse_width_at(0x0C), 0b10u));
  pulse_width.emergency_stop();
  pulse_width.clear_stop();
}

}  // namespace
}  // namespace armature
