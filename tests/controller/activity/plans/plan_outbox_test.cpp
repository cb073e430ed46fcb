#include "controller/activity/plans/stages/plan_outbox.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

class PlanOutboxTest : public testing::Test {
 protected:
  [[nodiscard]] const CartesianPlan& path(std::uint32_t tag) {
    path_->count = 1;
    path_->segments[0].tag = Tag{tag};
    return *path_;
  }
  [[nodiscard]] static JointChain chain(std::uint32_t tag) { return JointChain{RetargetPlan{.tag = Tag{tag}}}; }
  static JointPlan joints(std::uint32_t tag) { return {.tag = Tag{tag}}; }
  // Core 0 does not read the oldest plan any more.
  void release(const Plan& plan) { store.release(plan.stores()); }

  const std::unique_ptr<Channel> channel = std::make_unique<Channel>();  // too large for a stack
  PlanStore& store = channel->plan_store;
  PlanOutbox outbox{*channel};

 private:
  const std::unique_ptr<CartesianPlan> path_ = std::make_unique<CartesianPlan>();
};

TEST_F(PlanOutboxTest, HasRoomForNinePlansOfOneOrTwoPieces) {
  for (std::size_t i = 0; i < PlanStore::kPlans; ++i) {
    ASSERT_TRUE(outbox.has_room());
    if (i % 2 == 0) outbox.join(path(1), Ticks{}, false);
    outbox.send(chain(2));
  }
  EXPECT_FALSE(outbox.has_room());
  const Plan oldest = *store.plans.try_pop();
  EXPECT_FALSE(outbox.has_room()) << "core 0 reads it until it releases it";
  release(oldest);
  EXPECT_TRUE(outbox.has_room());
  EXPECT_FALSE(outbox.has_room(2));
}

TEST_F(PlanOutboxTest, APlanOfThreePiecesTakesTheRoomOfTwo) {
  outbox.join(path(1), Ticks{}, false);
  outbox.join(chain(2), Ticks{}, true);
  outbox.join(path(3), Ticks{}, true);
  outbox.send_unsent();
  EXPECT_TRUE(outbox.has_room(PlanStore::kPlans - 2));
  EXPECT_FALSE(outbox.has_room(PlanStore::kPlans - 1));
  EXPECT_EQ(outbox.unsent().count, 0u);
}

TEST_F(PlanOutboxTest, WhatAnotherActivitySendsTakesRoomUntilItIsReleased) {
  const Plan plan = outbox.store(path(1));
  ASSERT_NE(plan.only_path(), nullptr);
  EXPECT_FALSE(outbox.has_room(PlanStore::kPlans));
  EXPECT_TRUE(outbox.all_over());
  EXPECT_TRUE(store.plans.empty());
  release(plan);
  EXPECT_TRUE(outbox.has_room(PlanStore::kPlans));
}

std::uint32_t tag_of(const Piece& piece) {
  if (piece.path != nullptr) return piece.path->segments[0].tag.number();
  if (piece.chain != nullptr) return piece.chain->moves[0].tag.number();
  return piece.joints->tag.number();
}

// Plans of all kinds, sent and released at random; some are begun and dropped. Whatever comes later, what core 0 has
// stays as it was sent.
TEST_F(PlanOutboxTest, NothingOverwritesWhatCore0Reads) {
  test::Random random{5};
  struct Sent {
    Plan plan;
    std::uint32_t first_tag = 0;
  };
  std::deque<Sent> sent;
  std::uint32_t tag = 1;
  std::size_t most = 0;
  for (int step = 0; step < 3'000; ++step) {
    const std::int64_t kind = random.integer(0, 6);
    if (kind < 3) {
      const std::size_t pieces = static_cast<std::size_t>(random.integer(1, outbox.has_room(2) ? 3 : 2));
      const bool path_first = random.integer(0, 1) == 0;
      const std::uint32_t first_tag = tag;
      for (std::size_t i = 0; i < pieces; ++i, ++tag) {
        if (path_first == (i % 2 == 0)) {
          outbox.join(path(tag), Ticks{}, false);
        } else {
          outbox.join(chain(tag), Ticks{}, false);
        }
      }
      if (outbox.has_room(outbox.unsent().stores()) && random.integer(0, 3) != 0) {
        outbox.send_unsent();
        sent.push_back({*store.plans.try_pop(), first_tag});
      } else {
        outbox.unsent() = {};
      }
    } else if (kind == 3 && outbox.has_room()) {
      outbox.send(joints(tag));
      sent.push_back({*store.plans.try_pop(), tag++});
    } else if (!sent.empty()) {
      release(sent.front().plan);
      sent.pop_front();
    }
    most = std::max(most, sent.size());
    for (const Sent& one : sent) {
      std::uint32_t expected = one.first_tag;
      for (const Piece& piece : one.plan.view()) ASSERT_EQ(tag_of(piece), expected++) << "step " << step;
    }
  }
  EXPECT_GE(most, 7u);
}

}  // namespace
}  // namespace armature
