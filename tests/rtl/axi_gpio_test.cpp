// axi_gpio with the vendor's default parameters, through its AXI port, as vendor and Linux drivers use it.
#include <algorithm>
#include <array>
#include <cstdint>

#include "Vaxi_gpio.h"
#include "tests/rtl/axi_gpio_fixture.hpp"

namespace armature::test::gpio {
namespace {

using AxiGpio = AxiGpioFixture<Vaxi_gpio>;
INSTANTIATE_AXI_STALLS(AxiGpio);

TEST_P(AxiGpio, AllPinsAreInputsAfterReset) {
  EXPECT_EQ(dut_.gpio_t_o, 0xFFFF);
  EXPECT_EQ(dut_.gpio2_t_o, 0xFFFF);
  EXPECT_EQ(dut_.gpio_o | dut_.gpio2_o | dut_.gpio_driven_o | dut_.irq_o, 0);
  for (const std::uint32_t offset : {kTri, kTri2}) EXPECT_EQ(read(offset), 0xFFFFU) << offset;
  for (const std::uint32_t offset : {kData, kData2, kGier, kIsr, kIer}) EXPECT_EQ(read(offset), 0U) << offset;
}

TEST_P(AxiGpio, OutputsFollowDataBitByBitAndReadBack) {
  for (std::size_t i = 0; i < 2; ++i) {
    write(kChannels[i].tri, 0);
    for (int bit = 0; bit < 16; ++bit) {
      write(kChannels[i].data, 1U << bit);
      EXPECT_EQ(pads(i), 1U << bit);
      EXPECT_EQ(read(kChannels[i].data), 1U << bit);
      EXPECT_EQ(read(kChannels[1 - i].data), i == 0 ? 0U : 0xFF5AU);
    }
    write(kChannels[i].data, 0xFFFF'A55A);
    EXPECT_EQ(read(kChannels[i].data), 0xA55AU);
    write(kChannels[i].data, 0xFFFF'FFFF, 0x2);
    EXPECT_EQ(pads(i), 0xFF5A) << "byte strobes";
    write(kChannels[i].data, 0, 0xC);
    EXPECT_EQ(pads(i), 0xFF5A) << "no strobe of its bytes";
    EXPECT_EQ(read(kChannels[1 - i].tri), i == 0 ? 0xFFFFU : 0U);
  }
}

TEST_P(AxiGpio, DirectionsAreSetBitByBitAndByteByByte) {
  for (const Channel& channel : kChannels) {
    for (int bit = 0; bit < 16; ++bit) {
      write(channel.tri, 1U << bit);
      EXPECT_EQ(read(channel.tri), 1U << bit);
    }
    write(channel.tri, 0xFFFF'A55A);
    EXPECT_EQ(read(channel.tri), 0xA55AU);
    write(channel.tri, 0, 0x1);
    EXPECT_EQ(read(channel.tri), 0xA500U);
    write(channel.tri, 0xFFFF, 0xC);
    EXPECT_EQ(read(channel.tri), 0xA500U);
  }
  EXPECT_EQ(dut_.gpio_t_o, 0xA500);
  EXPECT_EQ(dut_.gpio2_t_o, 0xA500);
}

// Of a released pin DATA reads the level outside, not the written value.
TEST_P(AxiGpio, ReleasedPinsReadTheirLevelAndKeepTheirWrittenValue) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Channel& channel = kChannels[i];
    write(channel.tri, 0xFFFF);
    write(channel.data, 0xA5);
    EXPECT_EQ(read(channel.data), 0U);
    input(i, 0x3C3C);
    EXPECT_EQ(read(channel.data), 0x3C3CU);
    write(channel.tri, 0xFF0F);
    axi_.step(4);
    EXPECT_EQ(pads(i), 0x3CAC);
    EXPECT_EQ(read(channel.data), 0x3CACU);
    write(channel.tri, 0);
    EXPECT_EQ(read(channel.data), 0xA5U);
  }
}

TEST_P(AxiGpio, OutputsReadTheirWrittenValueWhateverThePadHas) {
  shorted_ = true;
  for (std::size_t i = 0; i < 2; ++i) {
    write(kChannels[i].tri, 0x00FF);
    write(kChannels[i].data, 0xA5C3);
    input(i, 0x5A3C);
    EXPECT_EQ(read(kChannels[i].data), 0xA53CU);
  }
}

TEST_P(AxiGpio, PadsWithoutABufferAreLowWhereTheyAreReleased) {
  write(kData, 0xFFFF);
  EXPECT_EQ(dut_.gpio_driven_o, 0);
  write(kTri, 0x00F1);
  EXPECT_EQ(dut_.gpio_driven_o, 0xFF0E);
  write(kTri, 0);
  EXPECT_EQ(dut_.gpio_driven_o, 0xFFFF);
}

TEST_P(AxiGpio, EveryChangeOfAnInputSetsTheStatusOfItsChannelAndItsDriverAcknowledgesIt) {
  enable(kChannel1 | kChannel2);
  for (std::size_t i = 0; i < 2; ++i) {
    for (int bit = 0; bit < 16; ++bit) {
      for (const bool level : {true, false}) {
        input(i, level ? 1U << bit : 0U);
        ASSERT_EQ(dut_.irq_o, 1) << "channel " << i + 1 << " bit " << bit << " level " << level;
        const std::uint32_t status = read(kIsr);
        EXPECT_EQ(status, kChannels[i].status);
        write(kIsr, status);  // what was read
        EXPECT_EQ(dut_.irq_o, 0);
        EXPECT_EQ(read(kIsr), 0U);
      }
    }
  }
}

TEST_P(AxiGpio, OutputsAndChangesOfTheDirectionRaiseNoInterrupt) {
  input(0, 0xFFFF);
  input(1, 0xFFFF);
  write(kIsr, read(kIsr));
  for (std::size_t i = 0; i < 2; ++i) {
    const Channel& channel = kChannels[i];
    write(channel.data, 0x5555);
    axi_.step(8);
    write(channel.tri, 0xFF00);
    axi_.step(8);
    write(channel.data, 0xAAAA);
    axi_.step(8);
    EXPECT_EQ(read(kIsr), 0U);
    input(i, 0xFF00);
    EXPECT_EQ(read(kIsr), 0U) << "the pads that change outside are driven";
    input(i, 0x7F00);
    EXPECT_EQ(read(kIsr), channel.status);
    write(kIsr, channel.status);
    write(channel.data, 0x1122);
    input(i, 0x7F22);
    write(channel.tri, 0xFFFF);
    axi_.step(8);
    EXPECT_EQ(read(kIsr), 0U) << "the released pads keep their level";
    write(channel.tri, 0xFF00);
    input(i, 0x7F00);
    write(channel.tri, 0xFFFF);
    axi_.step(8);
    EXPECT_EQ(read(kIsr), channel.status) << "the level of the pads changes because they are released";
    write(kIsr, channel.status);
  }
}

// The sequence of the vendor's interrupt example, which uses channel 1 and relies on the reset value of TRI.
TEST_P(AxiGpio, TheVendorsInterruptExampleGetsItsInterruptOfChannel1) {
  write(kIer, read(kIer) | kChannel1);
  write(kGier, kGlobalEnable);
  axi_.step(50);
  EXPECT_EQ(dut_.irq_o, 0);
  input(1, 0x0001);
  EXPECT_EQ(dut_.irq_o, 0) << "channel 2 is not enabled";
  write(kIsr, read(kIsr) & kChannel2);
  input(0, 0x0001);
  ASSERT_EQ(dut_.irq_o, 1);
  write(kIsr, read(kIsr) & kChannel1);
  EXPECT_EQ(dut_.irq_o, 0);
  EXPECT_EQ(read(kData), 1U);
  write(kIer, read(kIer) & ~kChannel1);
  input(0, 0x0000);
  EXPECT_EQ(dut_.irq_o, 0) << "disabled";
}

TEST_P(AxiGpio, StatusTogglesOnWriteOfItsLowByteOnly) {
  write(kIsr, kChannel1 | kChannel2);
  EXPECT_EQ(read(kIsr), kChannel1 | kChannel2) << "software raises clear bits";
  write(kIsr, kChannel1);
  EXPECT_EQ(read(kIsr), kChannel2);
  write(kIsr, 0);
  EXPECT_EQ(read(kIsr), kChannel2);
  write(kIsr, kChannel2, 0xE);
  EXPECT_EQ(read(kIsr), kChannel2) << "byte 0 not enabled";
  write(kIsr, 0xFFFF'FFFC | kChannel2);
  EXPECT_EQ(read(kIsr), 0U);
}

TEST_P(AxiGpio, InterruptNeedsStatusEnableAndGlobalEnable) {
  for (std::uint32_t status = 0; status < 4; ++status) {
    for (std::uint32_t enabled = 0; enabled < 4; ++enabled) {
      for (const std::uint32_t global : {0U, kGlobalEnable}) {
        write(kIsr, read(kIsr) ^ status);
        write(kIer, enabled);
        write(kGier, global);
        EXPECT_EQ(read(kIsr), status);
        EXPECT_EQ(read(kIer), enabled);
        EXPECT_EQ(read(kGier), global);
        EXPECT_EQ(dut_.irq_o, global != 0 && (status & enabled) != 0) << status << " " << enabled << " " << global;
      }
    }
  }
}

TEST_P(AxiGpio, LevelsFoundAfterResetAreNoChange) {
  for (const std::uint32_t level : {0xFFFFU, 0x0001U, 0x8000U}) {
    restart(static_cast<std::uint16_t>(level), static_cast<std::uint16_t>(~level));
    EXPECT_EQ(read(kData), level);
    EXPECT_EQ(read(kData2), ~level & 0xFFFFU);
    EXPECT_EQ(read(kIsr), 0U);
    input(0, level ^ 0x10);
    EXPECT_EQ(read(kIsr), kChannel1);
    input(1, level);
    EXPECT_EQ(read(kIsr), kChannel1 | kChannel2);
  }
}

TEST_P(AxiGpio, WordsWithoutARegisterReadZeroAndIgnoreWritesWithoutAnError) {
  const std::array<std::uint32_t, 7> named = {kData, kTri, kData2, kTri2, kGier, kIsr, kIer};
  for (std::uint32_t offset = 0; offset < kMapBytes; offset += 4) {
    if (std::find(named.begin(), named.end(), offset) != named.end()) continue;
    write(offset, 0xFFFF'FFFF);
    EXPECT_EQ(read(offset), 0U) << std::hex << offset;
  }
  for (const std::uint32_t offset : named) {
    EXPECT_EQ(read(offset), offset == kTri || offset == kTri2 ? 0xFFFFU : 0U) << std::hex << offset;
  }
  for (const std::uint32_t offset : {kMapBytes, kMapBytes + 0x11C, 0x1004U, 0xFFFCU}) {
    EXPECT_EQ(axi_.write(offset, 0xFFFF'FFFF), AxiResp::kSlvErr) << std::hex << offset;
    EXPECT_EQ(axi_.read(offset), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5})) << std::hex << offset;
  }
}

// Cycle by cycle, without the bus driver.
class AxiGpioClocks : public VerilatedTest<Vaxi_gpio> {
 protected:
  void SetUp() override {
    dut_.gpio_i = dut_.gpio2_i = 0;
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = dut_.s_axi_arvalid_i = 0;
    dut_.s_axi_bready_i = dut_.s_axi_rready_i = 1;
    reset();
    tick(8);
  }

  // Ends with the clock edge that accepts the write.
  void send(std::uint32_t offset, std::uint32_t value) {
    dut_.s_axi_awaddr_i = static_cast<std::uint16_t>(offset);
    dut_.s_axi_wdata_i = value;
    dut_.s_axi_wstrb_i = 0xF;
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 1;
    tick();
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 0;
  }
};

// The parameter is the channel, 0 or 1.
class AxiGpioTiming : public AxiGpioClocks, public ::testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Channels, AxiGpioTiming, ::testing::Values(0, 1));

TEST_P(AxiGpioTiming, PinReachesTheInterruptInFourEdgesAndOutlivesAnAcknowledgeInItsCycle) {
  const std::uint32_t channel = kChannels[GetParam()].status;
  send(kIer, channel);
  tick(6);
  send(kGier, kGlobalEnable);
  tick(6);
  for (const bool pending : {false, true}) {
    for (int lead = 0; lead < 6; ++lead) {  // edges from the pin change to the acceptance of a toggling write
      if (pending) {
        send(kIsr, channel);
        tick(6);
      }
      ASSERT_EQ(dut_.irq_o, pending);
      (GetParam() == 0 ? dut_.gpio_i : dut_.gpio2_i) ^= 1;
      for (int edge = 1; edge <= lead; ++edge) {
        tick();
        EXPECT_EQ(dut_.irq_o, pending || edge >= 4) << "edge " << edge;
      }
      send(kIsr, channel);
      tick(6);
      // The change sets the status on edge 3, the write acts on edge lead + 2: only a later one leaves it clear.
      EXPECT_EQ(dut_.irq_o, lead + 2 <= 3) << "pending " << pending << " lead " << lead;
      if (dut_.irq_o) send(kIsr, channel);
      tick(6);
    }
  }
}

TEST_F(AxiGpioClocks, BothChannelsInOneClockSetBothStatusBits) {
  dut_.gpio_i = 0x8000;
  dut_.gpio2_i = 0x0001;
  tick(8);
  dut_.s_axi_araddr_i = kIsr;
  dut_.s_axi_arvalid_i = 1;
  tick();
  dut_.s_axi_arvalid_i = 0;
  for (int i = 0; i < 8 && !dut_.s_axi_rvalid_o; ++i) tick();
  ASSERT_TRUE(dut_.s_axi_rvalid_o);
  EXPECT_EQ(dut_.s_axi_rdata_o, kChannel1 | kChannel2);
}

}  // namespace
}  // namespace armature::test::gpio
