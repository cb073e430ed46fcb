// PathErrorMeter on rows made by hand: every distance is one that a reader can check in his head.
#include "cosim/report/measure/path_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/spline_oracle.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

PositionPath line_path(const Vector3d& start, const Vector3d& end) {
  PositionPath path;
  path.start_mm = start;
  path.end_mm = end;
  path.length_mm = (end - start).norm();
  return path;
}

// Radius 10 about (0, 0, 5), from (10, 0, 5) towards y.
PositionPath arc_path(double angle_rad) {
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
  const PositionPath quarter = arc_path(std::numbers::pi / 2);
  EXPECT_NEAR(distance_mm(quarter, {12 * std::sqrt(0.5), 12 * std::sqrt(0.5), 5}), 2, 1e-12);
  EXPECT_NEAR(distance_mm(quarter, {7 * std::sqrt(0.5), 7 * std::sqrt(0.5), 9}), 5, 1e-12);
  EXPECT_NEAR(distance_mm(quarter, {10, -3, 5}), 3, 1e-12);               // before the start
  EXPECT_NEAR(distance_mm(quarter, {-3, 10, 9}), 5, 1e-12);               // beyond the end
  EXPECT_NEAR(distance_mm(quarter, {-10, 0, 5}), std::sqrt(200), 1e-12);  // on the circle, not on the arc
  EXPECT_NEAR(distance_mm(quarter, {0, 0, 5}), 10, 1e-12);
}

TEST(PathDistance, OfACircleHasNoEnds) {
  const PositionPath circle = arc_path(2 * std::numbers::pi);
  for (const double angle : {0.0, 1e-9, 1.0, 3.0, 5.0, 6.283, -1e-9}) {
    EXPECT_NEAR(distance_mm(circle, {8 * std::cos(angle), 8 * std::sin(angle), 5}), 2, 1e-9) << angle;
  }
}

// `turns` of radius 10 about (0, 0, 5), while it climbs.
PositionPath helix_path(double turns, double advance_mm) {
  PositionPath path = arc_path(turns * 2 * std::numbers::pi);
  path.advance_mm = advance_mm;
  path.end_mm.z() += advance_mm;
  path.length_mm = std::hypot(path.length_mm, advance_mm);
  return path;
}

TEST(PathDistance, OfAHelixIsKnownBesideItAndBeyondItsEnds) {
  const PositionPath helix = helix_path(2, 40);
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

TEST(PathDistance, OfAHelixIsThatToTheNearestOfManyOfItsPoints) {
  armature::test::Random random{161};
  for (int i = 0; i < 60; ++i) {
    const double turns = random.real(0.2, 4), advance = random.real(-60, 60);
    const PositionPath helix = helix_path(turns, advance);
    const Vector3d at{random.real(-16, 16), random.real(-16, 16), 5 + random.real(-0.2, 1.2) * advance};
    constexpr int kPoints = 40'000;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kPoints; ++k) {
      const double share = static_cast<double>(k) / kPoints, phi = share * turns * 2 * std::numbers::pi;
      const Vector3d place{10 * std::cos(phi), 10 * std::sin(phi), 5 + share * advance};
      nearest = std::min(nearest, (place - at).norm());
    }
    EXPECT_NEAR(distance_mm(helix, at), nearest, 1e-4) << i;
  }
}

// The oracle has the coefficients of the curve from a system of equations of its own.
TEST(PathDistance, OfASplineIsThatToTheNearestOfManyOfItsPoints) {
  armature::test::Random random{162};
  const std::vector<Vector3d> points{{0, 0, 0}, {20, 10, 5}, {40, -5, 15}, {50, 20, 10}, {20, 30, 0}};
  const auto spline = Spline::through(points);
  ASSERT_TRUE(spline);
  const PositionPath path = along(*spline);
  const armature::test::SplineOracle oracle{points};
  constexpr int kPlaces = 10'000;  // of each piece
  std::vector<Vector3d> places;
  for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
    for (int k = 0; k <= kPlaces; ++k) {
      places.push_back(oracle.at(piece, oracle.chords[piece] * k / kPlaces).cast<double>());
    }
  }
  for (int i = 0; i < 60; ++i) {
    const Vector3d at{random.real(-5, 60), random.real(-15, 40), random.real(-10, 25)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3d& place : places) nearest = std::min(nearest, (place - at).norm());
    EXPECT_NEAR(distance_mm(path, at), nearest, 1e-4) << i;
  }
}

