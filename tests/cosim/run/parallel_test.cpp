// Work on several threads: everything once, and nothing more after a refusal or an error.
#include "cosim/run/parallel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace armature::cosim {
namespace {

TEST(ForEachInParallel, DoesEachPieceOnceByThreadsOfItsOwn) {
  constexpr std::size_t kCount = 200;
  constexpr int kJobs = 4;
  std::array<std::atomic<int>, kCount> done{};
  std::array<std::atomic<int>, kJobs> busy{};
  for_each_in_parallel(kCount, kJobs, [&](std::size_t i, int thread) {
    auto& mine = busy.at(static_cast<std::size_t>(thread));
    EXPECT_EQ(mine++, 0);
    ++done.at(i);
    --mine;
    return true;
  });
  for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
}

TEST(ForEachInParallel, BeginsNoMoreAfterARefusal) {
  std::vector<std::size_t> begun;
  for_each_in_parallel(10, 1, [&](std::size_t i, int) {
    begun.push_back(i);
    return i < 3;
  });
  EXPECT_EQ(begun, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(ForEachInParallel, ThrowsWhatAPieceHasThrownAfterAllHaveEnded) {
  std::atomic<int> running{0};
  const auto work = [&](std::size_t i, int) {
    ++running;
    if (i == 5) {
      --running;
      throw std::runtime_error{"piece 5"};
    }
    --running;
    return true;
  };
  EXPECT_THROW(for_each_in_parallel(100, 3, work), std::runtime_error);
  EXPECT_EQ(running, 0);
  for_each_in_parallel(0, 3, work);
}

}  // namespace
}  // namespace armature::cosim
