// The geometry of splines against an oracle in long double.
#include "controller/trajectory/path/spline.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/spline_oracle.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using Oracle = test::SplineOracle;
using Wide = Oracle::Wide;

// Points of a walk that changes its direction by up to `bend` rad between steps of 5 to 60 mm.
std::vector<Vector3d> walk(test::Random& random, std::size_t count, double bend) {
  std::vector<Vector3d> points{{300, 20, 400}};
  Vector3d way = Vector3d{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}.normalized();
  while (points.size() < count) {
    const Vector3d axis = Vector3d{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}.normalized();
    way = Eigen::AngleAxisd{random.real(0, bend), axis} * way;
    points.push_back(points.back() + random.real(5, 60) * way);
  }
  return points;
}

TEST(Spline, IsTheNaturalCubicSplineByItsLength) {
  test::Random random{151};
  double worst_speed = 0.0, sharpest_speed = 0.0;
  for (int i = 0; i < 60; ++i) {
    const bool sharp = i % 3 == 2;
    const std::vector<Vector3d> points = walk(random, 2 + static_cast<std::size_t>(i % 16), sharp ? 2.0 : 0.7);
    const auto spline = Spline::through(points);
    ASSERT_TRUE(spline) << i;
    const Oracle oracle{points};
    long double length = 0;
    for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
      ASSERT_NEAR(spline->length_to_mm(piece), static_cast<double>(length), 1e-6 * spline->length_mm());
      ASSERT_LT((spline->position_mm(spline->length_to_mm(piece)) - points[piece]).norm(), 1e-12);
      length += oracle.length(piece, 0, oracle.chords[piece]);
    }
    ASSERT_NEAR(spline->length_mm(), static_cast<double>(length), 1e-6 * spline->length_mm());
    ASSERT_LT((spline->position_mm(spline->length_mm()) - points.back()).norm(), 1e-12);
    for (int k = 0; k < 15; ++k) {
      const double s = random.real(0, 1) * spline->length_mm();
      const Spline::Place place = spline->at(s);
      ASSERT_EQ(place.position_mm, spline->position_mm(s));
      ASSERT_LT(oracle.distance(place.position_mm), 1e-11L);  // on the curve
      const double h = 1e-4 * spline->length_mm();
      if (s < h || s > spline->length_mm() - h) continue;
      const double speed = (spline->position_mm(s + h / 2) - spline->position_mm(s - h / 2)).norm() / h;
      double& worst = sharp ? sharpest_speed : worst_speed;
      worst = std::max(worst, std::fabs(speed - 1.0));
      ASSERT_NEAR(place.tangent.norm(), 1.0, 1e-14);
      ASSERT_NEAR(place.tangent.dot(place.bend), 0.0, 1e-13);
    }
  }
  EXPECT_LT(worst_speed, 1e-5);
  EXPECT_LT(sharpest_speed, 1e-2);
}

// Of the curve by its length, from differences of its curvature in long double.
TEST(Spline, TheThirdDerivativeIsThatOfTheCurve) {
  test::Random random{154};
  for (int i = 0; i < 40; ++i) {
    const std::vector<Vector3d> points = walk(random, 3 + static_cast<std::size_t>(i % 15), 0.7);
    const auto spline = Spline::through(points);
    ASSERT_TRUE(spline);
    const Oracle oracle{points};
    const auto bend_at = [&](std::size_t piece, long double u) -> Wide {
      const Wide slope = oracle.at(piece, u, 1), bend = oracle.at(piece, u, 2);
      return (bend - slope * (slope.dot(bend) / slope.squaredNorm())) / slope.squaredNorm();
    };
    for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
      const long double u = oracle.chords[piece] * static_cast<long double>(random.real(0.01, 0.99));
      const long double h = 1e-5L * oracle.chords[piece];
      const Wide expected = (bend_at(piece, u + h) - bend_at(piece, u - h)) / oracle.length(piece, u - h, u + h);
      const double mm = spline->length_to_mm(piece) + static_cast<double>(oracle.length(piece, 0.0L, u));
      const Wide off = spline->at(mm).jolt.cast<long double>() - expected;
      EXPECT_LT(off.norm(), 1e-3L * expected.norm() + 1e-9L) << i << " piece " << piece;
    }
  }
}

