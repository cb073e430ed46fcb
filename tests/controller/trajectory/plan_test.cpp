#include "controller/trajectory/plan/plan.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

// Two segments of 60 and 40 ticks; a move of 50 ticks and another one that ends 30 ticks later.
class PlanTest : public testing::Test {
 protected:
  PlanTest() {
    CartesianPlan& path = store->path;
    path.count = 2;
    path.segments[0] = {.start = Ticks{0}, .duration = Ticks{60}};
    path.segments[1] = {.start = Ticks{60}, .duration = Ticks{40}};
    path.duration = Ticks{100};
    path.target = test::degrees({1, 2, 3, 4, 5, 6});
    JointChain& chain = store->chain;
    chain.count = 2;
    chain.starts = {Ticks{0}, Ticks{50}};
    chain.duration = Ticks{80};
    chain.target = test::degrees({6, 5, 4, 3, 2, 1});
    next_store->path = path;
  }
  static void expect_span(const Plan& plan, std::size_t move, std::int64_t start, std::int64_t end) {
    SCOPED_TRACE(move);
    EXPECT_EQ(span_of(plan, move).start, Ticks{start});
    EXPECT_EQ(span_of(plan, move).end, Ticks{end});
  }

  const std::unique_ptr<PieceStore> store = std::make_unique<PieceStore>(), next_store = std::make_unique<PieceStore>();
};

TEST_F(PlanTest, WithoutPiecesTakesNoTimeAndHasNoMoves) {
  EXPECT_EQ(duration(Plan{}), Ticks{0});
  EXPECT_EQ(moves_in(Plan{}), 0u);
  EXPECT_EQ(Plan{}.only_path(), nullptr);
  EXPECT_FALSE(is_dwell(Plan{}));
}

// The path until 70 of its 100 ticks, the whole chain, and a path from 20 of its 100 ticks on.
TEST_F(PlanTest, PiecesFollowEachOtherInItsTimeAndHaveTheirOwn) {
  Plan plan{Piece{store->path}};
  plan.last().until = Ticks{70};
  plan.add(Piece{store->chain}, Ticks{0}, true);
  plan.add(Piece{next_store->path}, Ticks{20}, true);
  EXPECT_EQ(duration(plan), Ticks{70 + 80 + 80});
  EXPECT_EQ(target_of(plan), next_store->path.target);
  EXPECT_EQ(plan.only_path(), nullptr);
  ASSERT_EQ(moves_in(plan), 6u);
  expect_span(plan, 0, 0, 60);
  expect_span(plan, 1, 60, 70);
  expect_span(plan, 2, 70, 120);
  expect_span(plan, 3, 120, 150);
  expect_span(plan, 4, 150, 190);
  expect_span(plan, 5, 190, 230);

  EXPECT_EQ(&plan.piece_at(0.0), &plan.pieces[0]);
  EXPECT_EQ(&plan.piece_at(69.9), &plan.pieces[0]);
  EXPECT_EQ(&plan.piece_at(70.0), &plan.pieces[1]);
  EXPECT_EQ(&plan.piece_at(150.0), &plan.pieces[2]);
  EXPECT_EQ(&plan.piece_at(1e6), &plan.pieces[2]);
  EXPECT_EQ(plan.pieces[1].own_ticks(75.5), 5.5);
  EXPECT_EQ(plan.pieces[2].own_ticks(150.0), 20.0);
  EXPECT_EQ(&plan.piece_with(3), &plan.pieces[1]);
}

TEST_F(PlanTest, NeighbourPiecesShareAPieceStore) {
  Plan plan{Piece{store->path}};
  EXPECT_EQ(plan.stores(), 1u);
  plan.add(Piece{store->chain});
  EXPECT_EQ(plan.stores(), 1u);
  plan.add(Piece{next_store->path});
  EXPECT_EQ(plan.stores(), 2u);
}

TEST_F(PlanTest, ASegmentOfAWindowMayStartBeforeIt) {
  store->path.segments[0].start = Ticks{-25};
  const Plan window{Piece{store->path}};
  EXPECT_EQ(window.only_path(), &store->path);
  expect_span(window, 0, -25, 35);
}

TEST_F(PlanTest, OnlyAPlanOfOnePieceHasOutputs) {
  store->path.outputs.insert({.ticks = 3.0, .pin = 1});
  Plan plan{Piece{store->path}};
  EXPECT_EQ(outputs_of(plan).size(), 1u);
  plan.add(Piece{store->chain});
  EXPECT_TRUE(outputs_of(plan).empty());
}

TEST_F(PlanTest, AStoreKeepsACopyOfEachKind) {
  const JointPlan dwell{.duration = Ticks{7}, .is_dwell = true};
  const Piece joints = next_store->keep(dwell), chain = next_store->keep(store->chain),
              path = next_store->keep(store->path);
  EXPECT_EQ(joints.joints, &next_store->joints);
  EXPECT_EQ(chain.chain, &next_store->chain);
  EXPECT_EQ(path.path, &next_store->path);
  EXPECT_TRUE(is_dwell(Plan{joints}));
  EXPECT_EQ(duration(Plan{joints}), Ticks{7});
  EXPECT_EQ(chain.until, Ticks{80});
  EXPECT_EQ(moves_in(Plan{path}), 2u);
}

}  // namespace
}  // namespace armature