RobotSpec robot() {
  RobotSpec spec;
  for (AxisSpec& axis : spec.axes) axis.drive.natural_hz = 1000;  // a memory of some 55 ticks
  return spec;
}

struct PathErrorTest : testing::Test {
  // A tick with the tool at these places; the joints move in it when `moves`.
  void tick(const Vector3d& reference, const Vector3d& encoder, bool moves = true) {
    if (moves) row.telemetry.reference[0] += Radians{1e-6};
    row.tool_point = ToolPoint{reference, encoder};
    meter.add(row);
    ++row.tick;
    row.cycle += 2500;
  }
  void rest(const Vector3d& place, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) tick(place, place, false);
  }
  void start(const PositionPath& path, bool continues = false) {
    MoveStarted move;
    move.tag = tag++;
    move.kind = path.shape == PositionPath::Shape::kArc ? MoveKind::kArc : MoveKind::kLine;
    move.path = path;
    move.continues = continues;
    meter.add(move);
  }
  void start_joint_move() { meter.add(MoveStarted{.tag = tag++}); }

  std::uint32_t tag = 0;

  PathErrorMeter meter{robot()};
  std::int64_t memory = memory_ticks(robot());
  TraceRow row;
  PositionPath along_x = line_path({0, 0, 0}, {10, 0, 0});
  PositionPath along_y = line_path({10, 0, 0}, {10, 10, 0});
};

TEST_F(PathErrorTest, MemoryCoversTheDecayOfTheSlowestDrive) {
  // Critically damped: (1 + wn t) exp(-wn t).
  const double wn_t = 2 * std::numbers::pi * 1000 * static_cast<double>(memory) * 50e-6;
  EXPECT_LT((1 + wn_t) * std::exp(-wn_t), 2e-6);
  EXPECT_LT(memory, 65);
  RobotSpec slow = robot();
  slow.axes[2].drive.natural_hz = 100;
  EXPECT_GT(memory_ticks(slow), 9 * memory);
  slow = robot();
  slow.axes[2].drive.damping = 0.1;
  EXPECT_GT(memory_ticks(slow), 9 * memory);
  slow.axes[2].drive.damping = 10;  // slower pole at 0.0501 wn
  EXPECT_GT(memory_ticks(slow), 18 * memory);
  slow.axis_count = 2;
  EXPECT_EQ(memory_ticks(slow), memory);
}

TEST_F(PathErrorTest, NothingIsJudgedWithoutAPath) {
  tick({0, 0, 0}, {5, 5, 5});
  start_joint_move();
  tick({1, 1, 1}, {5, 5, 5});
  EXPECT_FALSE(meter.of_set_points());
  EXPECT_FALSE(meter.of_encoders());
}

TEST_F(PathErrorTest, TheLargestOfEachSideIsKeptWithItsPlace) {
  rest({0, 0, 0}, 5);
  start(along_x);
  tick({1, 0.25, 0}, {0, 0, 0});
  tick({2, 0, 0.5}, {1, 0, 3});
  tick({3, 0, 0.125}, {2, 1, 0});
  ASSERT_TRUE(meter.of_set_points());
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 0.5);
  EXPECT_EQ(meter.of_set_points()->where.tick, 6);
  EXPECT_EQ(meter.of_set_points()->where.at, Cycles{6 * 2500});
  EXPECT_EQ(meter.of_set_points()->move, 0u);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
  EXPECT_EQ(meter.of_encoders()->where.tick, 6);
}

