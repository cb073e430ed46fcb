#include "controller/drivers/axi_timer.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/mock_register_bus.hpp"

namespace armature {
namespace {

// From the AXI Timer v2.0 register description, not from the generated header.
constexpr RegAddr kTcsr0{0x4280'0000};
constexpr RegAddr kTlr0{0x4280'0004};
constexpr std::uint32_t kDown = 1u << 1, kGenerate = 1u << 2, kAutoReload = 1u << 4, kLoad = 1u << 5,
                        kInterrupt = 1u << 6, kEnable = 1u << 7, kFlag = 1u << 8;
constexpr std::uint32_t kRunning = kDown | kGenerate | kAutoReload | kInterrupt | kEnable;

TEST(AxiTimer, LoadsThePeriodBeforeEnabling) {
  testing::StrictMock<test::MockRegisterBus> bus;
  const testing::InSequence in_order;
  EXPECT_CALL(bus, write32(kTlr0, 2'498u));  // 50 us at 50 MHz, minus the 2 cycles of the reload
  EXPECT_CALL(bus, write32(kTcsr0, kLoad));
  EXPECT_CALL(bus, write32(kTcsr0, kRunning));
  AxiTimer{bus}.start(Cycles{2'500});
}

TEST(AxiTimer, AcknowledgesWithoutStopping) {
  testing::StrictMock<test::MockRegisterBus> bus;
  EXPECT_CALL(bus, write32(kTcsr0, kRunning | kFlag));
  AxiTimer{bus}.acknowledge();
}

}  // namespace
}  // namespace armature
