#include "controller/drivers/axi_gpio.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

using testing::InSequence;
using testing::Return;
using testing::StrictMock;

// From the AXI GPIO v2.0 register description, not from the generated header.
constexpr RegAddr kData{0x4120'0000};
constexpr RegAddr kTri{0x4120'0004};
constexpr RegAddr kData2{0x4120'0008};
constexpr RegAddr kGier{0x4120'011C};
constexpr RegAddr kIsr{0x4120'0120};
constexpr RegAddr kGpioIer{0x4120'0128};

struct AxiGpioTest : testing::Test {
  StrictMock<test::MockRegisterBus> bus;
  InSequence in_order;
  AxiGpio gpio{bus};
};

TEST_F(AxiGpioTest, DrivesAllPinsOfChannelOne) {
  EXPECT_CALL(bus, write32(kTri, 0u));
  gpio.drive_outputs();
}

TEST_F(AxiGpioTest, WritesAllOutputsInOneAccess) {
  EXPECT_CALL(bus, write32(kData, 0x8001u));
  gpio.set_outputs(0x8001);
}

TEST_F(AxiGpioTest, OneOutputLeavesTheOthers) {
  EXPECT_CALL(bus, read32(kData)).WillOnce(Return(0x0F00u));
  EXPECT_CALL(bus, write32(kData, 0x0F01u));
  gpio.set_output(1, true);
  EXPECT_CALL(bus, read32(kData)).WillOnce(Return(0xFFFFu));
  EXPECT_CALL(bus, write32(kData, 0x7FFFu));
  gpio.set_output(16, false);
  EXPECT_CALL(bus, read32(kData)).WillOnce(Return(0x0004u));
  EXPECT_CALL(bus, write32(kData, 0x0004u));
  gpio.set_output(3, true);
}

TEST_F(AxiGpioTest, ReadsTheInputsOfChannelTwo) {
  EXPECT_CALL(bus, read32(kData2)).WillOnce(Return(0xA005u));
  EXPECT_EQ(gpio.inputs(), 0xA005u);
  EXPECT_CALL(bus, read32(kData2)).WillOnce(Return(0x8000u));
  EXPECT_TRUE(gpio.input(16));
  EXPECT_CALL(bus, read32(kData2)).WillOnce(Return(0xFFFEu));
  EXPECT_FALSE(gpio.input(1));
}

TEST_F(AxiGpioTest, InterruptsOnInputsOnly) {
  EXPECT_CALL(bus, write32(kGpioIer, 2u));
  EXPECT_CALL(bus, write32(kGier, 0x8000'0000u));
  gpio.enable_input_interrupt();
}

TEST_F(AxiGpioTest, AcknowledgesWhatItReadSet) {
  EXPECT_CALL(bus, read32(kIsr)).WillOnce(Return(2u));
  EXPECT_CALL(bus, write32(kIsr, 2u));
  EXPECT_TRUE(gpio.acknowledge_inputs());
}

// The status toggles on a write: nothing may be written to a bit that is clear, and nobody else's bit either.
TEST_F(AxiGpioTest, AcknowledgesNothingWhereNothingChanged) {
  EXPECT_CALL(bus, read32(kIsr)).WillOnce(Return(0u));
  EXPECT_FALSE(gpio.acknowledge_inputs());
  EXPECT_CALL(bus, read32(kIsr)).WillOnce(Return(1u));
  EXPECT_FALSE(gpio.acknowledge_inputs());
  EXPECT_CALL(bus, read32(kIsr)).WillOnce(Return(3u));
  EXPECT_CALL(bus, write32(kIsr, 2u));
  EXPECT_TRUE(gpio.acknowledge_inputs());
}

}  // namespace
}  // namespace armature
