// The switch and the one decoder behind it.
#include "controller/drivers/encoder_switch.hpp"

#include <gtest/gtest.h>

#include "controller/drivers/single_encoder.hpp"
#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;

class PaperEncoderDrivers : public testing::Test {
 protected:
  static constexpr RegAddr kSwitch{0x43C3'0000};
  static constexpr RegAddr kDecoder{0x43C2'0000};

  testing::StrictMock<test::MockRegisterBus> bus;
  EncoderSwitch encoder_switch{bus};
  SingleEncoder decoder{bus};
};

TEST_F(PaperEncoderDrivers, KnowTheirBlocksById) {
  EXPECT_CALL(bus, read32(kSwitch)).WillOnce(Return(0x5357'0106u));
  EXPECT_TRUE(encoder_switch.identified());
  EXPECT_CALL(bus, read32(kDecoder)).WillOnce(Return(0x454E'0101u));
  EXPECT_TRUE(decoder.identified());
}

TEST_F(PaperEncoderDrivers, RefuseAnotherBlockVersionOrAxisCount) {
  for (const std::uint32_t id : {0x454E'0106u, 0x5357'0206u, 0x5357'0105u, 0u, 0xBADA'CCE5u}) {
    EXPECT_CALL(bus, read32(kSwitch)).WillOnce(Return(id));
    EXPECT_FALSE(encoder_switch.identified()) << std::hex << id;
  }
  // Six decoders are the other variant's.
  for (const std::uint32_t id : {0x454E'0106u, 0x454E'0201u, 0x5057'0101u, 0u, 0xBADA'CCE5u}) {
    EXPECT_CALL(bus, read32(kDecoder)).WillOnce(Return(id));
    EXPECT_FALSE(decoder.identified()) << std::hex << id;
  }
}

TEST_F(PaperEncoderDrivers, SelectsEachAxis) {
  for (std::uint32_t axis = 0; axis < 6; ++axis) {
    EXPECT_CALL(bus, write32(kSwitch + 0x04, axis));
    encoder_switch.select(axis);
  }
}

TEST_F(PaperEncoderDrivers, ReadTheFirstElementsOfTheDecoder) {
  EXPECT_CALL(bus, read32(kDecoder + 0x1C)).WillOnce(Return(0x3Eu)).WillOnce(Return(0x01u));
  EXPECT_FALSE(decoder.known());
  EXPECT_TRUE(decoder.known());
  EXPECT_CALL(bus, read32(kDecoder + 0x20)).WillOnce(Return(0xFFFF'FFF0u));
  EXPECT_EQ(decoder.position(), -16);
  EXPECT_CALL(bus, read32(kDecoder + 0x14)).WillOnce(Return(0x9ABC'DEF0u));
  EXPECT_EQ(decoder.trigger_time(), 0x9ABC'DEF0u);
}

TEST_F(PaperEncoderDrivers, ReadAndClearTheIllegalFlag) {
  const InSequence in_order;
  EXPECT_CALL(bus, read32(kDecoder + 0x10)).WillOnce(Return(0xFFFF'FFFEu)).WillOnce(Return(1u));
  EXPECT_CALL(bus, write32(kDecoder + 0x10, 1u));
  EXPECT_FALSE(decoder.illegal_flag());
  EXPECT_TRUE(decoder.illegal_flag());
  decoder.clear_illegal_flag();
}

}  // namespace
}  // namespace armature
