#include "controller/activity/move_queue.hpp"

#include <gmock/gmock.h>

#include "tests/controller/activity/owner_bench.hpp"

namespace armature {
namespace {

using ::testing::ElementsAre;

JointMove move(std::uint32_t tag) {
  return {.tag = tag};
}

TEST(MoveQueue, AMoveFollowsTheOneBeforeUnlessAMoveBetweenThemWasRefused) {
  test::OwnerBench bench;
  MoveQueue& queue = bench.queue;
  ASSERT_TRUE(queue.push(move(1)));
  queue.break_chain();
  ASSERT_TRUE(queue.push(move(2)));
  ASSERT_TRUE(queue.push(move(3)));
  EXPECT_NE(queue.next(), nullptr);
  queue.drop_front();
  EXPECT_NE(queue.front(), nullptr);
  EXPECT_EQ(queue.next(), nullptr);
  queue.drop_front();
  ASSERT_NE(queue.next_if<JointMove>(), nullptr);
  EXPECT_EQ(queue.next_if<JointMove>()->tag.number(), 3u);
  EXPECT_EQ(queue.next_if<Dwell>(), nullptr);
}

TEST(MoveQueue, RefusesAllThatWaitInTheirOrder) {
  test::OwnerBench bench;
  for (const std::uint32_t tag : {4u, 2u, 9u}) ASSERT_TRUE(bench.queue.push(move(tag)));
  bench.queue.drop(Refusal::kNotReady);
  EXPECT_TRUE(bench.queue.empty());
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(4u, 2u, 9u));
}

TEST(MoveQueue, AReplacingMoveDropsOnlyWhatCameBeforeIt) {
  test::OwnerBench bench;
  MoveQueue& queue = bench.queue;
  ASSERT_TRUE(queue.push(move(1)));
  const std::uint32_t replacing = queue.count_replacing();
  ASSERT_TRUE(queue.push(move(2)));
  queue.set_replaced_by(replacing);
  queue.drop(Refusal::kReplaced);
  EXPECT_THAT(bench.refused(Refusal::kReplaced), ElementsAre(1u));
  queue.drop(Refusal::kNotReady);
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(2u));
}

TEST(MoveQueue, MoreWaitsInTheInboxOfPrograms) {
  test::OwnerBench bench;
  EXPECT_FALSE(bench.queue.more_wait());
  ASSERT_TRUE(bench.program.try_push(Hold{}));
  EXPECT_TRUE(bench.queue.more_wait());
  EXPECT_TRUE(bench.queue.empty());
}

TEST(MoveQueue, IsFullAtItsSize) {
  test::OwnerBench bench;
  for (std::uint32_t i = 0; i < MoveQueue::kMoves; ++i) ASSERT_TRUE(bench.queue.push(move(i)));
  EXPECT_TRUE(bench.queue.full());
  EXPECT_FALSE(bench.queue.push(move(99)));
}

}  // namespace
}  // namespace armature
