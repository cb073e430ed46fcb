// Every access of the driver, with the addresses and bits of rtl/REGISTERS.md.
#include "controller/drivers/policy_mlp.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;

class PolicyMlpDriver : public testing::Test {
 protected:
  static constexpr RegAddr kBlock{0x43C5'0000};

  testing::StrictMock<test::MockRegisterBus> bus;
  PolicyMlp network{bus};
};

TEST_F(PolicyMlpDriver, KnowsItsBlockById) {
  EXPECT_CALL(bus, read32(kBlock)).WillOnce(Return(0x504D'0108u)).WillOnce(Return(0x504D'0104u));
  EXPECT_TRUE(network.identified());
  EXPECT_FALSE(network.identified());
}

TEST_F(PolicyMlpDriver, LoadsAnImageFromItsFirstWordOn) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(kBlock + 0x20, 0u));
  EXPECT_CALL(bus, write32(kBlock + 0x24, 11u));
  EXPECT_CALL(bus, write32(kBlock + 0x24, 12u));
  EXPECT_CALL(bus, write32(kBlock + 0x18, 0xCAFE'F00Du));
  network.load(std::array<std::uint32_t, 2>{11, 12}, 0xCAFE'F00D);
}

TEST_F(PolicyMlpDriver, WritesNoMoreThanTheMemory) {
  EXPECT_CALL(bus, write32(kBlock + 0x20, 0u));
  EXPECT_CALL(bus, write32(kBlock + 0x24, 7u)).Times(4096);
  EXPECT_CALL(bus, write32(kBlock + 0x18, 0u));
  network.load(std::vector<std::uint32_t>(4100, 7), 0);
}

TEST_F(PolicyMlpDriver, PacksItsInputsAndStarts) {
  const InSequence in_order;
  EXPECT_CALL(bus, write32(kBlock + 0x14, 100u));
  EXPECT_CALL(bus, write32(kBlock + 0x40, 0x7F80'FF01u));
  EXPECT_CALL(bus, write32(kBlock + 0x44, 0x0000'0005u));
  EXPECT_CALL(bus, write32(kBlock + 0x04, 1u));
  network.set_bound(100);
  network.set_inputs(std::array<std::int8_t, 5>{1, -1, -128, 127, 5});
  network.start();
}

TEST_F(PolicyMlpDriver, ReadsTheResults) {
  EXPECT_CALL(bus, read32(kBlock + 0x08)).WillOnce(Return(0b00001u)).WillOnce(Return(0b11110u));
  EXPECT_TRUE(network.status().busy);
  const PolicyMlp::Status status = network.status();
  EXPECT_TRUE(!status.busy && status.done && status.refused && status.corrupt && status.malformed);
  EXPECT_CALL(bus, read32(kBlock + 0x60)).WillOnce(Return(0x7F80'FF01u));
  EXPECT_CALL(bus, read32(kBlock + 0x64)).WillOnce(Return(0x0000'0005u));
  EXPECT_EQ(network.outputs(), (std::array<std::int8_t, 8>{1, -1, -128, 127, 5, 0, 0, 0}));
  EXPECT_CALL(bus, read32(kBlock + 0x10)).WillOnce(Return(1569u));
  EXPECT_EQ(network.cycles(), 1569u);
}

}  // namespace
}  // namespace armature
