#include "controller/base/spsc_queue.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <thread>

namespace armature {
namespace {

TEST(SpscQueue, IsEmptyAtFirst) {
  SpscQueue<int, 3> queue;
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.full());
  EXPECT_EQ(queue.try_pop(), std::nullopt);
}

TEST(SpscQueue, HoldsExactlyItsCapacityInOrder) {
  SpscQueue<int, 3> queue;
  for (int round = 0; round < 5; ++round) {  // beyond the end of the ring
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(queue.try_push(i));
    EXPECT_TRUE(queue.full());
    EXPECT_FALSE(queue.try_push(99));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.try_pop(), i);
    EXPECT_TRUE(queue.empty());
  }
}

TEST(SpscQueue, ClearDropsEverything) {
  SpscQueue<int, 3> queue;
  ASSERT_TRUE(queue.try_push(1));
  ASSERT_TRUE(queue.try_push(2));
  queue.clear();
  EXPECT_TRUE(queue.empty());
  ASSERT_TRUE(queue.try_push(3));
  EXPECT_EQ(queue.try_pop(), 3);
}

TEST(SpscQueue, TheFrontCanBeLookedAtBeforeItIsTakenOut) {
  SpscQueue<int, 2> queue;
  EXPECT_EQ(queue.front(), nullptr);
  for (int round = 0; round < 5; ++round) {  // beyond the end of the ring
    ASSERT_TRUE(queue.try_push(round));
    ASSERT_TRUE(queue.try_push(round + 100));
    for (const int expected : {round, round + 100}) {
      ASSERT_NE(queue.front(), nullptr);
      EXPECT_EQ(*queue.front(), expected);
      queue.drop_front();
    }
    EXPECT_TRUE(queue.empty());
    EXPECT_EQ(queue.front(), nullptr);
  }
}

TEST(SpscQueue, ASlotIsFilledBeforeItIsAdded) {
  SpscQueue<int, 2> queue;
  for (int round = 0; round < 5; ++round) {  // beyond the end of the ring
    EXPECT_TRUE(queue.has_room(2));
    EXPECT_FALSE(queue.has_room(3));
    queue.free_slot() = round;
    EXPECT_TRUE(queue.empty());
    queue.push_slot();
    EXPECT_TRUE(queue.has_room(1));
    EXPECT_FALSE(queue.has_room(2));
    queue.free_slot() = round + 100;
    queue.push_slot();
    EXPECT_FALSE(queue.has_room(1));
    queue.free_slot() = 99;  // even while the queue is full
    for (const int added : {0, 100}) EXPECT_EQ(queue.try_pop(), round + added);
    EXPECT_TRUE(queue.empty());
  }
}

TEST(SpscQueue, TwoThreadsLoseAndReorderNothing) {
  constexpr std::uint64_t kCount = 200'000;
  struct Pair {
    std::uint64_t a = 0, b = 0;
  };
  SpscQueue<Pair, 7> queue;
  std::thread producer{[&] {
    for (std::uint64_t i = 0; i < kCount;) {
      if (queue.try_push({i, ~i})) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  }};
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < kCount;) {
    if (const auto pair = queue.try_pop()) {
      if (pair->a != i || pair->b != ~i) ++wrong;
      ++i;
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace armature
