#include "cosim/cpu/fiber.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace armature::cosim {
namespace {

TEST(Fiber, RunsBetweenResumeAndSuspend) {
  std::vector<int> order;
  Fiber* self = nullptr;
  Fiber fiber{[&] {
    order.push_back(1);
    self->suspend();
    order.push_back(3);
  }};
  self = &fiber;
  fiber.resume();
  order.push_back(2);
  EXPECT_FALSE(fiber.finished());
  fiber.resume();
  EXPECT_TRUE(fiber.finished());
  EXPECT_EQ(order, (std::vector<int>{1, 2, 3}));
}

TEST(Fiber, KeepsItsStackAcrossManySwitchesBetweenTwoFibers) {
  std::array<Fiber*, 2> self{};
  std::array<long, 2> sums{};
  const auto body = [&](std::size_t i) {
    std::array<long, 512> local{};
    for (std::size_t step = 0; step < 10'000; ++step) {
      local[step % local.size()] += static_cast<long>(step * (i + 1));
      self[i]->suspend();
    }
    for (const long value : local) sums[i] += value;
  };
  Fiber a{[&] { body(0); }};
  Fiber b{[&] { body(1); }};
  self = {&a, &b};
  while (!a.finished() || !b.finished()) {
    if (!a.finished()) a.resume();
    if (!b.finished()) b.resume();
  }
  EXPECT_EQ(sums[0], 9'999L * 10'000 / 2);
  EXPECT_EQ(sums[1], 9'999L * 10'000);
}

TEST(Fiber, SuspendsFromADeepCall) {
  Fiber* self = nullptr;
  int depth_reached = 0;
  const auto deep = [&](const auto& again, int depth) -> int {
    if (depth == 0) {
      self->suspend();
      return 0;
    }
    return again(again, depth - 1) + 1;
  };
  Fiber fiber{[&] { depth_reached = deep(deep, 500); }};
  self = &fiber;
  fiber.resume();
  EXPECT_EQ(depth_reached, 0);
  fiber.resume();
  EXPECT_EQ(depth_reached, 500);
}

}  // namespace
}  // namespace armature::cosim
