#include "cosim/iss/mpcore_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "controller/board/mpcore.hpp"
#include "tests/cosim/iss/scripted_bus.hpp"

namespace armature::cosim::iss {
namespace {

namespace m = board::mpcore;

constexpr std::uint32_t kLogicEnable = m::kIcdEnable + 4 * m::kLogicWord;
constexpr std::uint32_t kLogicDisable = m::kIcdDisable + 4 * m::kLogicWord;
constexpr std::uint32_t kLogicPending = m::kIcdPending + 4 * m::kLogicWord;

// The firmware computes cycles of the logic from the timer (controller/board/board_bus.cpp).
TEST(MpcoreModel, TimerGivesTheCycleOfTheLogicAgain) {
  std::mt19937_64 random{20261128};
  ScriptedBus bus;
  MpcoreModel mpcore;
  for (int i = 0; i < 100'000; ++i) {
    bus.cycle = static_cast<std::int64_t>(i < 1000 ? static_cast<std::uint64_t>(i) : random() >> 8);
    const std::uint64_t ticks = std::uint64_t{mpcore.read(m::kTimerHigh, &bus)} << 32 | mpcore.read(m::kTimerLow, &bus);
    ASSERT_EQ(static_cast<std::int64_t>(ticks / m::kTimerTicks * m::kLogicCycles +
                                        ticks % m::kTimerTicks * m::kLogicCycles / m::kTimerTicks),
              bus.cycle);
  }
}

TEST(MpcoreModel, LinesAreEnabledAndDisabledOneByOne) {
  MpcoreModel mpcore;
  EXPECT_EQ(mpcore.enabled(), Interrupts::kEvent) << "always enabled";
  mpcore.write(kLogicEnable, 1u << 29, nullptr);  // interrupt 61
  EXPECT_EQ(mpcore.enabled(), Interrupts::kEvent | Interrupts::kTimer);
  mpcore.write(kLogicEnable, 6u << 29, nullptr);  // 62 and 63
  EXPECT_EQ(mpcore.enabled(), Interrupts::kEvent | Interrupts::kTimer | Interrupts::kUart | Interrupts::kGpio);
  mpcore.write(kLogicDisable, 1u << 29, nullptr);
  EXPECT_EQ(mpcore.enabled(), Interrupts::kEvent | Interrupts::kUart | Interrupts::kGpio);
}

TEST(MpcoreModel, AnEventIsPendingUntilItIsAcknowledged) {
  MpcoreModel mpcore;
  EXPECT_EQ(mpcore.read(m::kIccAcknowledge, nullptr), 1023u) << "nothing";
  mpcore.set_pending(Interrupts::kEvent | Interrupts::kUart);
  EXPECT_EQ(mpcore.read(m::kIcdPending, nullptr), 1u);
  EXPECT_EQ(mpcore.read(kLogicPending, nullptr), 1u << 30);
  EXPECT_EQ(mpcore.read(m::kIccAcknowledge, nullptr), 0u);
  EXPECT_EQ(mpcore.read(m::kIcdPending, nullptr), 0u);
  EXPECT_EQ(mpcore.read(kLogicPending, nullptr), 1u << 30) << "a line is not acknowledged here";
}

TEST(MpcoreModel, ASoftwareInterruptIsAnEventForTheOtherCore) {
  ScriptedBus bus;
  MpcoreModel mpcore;
  mpcore.write(m::kIcdSoftware, m::kToTheOtherCore | 1u, &bus);
  EXPECT_EQ(bus.events, 0) << "another interrupt";
  mpcore.write(m::kIcdSoftware, m::kToTheOtherCore | m::kEventId, &bus);
  EXPECT_EQ(bus.events, 1);
}

}  // namespace
}  // namespace armature::cosim::iss
