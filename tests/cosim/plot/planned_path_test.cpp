// The drawn paths, against formulas written here.
#include "cosim/plot/planned_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/controller/support/spline_oracle.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

Json move_along(Json path) {
  return {{"path", std::move(path)}};
}

// Around an axis along x through (0, 20, 30), by `angle_deg` from (5, 20, 40) towards -y.
Json around(double angle_deg, double advance_mm) {
  const double angle = angle_deg * std::numbers::pi / 180;
  Json path = {
      {"start_mm", {5, 20, 40}},  {"end_mm", {5 + advance_mm, 20 - 10 * std::sin(angle), 30 + 10 * std::cos(angle)}},
      {"center_mm", {5, 20, 30}}, {"radius_mm", 10},
      {"angle_deg", angle_deg},   {"normal", {1, 0, 0}}};
  if (advance_mm != 0) path["advance_mm"] = advance_mm;
  return move_along(path);
}

void expect_around(double angle_deg, double advance_mm) {
  const SpacePoints points = planned_path(around(angle_deg, advance_mm));
  ASSERT_GE(static_cast<double>(points.size()), angle_deg / 5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    const double angle = share * angle_deg * std::numbers::pi / 180;
    const Vector3d expected{5 + share * advance_mm, 20 - 10 * std::sin(angle), 30 + 10 * std::cos(angle)};
    EXPECT_LT((points[i] - expected).norm(), 1e-9) << i;
  }
}

TEST(PlannedPath, OfALineIsItsEnds) {
  const SpacePoints points = planned_path(move_along({{"start_mm", {1, 2, 3}}, {"end_mm", {4, 5, 6}}}));
  EXPECT_EQ(points, (SpacePoints{{1, 2, 3}, {4, 5, 6}}));
}

TEST(PlannedPath, OfAnArcACircleAndAHelixGoesAroundAndAlong) {
  expect_around(130, 0);
  expect_around(360, 0);
  expect_around(800, 25);
  expect_around(800, -25);
}

TEST(PlannedPath, OfASplineIsTheSplineThroughItsPoints) {
  const std::vector<Vector3d> points{{0, 0, 0}, {30, 10, 0}, {40, 40, 20}, {0, 50, 30}};
  const SpacePoints drawn = planned_path(
      move_along({{"start_mm", {0, 0, 0}}, {"end_mm", {0, 50, 30}}, {"through_mm", {{30, 10, 0}, {40, 40, 20}}}}));
  const armature::test::SplineOracle oracle{points};
  ASSERT_FALSE(drawn.empty());
  EXPECT_EQ(drawn.front(), points.front());
  EXPECT_EQ(drawn.back(), points.back());
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    EXPECT_LT(oracle.distance(drawn[i]), 1e-9L) << i;
    EXPECT_LT((drawn[i] - drawn[i - 1]).norm(), 3.0) << i;
  }
}

TEST(PlannedPath, IsEmptyWithoutAPath) {
  EXPECT_TRUE(planned_path({{"kind", "joint"}}).empty());
  EXPECT_TRUE(planned_path(move_along(Json::object())).empty());
  // Twice the same point is no spline.
  const Json spline = {{"start_mm", {0, 0, 0}}, {"end_mm", {1, 0, 0}}, {"through_mm", {{0, 0, 0}}}};
  EXPECT_TRUE(planned_path(move_along(spline)).empty());
}

}  // namespace
}  // namespace armature::cosim
