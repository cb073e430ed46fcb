#include "cosim/cpu/fiber.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
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

// Under AddressSanitizer a stack that is given back with its outermost frames still marked makes the next owner of
// these addresses, which the system chooses, fail at its first write there.
void expect_free(char* on_stack) {
  const auto page_bytes = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  char* const page = on_stack - std::bit_cast<std::uintptr_t>(on_stack) % page_bytes;
  void* const again =
      ::mmap(page, page_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
  ASSERT_EQ(again, page) << "the stack is still mapped";
  std::memset(again, 1, page_bytes);
  EXPECT_EQ(page[page_bytes - 1], 1);
  EXPECT_EQ(::munmap(again, page_bytes), 0);
}

TEST(Fiber, GivesItsStackBackWithoutATrace) {
  char* on_stack = nullptr;
  {
    Fiber fiber{[&] {
      char local = 0;
      on_stack = &local;
    }};
    fiber.resume();
    ASSERT_TRUE(fiber.finished());
  }
  expect_free(on_stack);
}

TEST(Fiber, AnAbandonedOneRunsNothingMoreAndGivesItsStackBack) {
  char* on_stack = nullptr;
  int executed = 0;
  struct Counted {
    int& count;
    ~Counted() { ++count; }
  };
  const auto suspend_within = [&](Fiber& fiber) noexcept {  // nothing may be thrown through it
    Counted counted{executed};
    char local[64] = {};
    on_stack = local;
    fiber.suspend();
    ++executed;
  };
  {
    Fiber* self = nullptr;
    Fiber fiber{[&] { suspend_within(*self); }};
    self = &fiber;
    fiber.resume();
    ASSERT_FALSE(fiber.finished());
  }
  EXPECT_EQ(executed, 0);
  expect_free(on_stack);
}

}  // namespace
}  // namespace armature::cosim
