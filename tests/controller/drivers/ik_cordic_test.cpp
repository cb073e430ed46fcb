// Every access of the driver, with the addresses and bits of rtl/REGISTERS.md.
#include "controller/drivers/ik_cordic.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;

class IkCordicDriver : public testing::Test {
 protected:
  static constexpr RegAddr kBlock{0x43C4'0000};

  testing::StrictMock<test::MockRegisterBus> bus;
  IkCordic ik{bus};
};

TEST_F(IkCordicDriver, KnowsItsBlockById) {
  EXPECT_CALL(bus, read32(kBlock))
      .WillOnce(Return(0x494B'0108u))
      .WillOnce(Return(0x494B'0208u))
      .WillOnce(Return(0xBADA'CCE5u));
  EXPECT_TRUE(ik.identified());
  EXPECT_FALSE(ik.identified());
  EXPECT_FALSE(ik.identified());
}

TEST_F(IkCordicDriver, WritesEachInputToItsRegister) {
  const InSequence in_order;
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_CALL(bus, write32(kBlock + 0x20 + 4 * i, 11 + i));
  EXPECT_CALL(bus, write32(kBlock + 0x60, 0xFFFF'FFFFu));
  EXPECT_CALL(bus, write32(kBlock + 0x88, 0x8000'0000u));
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_CALL(bus, write32(kBlock + 0x90 + 4 * i, 1 + i));
  ik.set_geometry({.a1 = 11, .d1 = 12, .a2 = 13, .forearm = 14, .a4 = 15, .hand = 16, .phi = 17});
  ik.set_rotation(8, -1);
  ik.set_position(2, INT32_MIN);
  ik.set_previous({1, 2, 3});
}

TEST_F(IkCordicDriver, StartsEachFamilyAndKnowsTheEnd) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(kBlock + 0x04, 1u));
  EXPECT_CALL(bus, write32(kBlock + 0x04, 3u));
  EXPECT_CALL(bus, read32(kBlock + 0x08)).WillOnce(Return(0b101u)).WillOnce(Return(0b110u));
  ik.start(false);
  ik.start(true);
  EXPECT_FALSE(ik.done());
  EXPECT_TRUE(ik.done());
}

TEST_F(IkCordicDriver, ReadsTheResults) {
  EXPECT_CALL(bus, read32(kBlock + 0x14)).WillOnce(Return(0x55u));
  EXPECT_EQ(ik.branches(), 0x55);
  EXPECT_CALL(bus, read32(kBlock + 0x18)).WillOnce(Return(0b1010'01'10'11'01u));
  const IkCordic::Flags flags = ik.flags();
  EXPECT_TRUE(flags.shoulder_singular);
  EXPECT_EQ(flags.elbow_singular, 0b11);
  EXPECT_EQ(flags.clamped, 0b10);
  EXPECT_EQ(flags.folded, 0b01);
  EXPECT_EQ(flags.wrist_singular, 0b1010);
  EXPECT_CALL(bus, read32(kBlock + 0x1BC)).WillOnce(Return(0xFFFF'FFFEu));
  EXPECT_EQ(ik.theta(7, 5), -2);
  EXPECT_CALL(bus, read32(kBlock + 0x10)).WillOnce(Return(1241u));
  EXPECT_EQ(ik.cycles(), 1241u);
}

}  // namespace
}  // namespace armature
