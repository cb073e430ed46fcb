#include "cosim/snapshot/point_pacing.hpp"

#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr PointPacing::Rules kRules{
    .between = milliseconds{20}, .part_of_the_run = 50, .most = 10, .more = 2, .finest = 1'000};

TEST(PointPacing, TakesAPointAfterSomeTime) {
  PointPacing pacing{kRules};
  EXPECT_FALSE(pacing.is_due(milliseconds{19}, 1, {}));
  EXPECT_TRUE(pacing.is_due(milliseconds{20}, 1, {}));
  pacing.begin_point(milliseconds{20}, 0);
  EXPECT_FALSE(pacing.is_due(milliseconds{39}, 2, {}));
  EXPECT_TRUE(pacing.is_due(milliseconds{40}, 2, {}));
}

TEST(PointPacing, TakesFewerPointsInALongRun) {
  PointPacing pacing{kRules};
  pacing.begin_point(seconds{49}, 0);
  EXPECT_FALSE(pacing.is_due(seconds{49} + milliseconds{999}, 1, {}));
  EXPECT_TRUE(pacing.is_due(seconds{50}, 1, {}));
}

TEST(PointPacing, TakesFewerPointsWhereAPointTakesLong) {
  PointPacing pacing{kRules};
  pacing.begin_point(seconds{1}, 0);
  pacing.end_point(milliseconds{10});
  EXPECT_FALSE(pacing.is_due(seconds{1} + milliseconds{199}, 1, {}));
  EXPECT_TRUE(pacing.is_due(seconds{1} + milliseconds{200}, 1, {}));
}

TEST(PointPacing, HalvesTheWayBackAgainAndAgain) {
  PointPacing pacing{kRules};
  pacing.begin_way(8'000);
  EXPECT_FALSE(pacing.is_due(milliseconds{1}, 1, 4'001));
  EXPECT_TRUE(pacing.is_due(milliseconds{1}, 1, 4'000));
  pacing.begin_point(milliseconds{1}, 4'000);
  EXPECT_FALSE(pacing.is_due(milliseconds{2}, 2, 2'001));
  EXPECT_TRUE(pacing.is_due(milliseconds{2}, 2, 2'000));
  EXPECT_FALSE(pacing.is_due(milliseconds{2}, 2, {})) << "a run that only goes forwards";
}

TEST(PointPacing, TakesNoPointNearerThanTheFinest) {
  PointPacing pacing{kRules};
  pacing.begin_way(8'000);
  EXPECT_TRUE(pacing.is_due(milliseconds{1}, 1, 1'000));
  EXPECT_FALSE(pacing.is_due(milliseconds{1}, 1, 999));
}

TEST(PointPacing, WorksOnTheWayBackAtLeastAsLongAsAPointTakes) {
  PointPacing pacing{kRules};
  pacing.end_point(milliseconds{2});
  pacing.begin_way(8'000);
  EXPECT_FALSE(pacing.is_due(milliseconds{1}, 1, 4'000));
  EXPECT_TRUE(pacing.is_due(milliseconds{2}, 1, 4'000));
}

TEST(PointPacing, KeepsSomePointsForWaysBack) {
  PointPacing pacing{kRules};
  pacing.begin_way(8'000);
  EXPECT_TRUE(pacing.is_due(seconds{1}, 9, {}));
  EXPECT_FALSE(pacing.is_due(seconds{1}, 10, {}));
  EXPECT_TRUE(pacing.is_due(seconds{1}, 11, 4'000));
  EXPECT_FALSE(pacing.is_due(seconds{1}, 12, 4'000));
}

TEST(PointPacing, TakesNoneAfterTheHostHasRefusedOne) {
  PointPacing pacing{kRules};
  pacing.begin_way(8'000);
  pacing.refused(3);
  EXPECT_FALSE(pacing.is_due(seconds{1}, 3, 4'000));
  EXPECT_TRUE(pacing.is_due(seconds{1}, 2, 4'000)) << "there is room where the process was taken back";
}

}  // namespace
}  // namespace armature::cosim
