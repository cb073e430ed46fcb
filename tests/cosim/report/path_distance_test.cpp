// The distance of a point from each kind of path.
#include "cosim/report/measure/path_distance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/spline_oracle.hpp"
#include "tests/cosim/support/position_paths.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;
using test::line_path;

// Radius 10 about (0, 0, 5), from (10, 0, 5) towards y.
PositionPath level_arc(double angle_rad) {
  PositionPath path;
  path.shape = PositionPath::Shape::kArc;
  path.center_mm = {0, 0, 5};
  path.radius_mm = 10;
  path.angle_rad = angle_rad;
  path.start_mm = {10, 0, 5};
  path.end_mm = {10 * std::cos(angle_rad), 10 * std::sin(angle_rad), 5};
  path.length_mm = 10 * angle_rad;
  return path;
}

TEST(PathDistance, OfALineIsToItsNearestPointAndNotBeyondItsEnds) {
  const PositionPath path = line_path({0, 0, 0}, {10, 0, 0});
  EXPECT_DOUBLE_EQ(distance_mm(path, {4, 3, 0}), 3);
  EXPECT_DOUBLE_EQ(distance_mm(path, {4, 3, 4}), 5);
  EXPECT_DOUBLE_EQ(distance_mm(path, {13, 4, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_mm(path, {-3, 0, 4}), 5);
  EXPECT_EQ(distance_mm(path, {7, 0, 0}), 0);
}

TEST(PathDistance, OfAPointIsTheDistanceToIt) {
  EXPECT_DOUBLE_EQ(distance_mm(line_path({1, 1, 1}, {1, 1, 1}), {1, 4, 5}), 5);
}

TEST(PathDistance, OfAnArcEndsWhereTheArcEnds) {
  const PositionPath quarter = level_arc(std::numbers::pi / 2);
  EXPECT_NEAR(distance_mm(quarter, {12 * std::sqrt(0.5), 12 * std::sqrt(0.5), 5}), 2, 1e-12);
  EXPECT_NEAR(distance_mm(quarter, {7 * std::sqrt(0.5), 7 * std::sqrt(0.5), 9}), 5, 1e-12);
  EXPECT_NEAR(distance_mm(quarter, {10, -3, 5}), 3, 1e-12);               // before the start
  EXPECT_NEAR(distance_mm(quarter, {-3, 10, 9}), 5, 1e-12);               // beyond the end
  EXPECT_NEAR(distance_mm(quarter, {-10, 0, 5}), std::sqrt(200), 1e-12);  // on the circle, not on the arc
  EXPECT_NEAR(distance_mm(quarter, {0, 0, 5}), 10, 1e-12);
}

TEST(PathDistance, OfACircleHasNoEnds) {
  const PositionPath circle = level_arc(2 * std::numbers::pi);
  for (const double angle : {0.0, 1e-9, 1.0, 3.0, 5.0, 6.283, -1e-9}) {
    EXPECT_NEAR(distance_mm(circle, {8 * std::cos(angle), 8 * std::sin(angle), 5}), 2, 1e-9) << angle;
  }
}

// `turns` of radius 10 about (0, 0, 5), while it climbs.
PositionPath climbing(double turns, double advance_mm) {
  PositionPath path = level_arc(turns * 2 * std::numbers::pi);
  path.advance_mm = advance_mm;
  path.end_mm.z() += advance_mm;
  path.length_mm = std::hypot(path.length_mm, advance_mm);
  return path;
}

TEST(PathDistance, OfAHelixIsKnownBesideItAndBeyondItsEnds) {
  const PositionPath helix = climbing(2, 40);
  for (const double turn : {0.0, 0.3, 1.0, 1.7, 2.0}) {
    const double phi = turn * 2 * std::numbers::pi;
    const Vector3d outward{std::cos(phi), std::sin(phi), 0};
    const Vector3d on_helix = 10 * outward + Vector3d{0, 0, 5 + 20 * turn};
    EXPECT_NEAR(distance_mm(helix, on_helix), 0, 1e-8) << turn;
    EXPECT_NEAR(distance_mm(helix, on_helix + 0.5 * outward), 0.5, 1e-9) << turn;
    EXPECT_NEAR(distance_mm(helix, on_helix - 2 * outward), 2, 1e-9) << turn;
  }
  const Vector3d tangent = Vector3d{0, 10, 10 / std::numbers::pi}.normalized();
  EXPECT_NEAR(distance_mm(helix, helix.start_mm - 3 * tangent), 3, 1e-9);
  EXPECT_NEAR(distance_mm(helix, helix.end_mm + 3 * tangent), 3, 1e-9);
}

// The least value of a function from 0 to 1, which has one minimum at most between two samples.
template <class Of>
double least_of(Of of) {
  constexpr int kSamples = 800;
  constexpr double kApart = 1.0 / kSamples;
  double least = std::min(of(0.0), of(1.0));
  double before = of(0.0), here = of(kApart);
  for (int k = 1; k < kSamples; ++k) {
    const double after = of((k + 1) * kApart);
    if (here <= before && here <= after) {
      double from = (k - 1) * kApart, to = (k + 1) * kApart;
      for (int i = 0; i < 60; ++i) {
        const double third = (to - from) / 3;
        if (of(from + third) < of(to - third)) {
          to -= third;
        } else {
          from += third;
        }
      }
      least = std::min(least, of(from));
    }
    before = here;
    here = after;
  }
  return least;
}

// Steep and flat ones, down to turns that nearly touch; points beside, on the axis, and beyond the ends.
TEST(PathDistance, OfAHelixIsTheLeastOfItsPoints) {
  armature::test::Random random{161};
  for (int i = 0; i < 300; ++i) {
    const double turns = random.real(0.1, 4), advance = random.real(-1, 1) * std::pow(10, random.real(-3, 3));
    const PositionPath helix = climbing(turns, advance);
    const double wide = i % 5 == 0 ? 1e-6 : 16;
    const double height = i % 3 == 0 ? random.real(-100, 100) : random.real(-0.2, 1.2) * advance;
    const Vector3d at{random.real(-wide, wide), random.real(-wide, wide), 5 + height};
    const double least = least_of([&](double share) {
      const double phi = share * turns * 2 * std::numbers::pi;
      return (Vector3d{10 * std::cos(phi), 10 * std::sin(phi), 5 + share * advance} - at).norm();
    });
    ASSERT_NEAR(distance_mm(helix, at), least, 1e-9) << i;
  }
}

TEST(PathDistance, OfAHelixIsFiniteWhereItsAxisOrItsTurnsDegenerate) {
  const PositionPath flat = climbing(2, 1e-300);
  EXPECT_NEAR(distance_mm(flat, {13, 0, 5}), 3, 1e-12);
  EXPECT_NEAR(distance_mm(flat, {0, 0, 9}), std::hypot(10, 4), 1e-12);
  EXPECT_NEAR(distance_mm(climbing(2, 40), {0, 0, 25}), 10, 1e-12);  // every direction is as near
}

// A helix whose turns are closer together than any samples of it.
TEST(PathDistance, OfAHelixDoesNotJumpToTheNextTurn) {
  armature::test::Random random{163};
  constexpr double kTurns = 1.45, kAdvance_mm = 0.4;
  const PositionPath helix = climbing(kTurns, kAdvance_mm);
  for (int i = 0; i < 1000; ++i) {
    const double share = random.real(0, 1), phi = share * kTurns * 2 * std::numbers::pi;
    const Vector3d on_helix{10 * std::cos(phi), 10 * std::sin(phi), 5 + share * kAdvance_mm};
    ASSERT_LT(distance_mm(helix, on_helix), 2e-10) << share;
  }
}

// The ball of a path has all of its points, so no point of the path is nearer to a place than the ball is.
void expect_in_ball(const PositionPath& path, const Vector3d& point) {
  const Ball ball = ball_around(path);
  EXPECT_LE((point - ball.center_mm).norm(), ball.radius_mm * (1 + 1e-12));
  const Vector3d outside = ball.center_mm + Vector3d{0, ball.radius_mm + 5, 0};
  EXPECT_FALSE(ball.is_farther(outside, distance_mm(path, outside)));
  EXPECT_FALSE(ball.is_farther(outside, 5));
  EXPECT_TRUE(ball.is_farther(outside, 4.99));
}

TEST(PathDistance, OfABallIsNotMoreThanThatOfThePathInIt) {
  armature::test::Random random{173};
  const auto anywhere = [&]() -> Vector3d { return {random.real(-9, 9), random.real(-9, 9), random.real(-9, 9)}; };
  for (int i = 0; i < 100; ++i) {
    const double share = random.real(0, 1), advance = random.real(-60, 60), turns = random.real(0.1, 3);
    const PositionPath straight = line_path(anywhere(), anywhere());
    expect_in_ball(straight, straight.start_mm + share * (straight.end_mm - straight.start_mm));
    const double phi = share * turns * 2 * std::numbers::pi;
    expect_in_ball(climbing(turns, advance), {10 * std::cos(phi), 10 * std::sin(phi), 5 + share * advance});
    const auto spline = Spline::through(std::vector<Vector3d>{anywhere(), anywhere(), anywhere(), anywhere()});
    if (!spline) continue;
    PositionPath curve = line_path(spline->points_mm().front(), spline->points_mm().back());
    curve.shape = PositionPath::Shape::kSpline;
    curve.spline = &*spline;
    const std::array<Vector3d, 4> c = spline->cubic_mm(static_cast<std::size_t>(i) % 3);
    expect_in_ball(curve, c[0] + share * (c[1] + share * (c[2] + share * c[3])));
  }
}

// The distance to the nearest of many points of a curve, and of more where these are near: not less than the distance
// to the curve, and more by half of their spacing at most. The oracle has the coefficients from equations of its own.
class ManyPoints {
 public:
  explicit ManyPoints(const std::vector<Vector3d>& points) : oracle_{points} {
    for (std::size_t piece = 0; piece < oracle_.chords.size(); ++piece) {
      for (int k = 0; k <= kPlaces; ++k) places_.push_back(at(piece, k));
      for (std::size_t i = places_.size() - kPlaces; i < places_.size(); ++i) {
        spacing_ = std::max(spacing_, (places_[i] - places_[i - 1]).norm());
      }
    }
  }

  // Of a piece, at 0..kPlaces.
  [[nodiscard]] Vector3d at(std::size_t piece, double place) const {
    return oracle_.at(piece, oracle_.chords[piece] * static_cast<long double>(place) / kPlaces).cast<double>();
  }
  [[nodiscard]] Vector3d across(std::size_t piece, double place) const {
    const Vector3d along = oracle_.at(piece, oracle_.chords[piece] * place / kPlaces, 1).cast<double>();
    return along.unitOrthogonal();
  }

  [[nodiscard]] double distance(const Vector3d& point) const {
    double least = std::numeric_limits<double>::max();
    for (const Vector3d& place : places_) least = std::min(least, (place - point).norm());
    double finest = least;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if ((places_[i] - point).norm() > least + spacing_) continue;
      const auto piece = i / (kPlaces + 1), k = i % (kPlaces + 1);
      for (int j = -kFiner; j <= kFiner; ++j) {
        const double place = static_cast<double>(k) + static_cast<double>(j) / kFiner;
        if (place >= 0 && place <= kPlaces) finest = std::min(finest, (at(piece, place) - point).norm());
      }
    }
    return finest;
  }

  [[nodiscard]] double largest_error() const { return 0.5 * spacing_ / kFiner; }

  static constexpr int kPlaces = 200;  // of each piece

 private:
  static constexpr int kFiner = 50;  // parts of the way to the next place

  armature::test::SplineOracle oracle_;
  std::vector<Vector3d> places_;
  double spacing_ = 0;
};

// Points of an arm's work: some far apart, some close together, with sharp bends between them.
std::vector<Vector3d> random_points(armature::test::Random& random) {
  std::vector<Vector3d> points(static_cast<std::size_t>(random.integer(3, 9)));
  const double scale = std::exp(random.real(std::log(5.0), std::log(400.0)));
  for (Vector3d& point : points) {
    const double size = random.integer(0, 3) == 0 ? 0.05 * scale : scale;
    point = (&point == &points.front() ? Vector3d{300, 0, 300} : (&point)[-1]) +
            size * Vector3d{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  }
  return points;
}

TEST(PathDistance, OfASplineIsThatToTheNearestOfManyOfItsPoints) {
  constexpr std::uint64_t kSeed = 162;
  armature::test::Random random{kSeed};
  for (int i = 0; i < 100;) {
    const std::vector<Vector3d> points = random_points(random);
    const auto spline = Spline::through(points);
    if (!spline) continue;
    SCOPED_TRACE(testing::Message() << "spline " << i++ << ", seed " << kSeed);
    const PositionPath path = along(*spline);
    const ManyPoints oracle{points};
    for (int k = 0; k < 60; ++k) {
      const auto piece = static_cast<std::size_t>(random.integer(0, std::ssize(points) - 2));
      ASSERT_LT(distance_mm(path, oracle.at(piece, random.real(0, ManyPoints::kPlaces))), 2e-10);
    }
    for (int k = 0; k < 3; ++k) {
      const auto piece = static_cast<std::size_t>(random.integer(0, std::ssize(points) - 2));
      const double place = random.real(0, ManyPoints::kPlaces);
      const double off = std::exp(random.real(std::log(1e-3), std::log(30.0)));
      const Vector3d beside = oracle.at(piece, place) + off * oracle.across(piece, place);
      const double most = oracle.distance(beside), measured = distance_mm(path, beside);
      ASSERT_LE(measured, most * (1 + 1e-6) + 1e-9);
      ASSERT_GE(measured, most - oracle.largest_error() - 1e-9);
    }
  }
}

}  // namespace
}  // namespace armature::cosim