TEST_F(PathErrorTest, OfASplineIsThatFromTheCurveThroughItsPoints) {
  // Points on a straight line, so that the curve is the line.
  MoveStarted move;
  move.tag = tag++;
  move.kind = MoveKind::kSpline;
  move.path.shape = PositionPath::Shape::kSpline;
  move.path.start_mm = {0, 0, 0};
  move.path.end_mm = {30, 0, 0};
  move.path.length_mm = 30;
  move.through.count = 2;
  move.through.mm[0] = {10, 0, 0};
  move.through.mm[1] = {15, 0, 0};
  meter.add(move);
  tick({12, 0.25, 0}, {11, 0, 3});
  EXPECT_NEAR(meter.of_set_points()->mm, 0.25, 1e-9);
  EXPECT_NEAR(meter.of_encoders()->mm, 3, 1e-9);
}

TEST_F(PathErrorTest, LaggingBehindOnThePathIsNoError) {
  start(along_x);
  tick({8, 0, 0}, {2, 0, 0});
  EXPECT_EQ(meter.of_encoders()->mm, 0);
}

TEST_F(PathErrorTest, TheNearestPathOfABlendedChainCounts) {
  start(along_x);
  tick({9, 0, 0}, {8, 0, 0});
  start(along_y, true);
  tick({9.75, 0.5, 0}, {9.5, 0.125, 0});
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 0.25);  // to the second
  EXPECT_EQ(meter.of_set_points()->move, 1u);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 0.125);  // to the first
  EXPECT_EQ(meter.of_encoders()->move, 0u);
}

TEST_F(PathErrorTest, APathThatHasNotBegunDoesNotCount) {
  start(along_x);
  tick({10, 5, 0}, {10, 0, 0});
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 5);
}

TEST_F(PathErrorTest, EncodersMayStillBeOnTheMoveBefore) {
  start(along_x);
  tick({10, 0, 0}, {8, 0, 0});
  start(along_y);  // after an exact stop
  tick({10, 1, 0}, {9, 0, 0});
  EXPECT_EQ(meter.of_encoders()->mm, 0);
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  tick({9, 0, 0}, {10, 0, 0});  // but set-points may not
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 1);
  for (std::int64_t i = 0; i < memory; ++i) tick({10, 2, 0}, {10, 1, 0});
  tick({10, 3, 0}, {7, 0, 0});  // forgotten by the drives
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
}

TEST_F(PathErrorTest, EncodersCountWhileTheyFollowAfterTheEnd) {
  start(along_x);
  tick({10, 0, 0}, {9, 0, 0});
  tick({10, 0, 0}, {10, 0, 0.5}, false);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 0.5);
}

TEST_F(PathErrorTest, EncodersDoNotCountUntilTheyHaveForgottenAJointMove) {
  rest({0, -5, 0}, 1);
  start_joint_move();
  tick({0, 0, 0}, {0, -5, 0});
  start(along_x);
  for (std::int64_t i = 0; i < memory; ++i) tick({1, 0, 0}, {0, -4, 0});
  EXPECT_FALSE(meter.of_encoders());
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  tick({2, 0, 0}, {1, -3, 0});
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
}

TEST_F(PathErrorTest, AJointMoveAndAFaultEndThePath) {
  start(along_x);
  tick({1, 0, 0}, {1, 0, 0});
  start_joint_move();
  tick({5, 5, 5}, {5, 5, 5});
  start(along_x);
  rest({1, 0, 0}, 2 * memory);
  row.telemetry.state = MotionState::kFault;
  tick({5, 5, 5}, {5, 5, 5});
  row.telemetry.state = MotionState::kIdle;
  rest({5, 5, 5}, 2 * memory);
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  EXPECT_EQ(meter.of_encoders()->mm, 0);
}

TEST_F(PathErrorTest, RowsWithoutAToolPointAreNotJudged) {
  start(along_x);
  meter.add(row);
  EXPECT_FALSE(meter.of_set_points());
  EXPECT_FALSE(meter.of_encoders());
}

}  // namespace
}  // namespace armature::cosim
