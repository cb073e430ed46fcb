#include "controller/drivers/encoder.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::Return;

constexpr RegAddr encoder_at(std::uint32_t offset) {
  return RegAddr{0x43C2'0000} + offset;
}

class EncoderDriver : public testing::Test {
 protected:
  testing::StrictMock<test::MockRegisterBus> bus;
  Encoder encoder{bus};
};

TEST_F(EncoderDriver, KnowsItsBlockById) {
  EXPECT_CALL(bus, read32(encoder_at(0x00))).WillOnce(Return(0x454E'0106u)).WillOnce(Return(0x5054'0106u));
  EXPECT_TRUE(encoder.identified());
  EXPECT_FALSE(encoder.identified());
}

TEST_F(EncoderDriver, ChecksTheIndexOnlyOnceItKnowsTheRevolution) {
  const testing::InSequence in_order;
  for (std::uint32_t axis = 0; axis < 6; ++axis) EXPECT_CALL(bus, write32(encoder_at(0x80 + 4 * axis), 10'000u + axis));
  EXPECT_CALL(bus, write32(encoder_at(0x08), 0x153Fu));
  encoder.configure({10'000, 10'001, 10'002, 10'003, 10'004, 10'005}, 0x15);
}

TEST_F(EncoderDriver, ReadsWhichAxesAreKnown) {
  EXPECT_CALL(bus, read32(encoder_at(0x1C))).WillOnce(Return(0x2Du));
  EXPECT_EQ(encoder.known(), 0x2D);
}

TEST_F(EncoderDriver, ReadsSignedPositionsOfAllAxes) {
  for (std::uint32_t axis = 0; axis < 6; ++axis) {
    EXPECT_CALL(bus, read32(encoder_at(0x20 + 4 * axis))).WillOnce(Return(axis - 3u));
  }
  EXPECT_EQ(encoder.positions(), (PerAxis<std::int32_t>{-3, -2, -1, 0, 1, 2}));
}

TEST_F(EncoderDriver, DecodesAndClearsFaultsPerAxis) {
  const testing::InSequence in_order;
  EXPECT_CALL(bus, read32(encoder_at(0x10))).WillOnce(Return(0x0000'2A15u));
  EXPECT_CALL(bus, write32(encoder_at(0x10), 0x0000'2A15u));
  EXPECT_CALL(bus, read32(encoder_at(0x10))).WillOnce(Return(0u));
  const Encoder::Faults faults = encoder.faults();
  EXPECT_EQ(faults.illegal, 0x15);
  EXPECT_EQ(faults.index, 0x2A);
  EXPECT_TRUE(faults.any());
  encoder.clear(faults);
  EXPECT_FALSE(encoder.faults().any());
}

}  // namespace
}  // namespace armature
