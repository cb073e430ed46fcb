// axi_gpio through its AXI port, as vendor and Linux drivers use it. Offsets are written out on purpose: they are the
// vendor's.
#include <algorithm>
#include <array>
#include <cstdint>

#include "Vaxi_gpio.h"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

constexpr std::uint32_t kData = 0x000, kTri = 0x004, kData2 = 0x008, kTri2 = 0x00C;
constexpr std::uint32_t kGier = 0x11C, kIsr = 0x120, kIer = 0x128;
constexpr std::uint32_t kGlobalEnable = 0x8000'0000U, kChannel1 = 1, kChannel2 = 2;
constexpr std::uint32_t kMapBytes = 0x200;

class AxiGpio : public AxiStallTest<Vaxi_gpio> {
 protected:
  void SetUp() override { restart(0); }

  // Reset with these levels on the inputs.
  void restart(std::uint16_t inputs) {
    dut_.gpio_i = inputs;
    AxiStallTest::SetUp();
    axi_.step(8);
  }

  void write(std::uint32_t offset, std::uint32_t value, unsigned strobe = 0xF) {
    AxiStallTest::write(offset, value, strobe);
    axi_.step();
  }

  void enable(std::uint32_t channels) {
    write(kIer, channels);
    write(kGier, kGlobalEnable);
  }

  void input(std::uint16_t level) {
    dut_.gpio_i = level;
    axi_.step(8);
  }
};
INSTANTIATE_AXI_STALLS(AxiGpio);

TEST_P(AxiGpio, ResetValues) {
  EXPECT_EQ(dut_.gpio_o, 0);
  EXPECT_EQ(dut_.irq_o, 0);
  EXPECT_EQ(read(kTri2), 0xFFFFU);
  for (const std::uint32_t offset : {kData, kTri, kData2, kGier, kIsr, kIer}) EXPECT_EQ(read(offset), 0U) << offset;
}

TEST_P(AxiGpio, OutputsFollowDataBitByBitAndReadBack) {
  for (int bit = 0; bit < 16; ++bit) {
    write(kData, 1U << bit);
    EXPECT_EQ(dut_.gpio_o, 1U << bit);
    EXPECT_EQ(read(kData), 1U << bit);
  }
  write(kData, 0xFFFF'A55A);
  EXPECT_EQ(read(kData), 0xA55AU);
  write(kData, 0xFFFF'FFFF, 0x2);
  EXPECT_EQ(dut_.gpio_o, 0xFF5A) << "byte strobes";
  EXPECT_EQ(read(kData2), 0U);
}

TEST_P(AxiGpio, ReleasedOutputIsLowAndKeepsItsData) {
  write(kData, 0xFFFF);
  write(kTri, 0x00F1);
  EXPECT_EQ(read(kTri), 0x00F1U);
  EXPECT_EQ(dut_.gpio_o, 0xFF0E);
  EXPECT_EQ(read(kData), 0xFFFFU);
  write(kTri, 0);
  EXPECT_EQ(dut_.gpio_o, 0xFFFF);
}

TEST_P(AxiGpio, InputsReadBitByBitAndIgnoreWrites) {
  for (int bit = 0; bit < 16; ++bit) {
    input(static_cast<std::uint16_t>(1U << bit));
    EXPECT_EQ(read(kData2), 1U << bit);
  }
  write(kData2, 0xFFFF);
  write(kTri2, 0);
  EXPECT_EQ(read(kData2), 0x8000U);
  EXPECT_EQ(read(kTri2), 0xFFFFU);
  EXPECT_EQ(dut_.gpio_o, 0);
}

TEST_P(AxiGpio, EveryInputChangeSetsTheStatusAndItsDriverAcknowledgesIt) {
  enable(kChannel2);
  for (int bit = 0; bit < 16; ++bit) {
    for (const bool level : {true, false}) {
      input(level ? static_cast<std::uint16_t>(1U << bit) : 0);
      ASSERT_EQ(dut_.irq_o, 1) << "bit " << bit << " level " << level;
      const std::uint32_t status = read(kIsr);
      EXPECT_EQ(status, kChannel2);
      write(kIsr, status);  // what was read
      EXPECT_EQ(dut_.irq_o, 0);
      EXPECT_EQ(read(kIsr), 0U);
    }
  }
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
  for (const int level : {0xFFFF, 0x0001, 0x8000}) {
    restart(static_cast<std::uint16_t>(level));
    EXPECT_EQ(read(kData2), static_cast<std::uint32_t>(level));
    EXPECT_EQ(read(kIsr), 0U);
    input(static_cast<std::uint16_t>(level ^ 0x10));
    EXPECT_EQ(read(kIsr), kChannel2);
  }
}

TEST_P(AxiGpio, WordsWithoutARegisterReadZeroAndIgnoreWritesWithoutAnError) {
  const std::array<std::uint32_t, 7> named = {kData, kTri, kData2, kTri2, kGier, kIsr, kIer};
  for (std::uint32_t offset = 0; offset < kMapBytes; offset += 4) {
    if (std::find(named.begin(), named.end(), offset) != named.end()) continue;
    write(offset, 0xFFFF'FFFF);
    EXPECT_EQ(read(offset), 0U) << std::hex << offset;
  }
  for (const std::uint32_t offset : {kData, kTri, kGier, kIsr, kIer}) EXPECT_EQ(read(offset), 0U) << std::hex << offset;
  for (const std::uint32_t offset : {kMapBytes, kMapBytes + 0x11C, 0x1004U, 0xFFFCU}) {
    EXPECT_EQ(axi_.write(offset, 0xFFFF'FFFF), AxiResp::kSlvErr) << std::hex << offset;
    EXPECT_EQ(axi_.read(offset), (AxiReadResult{AxiResp::kSlvErr, 0xBADA'CCE5})) << std::hex << offset;
  }
}

// Cycle by cycle, without the bus.
class AxiGpioTiming : public VerilatedTest<Vaxi_gpio> {};

TEST_F(AxiGpioTiming, PinReachesTheInterruptInFourEdgesAndOutlivesAnAcknowledgeInItsCycle) {
  dut_.gpio_i = 0;
  dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = dut_.s_axi_arvalid_i = 0;
  dut_.s_axi_bready_i = dut_.s_axi_rready_i = 1;
  reset();
  const auto send = [this](std::uint32_t offset, std::uint32_t value) {
    dut_.s_axi_awaddr_i = static_cast<std::uint16_t>(offset);
    dut_.s_axi_wdata_i = value;
    dut_.s_axi_wstrb_i = 0xF;
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 1;
    tick();
    dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 0;
  };
  send(kIer, kChannel2);
  tick(6);
  send(kGier, kGlobalEnable);
  tick(6);
  for (const bool pending : {false, true}) {
    for (int lead = 0; lead < 6; ++lead) {  // edges from the pin change to the acceptance of a toggling write
      if (pending) {
        send(kIsr, kChannel2);
        tick(6);
      }
      ASSERT_EQ(dut_.irq_o, pending);
      dut_.gpio_i ^= 1;
      for (int edge = 1; edge <= lead; ++edge) {
        tick();
        EXPECT_EQ(dut_.irq_o, pending || edge >= 4) << "edge " << edge;
      }
      send(kIsr, kChannel2);
      tick(6);
      // The change sets the status on edge 3, the write acts on edge lead + 2: only a later one leaves it clear.
      EXPECT_EQ(dut_.irq_o, lead + 2 <= 3) << "pending " << pending << " lead " << lead;
      if (dut_.irq_o) send(kIsr, kChannel2);
      tick(6);
    }
  }
}

}  // namespace
}  // namespace armature::test
