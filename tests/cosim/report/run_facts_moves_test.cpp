// What RunFactsCollector measures of moves and holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cosim/support/run_facts_rows.hpp"

namespace armature::cosim {
namespace {

using testing::Each;

using RunFactsMoves = test::RunFactsRows;

TEST_F(RunFactsMoves, AMoveIsWaitingUnderWayAndThenEndedOrCutShort) {
  const auto given = [&](const CommandKind& kind, std::uint32_t index) {
    CommandSpec move;
    move.kind = kind;
    move.index = index;
    collector.add(move);
  };
  const auto expect_open = [&](std::int64_t waiting, std::int64_t under_way) {
    EXPECT_EQ(collector.facts().moves_waiting, waiting);
    EXPECT_EQ(collector.facts().moves_under_way, under_way);
  };
  for (std::uint32_t i = 0; i < 4; ++i) given(LineSpec{}, i);
  given(StopSpec{}, 4);
  expect_open(4, 0);
  report(MoveStarted{.tag = 0});
  expect_open(3, 1);
  report(MoveStarted{.tag = 1});
  expect_open(2, 2);
  finish(9);
  expect_open(2, 1);
  cut_short();
  expect_open(2, 0);
  report(MoveRefused{.tag = 2});
  expect_open(1, 0);
  report(MoveStarted{.tag = 3});
  expect_open(0, 1);
  finish(9);
  expect_open(0, 0);
}

TEST_F(RunFactsMoves, CountsTheMovesThatBeginAfterAStopThatNobodyAskedFor) {
  for (std::uint32_t tag = 0; tag < 5; ++tag) report(MoveStarted{.tag = tag, .unasked_stop = tag == 2 || tag == 4});
  EXPECT_EQ(collector.facts().unasked_stops(), 2);
}

TEST_F(RunFactsMoves, AMoveTookTheTicksThatItsEndReports) {
  for (std::uint32_t tag = 0; tag < 5; ++tag) report(MoveStarted{.tag = tag});
  EXPECT_THAT(collector.facts().taken_ticks, Each(std::nullopt));
  finish(8);
  finish(0);  // nothing to drive
  cut_short();
  finish(9);
  const std::vector<std::optional<std::int64_t>> taken = {8, 0, std::nullopt, 9, std::nullopt};
  EXPECT_EQ(collector.facts().taken_ticks, taken);
  EXPECT_EQ(collector.facts().moves.size(), 5u);
  EXPECT_EQ(collector.facts().moves_finished, 3);
}

TEST_F(RunFactsMoves, AMoveWasBlendedOrStoppedAtItsEndOnlyIfItGotThere) {
  const auto begin = [&](std::uint32_t tag, double blend_mm, bool continues) {
    CommandSpec given;
    given.kind = LineSpec{.path = {.blend_mm = blend_mm}};
    given.index = tag;
    collector.add(given);
    report(MoveStarted{.kind = MoveKind::kLine, .tag = tag, .duration = Ticks{9}, .continues = continues});
  };
  const auto expect_blended = [&](const std::vector<std::optional<bool>>& expected) {
    const RunFacts facts = collector.facts();
    std::vector<std::optional<bool>> got;
    for (std::size_t i = 0; i < facts.moves.size(); ++i) got.push_back(facts.blended_with_next(i));
    EXPECT_EQ(got, expected);
  };
  begin(0, 1, false);
  expect_blended({std::nullopt});  // still under way
  begin(1, 0, true);               // in the corner
  expect_blended({true, std::nullopt});
  finish(9);
  finish(9);
  expect_blended({true, std::nullopt});  // of the second one no blend was asked for
  begin(2, 1, false);
  finish(9);
  expect_blended({true, std::nullopt, false});
  begin(3, 1, false);
  cut_short();
  begin(4, 1, false);
  expect_blended({true, std::nullopt, false, std::nullopt, std::nullopt});
  begin(5, 0, true);
  begin(6, 0, true);  // no blend was asked for: the paths are tangent, or a program asked
  expect_blended({true, std::nullopt, false, std::nullopt, true, true, std::nullopt});
}

TEST_F(RunFactsMoves, AHoldCountsWhileTheSetPointsStand) {
  next.telemetry.state = MotionState::kHolding;
  next.telemetry.rate = 0.5;
  tick(0, 0);
  next.telemetry.rate = 0;
  tick(0, 0);
  tick(0, 0);
  next.telemetry.state = MotionState::kIdle;
  tick(0, 0);
  EXPECT_DOUBLE_EQ(collector.facts().held_s, 1e-4);
}

}  // namespace
}  // namespace armature::cosim
