#include "controller/base/spsc_slot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

namespace armature {
namespace {

TEST(SpscSlot, HoldsOneElementUntilItIsDropped) {
  SpscSlot<int> slot;
  for (int round = 0; round < 3; ++round) {
    EXPECT_FALSE(slot.full());
    EXPECT_EQ(slot.front(), nullptr);
    slot.free_slot() = round;
    EXPECT_EQ(slot.front(), nullptr);
    slot.push_slot();
    EXPECT_TRUE(slot.full());
    ASSERT_NE(slot.front(), nullptr);
    EXPECT_EQ(*slot.front(), round);
    slot.drop_front();
  }
  EXPECT_EQ(slot.front(), nullptr);
}

TEST(SpscSlot, TwoThreadsExchangeWholeElements) {
  constexpr std::uint32_t kCount = 2'000;
  SpscSlot<std::array<std::uint32_t, 100>> slot;
  std::thread producer{[&] {
    for (std::uint32_t i = 0; i < kCount; ++i) {
      while (slot.full()) std::this_thread::yield();
      slot.free_slot().fill(i);
      slot.push_slot();
    }
  }};
  std::uint32_t wrong = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    while (slot.front() == nullptr) std::this_thread::yield();
    for (const std::uint32_t value : *slot.front()) wrong += value != i ? 1u : 0u;
    slot.drop_front();
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace armature