TEST(Spline, DerivativesAreContinuousAndThoseOfTheCurve) {
  test::Random random{152};
  for (int i = 0; i < 60; ++i) {
    const std::vector<Vector3d> points = walk(random, 3 + static_cast<std::size_t>(i % 15), 1.0);
    const auto spline = Spline::through(points);
    ASSERT_TRUE(spline);
    const Oracle oracle{points};
    for (std::size_t piece = 1; piece + 1 < points.size(); ++piece) {
      const double s = spline->length_to_mm(piece), tiny = 1e-9;
      const Spline::Place before = spline->at(s - tiny), here = spline->at(s), after = spline->at(s + tiny);
      ASSERT_LT((after.tangent - before.tangent).norm(), 1e-8);
      ASSERT_LT((after.bend - before.bend).norm(), 1e-7);
      const Wide slope = oracle.at(piece, 0, 1), bend = oracle.at(piece, 0, 2);
      const Wide across = (bend - slope * (slope.dot(bend) / slope.squaredNorm())) / slope.squaredNorm();
      ASSERT_LT((here.tangent.cast<long double>() - slope.normalized()).norm(), 1e-13L);
      ASSERT_LT((here.bend.cast<long double>() - across).norm(), 1e-12L);
    }
    ASSERT_LT(spline->at(0.0).bend.norm(), 1e-15);
    ASSERT_LT(spline->at(spline->length_mm()).bend.norm(), 1e-12);
  }
}

TEST(Spline, ItsCubicsAreTheCurveBetweenItsPoints) {
  test::Random random{155};
  for (int i = 0; i < 40; ++i) {
    const std::vector<Vector3d> points = walk(random, 2 + static_cast<std::size_t>(i % 16), 1.0);
    const auto spline = Spline::through(points);
    ASSERT_TRUE(spline);
    const Oracle oracle{points};
    for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
      const auto c = spline->cubic_mm(piece);
      for (const double u : {0.0, 0.3, 0.8, 1.0}) {
        const Vector3d place = c[0] + u * (c[1] + u * (c[2] + u * c[3]));
        const Wide expected = oracle.at(piece, static_cast<long double>(u) * oracle.chords[piece]);
        EXPECT_LT((place.cast<long double>() - expected).norm(), 1e-11L) << i << " piece " << piece << " at " << u;
      }
    }
  }
}

TEST(Spline, PointsOnALineGiveTheLineAndPointsOnACircleAlmostTheCircle) {
  const std::vector<Vector3d> line{{0, 0, 0}, {10, 0, 0}, {11, 0, 0}, {50, 0, 0}};
  const auto straight = Spline::through(line);
  ASSERT_TRUE(straight);
  EXPECT_NEAR(straight->length_mm(), 50.0, 1e-12);
  for (double s = 0; s <= 50; s += 0.5) EXPECT_LT((straight->position_mm(s) - Vector3d{s, 0, 0}).norm(), 1e-12);

  std::vector<Vector3d> circle;
  for (int i = 0; i <= 16; ++i) circle.push_back({50 * std::cos(0.3 * i), 50 * std::sin(0.3 * i), 0});
  const auto round = Spline::through(circle);
  ASSERT_TRUE(round);
  const double middle = round->length_to_mm(8);
  EXPECT_NEAR(round->position_mm(middle + 7).norm(), 50.0, 0.01);
  EXPECT_NEAR(1.0 / round->at(middle + 3).bend.norm(), 50.0, 0.5);
}

TEST(Spline, RefusesPointsThatAreNoCurve) {
  const std::vector<Vector3d> good{{0, 0, 0}, {10, 0, 0}, {20, 5, 0}};
  EXPECT_TRUE(Spline::through(good));
  EXPECT_FALSE(Spline::through({}));
  EXPECT_FALSE(Spline::through(std::span{good}.first(1)));
  EXPECT_FALSE(Spline::through(std::vector<Vector3d>(Spline::kMaxPoints + 1, Vector3d::Zero())));
  EXPECT_FALSE(Spline::through(std::vector<Vector3d>{{0, 0, 0}, {10, 0, 0}, {10, 0, 0}, {20, 0, 0}}));
  EXPECT_FALSE(Spline::through(std::vector<Vector3d>{{0, 0, 0}, {10, 0, 0}, {0, 0, 0}}));  // turns back
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    EXPECT_FALSE(Spline::through(std::vector<Vector3d>{{0, 0, 0}, {10, bad, 0}, {20, 5, 0}}));
  }
}

TEST(Spline, CopiesItsPoints) {
  const std::vector<Vector3d> points{{0, 0, 0}, {10, 0, 0}, {20, 5, 0}, {20, 30, 0}};
  const auto spline = Spline::through(points);
  ASSERT_TRUE(spline);
  const auto copy = std::make_unique<Spline>(*spline);
  EXPECT_TRUE(std::ranges::equal(copy->points_mm(), points));
  for (double s = 0; s < spline->length_mm(); s += 1.0) EXPECT_EQ(copy->position_mm(s), spline->position_mm(s));
}

}  // namespace
}  // namespace armature
