// axi_gpio with other reset values, and with channels of a fixed direction.
#include "Vaxi_gpio_fixed.h"
#include "Vaxi_gpio_preset.h"
#include "tests/rtl/axi_gpio_fixture.hpp"

namespace armature::test::gpio {
namespace {

// Another reset value for each register.
using AxiGpioPreset = AxiGpioFixture<Vaxi_gpio_preset>;
INSTANTIATE_AXI_STALLS(AxiGpioPreset);

TEST_P(AxiGpioPreset, StartsWithItsParameters) {
  EXPECT_EQ(read(kTri), 0x00FFU);
  EXPECT_EQ(read(kTri2), 0x0F0FU);
  EXPECT_EQ(dut_.gpio_o, 0xA5C3);
  EXPECT_EQ(dut_.gpio_driven_o, 0xA500);
  EXPECT_EQ(dut_.gpio2_o, 0x1234);
  EXPECT_EQ(read(kData), 0xA500U);
  EXPECT_EQ(read(kData2), 0x1030U);
  write(kTri, 0);
  EXPECT_EQ(read(kData), 0xA5C3U);
  EXPECT_EQ(read(kIsr), 0U);
}

// Channel 1 has inputs only, channel 2 outputs only.
using AxiGpioFixed = AxiGpioFixture<Vaxi_gpio_fixed>;
INSTANTIATE_AXI_STALLS(AxiGpioFixed);

TEST_P(AxiGpioFixed, WritesDoNotChangeTheDirection) {
  write(kTri, 0);
  write(kTri2, 0xFFFF);
  EXPECT_EQ(read(kTri), 0xFFFFU);
  EXPECT_EQ(read(kTri2), 0U);
  EXPECT_EQ(dut_.gpio_t_o, 0xFFFF);
  EXPECT_EQ(dut_.gpio2_t_o, 0);
}

TEST_P(AxiGpioFixed, InputsReadThePinsAndOutputsTheirWrittenValue) {
  EXPECT_EQ(read(kData2), 0x8001U) << "reset value";
  write(kData, 0xFFFF);
  EXPECT_EQ(read(kData), 0U);
  input(0, 0x1234);
  EXPECT_EQ(read(kData), 0x1234U);
  write(kData2, 0xA5C3);
  EXPECT_EQ(read(kData2), 0xA5C3U);
  EXPECT_EQ(dut_.gpio2_o, 0xA5C3);
}

TEST_P(AxiGpioFixed, OnlyInputsInterrupt) {
  enable(kChannel1 | kChannel2);
  write(kData2, 0xFFFF);
  axi_.step(8);
  EXPECT_EQ(dut_.irq_o, 0);
  input(1, 0x0001);
  EXPECT_EQ(dut_.irq_o, 0);
  input(0, 0x0001);
  EXPECT_EQ(dut_.irq_o, 1);
  EXPECT_EQ(read(kIsr), kChannel1);
}

}  // namespace
}  // namespace armature::test::gpio
