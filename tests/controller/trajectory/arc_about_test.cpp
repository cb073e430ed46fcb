// Arcs, circles and helices about an axis: their geometry against an oracle in long double, and their motion.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "controller/trajectory/path/position_path.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using Wide = Eigen::Matrix<long double, 3, 1>;
using test::kReady;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

// Rodrigues' formula about the axis, from the definition of the motion.
Wide point_about(const Vector3d& start, const Vector3d& center, const Vector3d& axis, long double angle,
                 long double advance) {
  const Wide n = axis.cast<long double>().normalized(), d = (start - center).cast<long double>();
  const Wide turned = d * std::cos(angle) + n.cross(d) * std::sin(angle) + n * n.dot(d) * (1 - std::cos(angle));
  return center.cast<long double>() + turned + n * advance;
}

Vector3d random_vector(test::Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

TEST(ArcAbout, AgreesWithRotationAboutTheAxisInLongDouble) {
  test::Random random{141};
  for (int i = 0; i < 2000; ++i) {
    const Vector3d start = random_vector(random, 500), center = random_vector(random, 500);
    const Vector3d axis = random_vector(random, i % 2 == 0 ? 1 : 1e6);
    const double angle = random.real(-1, 1) * (i % 3 == 0 ? 60.0 : 6.0),
                 advance = i % 4 == 0 ? 0 : random.real(-80, 80);
    const auto path = arc_about(start, center, axis, angle, advance);
    ASSERT_TRUE(path);
    const long double around = (start - center).cast<long double>().cross(axis.cast<long double>().normalized()).norm();
    ASSERT_NEAR(path->length_mm, static_cast<double>(std::hypot(around * angle, static_cast<long double>(advance))),
                1e-12 * path->length_mm);
    for (const double s : {0.0, 1e-9, 0.1, 0.37, 0.5, 0.999, 1.0}) {
      const Wide expected =
          point_about(start, center, axis, static_cast<long double>(s) * angle, static_cast<long double>(s) * advance);
      ASSERT_LT((point(*path, s).cast<long double>() - expected).norm(), 3e-12L * 1000) << i << " at " << s;
    }
    ASSERT_EQ(point(*path, 0.0), start);
    ASSERT_EQ(point(*path, 1.0), path->end_mm);
  }
}

TEST(ArcAbout, TheTangentIsThatOfTheCurve) {
  test::Random random{142};
  for (int i = 0; i < 500; ++i) {
    const Vector3d start = random_vector(random, 100), center = random_vector(random, 100);
    const Vector3d axis = random_vector(random, 1);
    const double angle = random.real(0.2, 20), advance = random.real(-300, 300);
    const auto path = arc_about(start, center, axis, angle, advance);
    ASSERT_TRUE(path);
    const double s = random.real(0.1, 0.9);
    // Differences of the oracle, whose errors are far below those of the functions.
    const long double h = 1e-5L;
    const auto at = [&](long double share) { return point_about(start, center, axis, share * angle, share * advance); };
    const Wide first = (at(s + h) - at(s - h)) / (2 * h);
    const long double length = path->length_mm;
    ASSERT_LT((tangent(*path, s).cast<long double>() - first / length).norm(), 1e-7L);
    ASSERT_NEAR(tangent(*path, s).norm(), 1.0, 1e-14);
  }
}

TEST(ArcAbout, WholeTurnsWithoutAdvanceEndExactlyAtTheStart) {
  const Vector3d start{123.456, -7.89, 1.1}, center{100, 3, 50}, axis{0.1, -0.3, 0.9};
  for (const double turns : {1.0, -1.0, 2.0, 7.0, 100.0}) {
    const auto path = arc_about(start, center, axis, turns * kTurn_rad, 0.0);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->end_mm, start) << turns;
  }
  EXPECT_NE(arc_about(start, center, axis, 1.001 * kTurn_rad, 0.0)->end_mm, start);
}

TEST(ArcAbout, RefusesWhatIsNoCircle) {
  const Vector3d start{10, 0, 5}, center{0, 0, 0}, axis{0, 0, 1};
  EXPECT_TRUE(arc_about(start, center, axis, 1.0, 0.0));
  EXPECT_FALSE(arc_about(start, center, axis, 0.0, 0.0));
  EXPECT_FALSE(arc_about(start, center, Vector3d::Zero(), 1.0, 0.0));
  EXPECT_FALSE(arc_about({0, 0, 5}, center, axis, 1.0, 20.0));  // on the axis
  EXPECT_FALSE(arc_about(center, center, axis, 1.0, 0.0));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    EXPECT_FALSE(arc_about({bad, 0, 5}, center, axis, 1.0, 0.0));
    EXPECT_FALSE(arc_about(start, {0, bad, 0}, axis, 1.0, 0.0));
    EXPECT_FALSE(arc_about(start, center, {0, 0, bad}, 1.0, 0.0));
    EXPECT_FALSE(arc_about(start, center, axis, bad, 0.0));
    EXPECT_FALSE(arc_about(start, center, axis, 1.0, bad));
  }
}

SegmentRequest around(const Vector3d& center, const Vector3d& axis, double turns, double advance_mm,
                      const Transform& target, const PathLimits& limits) {
  SegmentRequest request = test::line_to(target, limits);
  request.kind = SegmentRequest::Kind::kArcAbout;
  request.via_mm = center;
  request.about = {.axis = axis, .angle_rad = turns * kTurn_rad, .advance_mm = advance_mm};
  return request;
}

TEST(ArcAbout, AHelixRunsAtItsSpeedWithinTheLimitsOfJointsAndTool) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const PathLimits limits{.speed_mm_s = 100,
                          .accel_mm_s2 = 2'000,
                          .jerk_mm_s3 = 1,
                          .turn_speed_rad_s = 2,
                          .turn_accel_rad_s2 = 20,
                          .turn_jerk_rad_s3 = 1};
  for (const double turns : {0.25, 1.0, 4.5, -10.0}) {
    SCOPED_TRACE(turns);
    const Vector3d center = start.position_mm + Vector3d{20, 0, 0};
    ASSERT_EQ(rig.plan(kReady, around(center, {0.1, 0, 1}, turns, 30.0, start, limits)), Progress::kDone);
    const CartesianPlan& plan = rig.planner.plan();
    EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
    EXPECT_LE(test::tool_peaks(plan, limits).most(), 1.0 + 2e-3);
    // The time of a trapezoid over the length. The acceleration along the path is what the curve leaves.
    const PositionPath& path = plan.segments[0].path;
    const double pitch_mm = path.advance_mm / path.angle_rad;
    const double across = 100.0 * 100.0 / (path.radius_mm + pitch_mm * pitch_mm / path.radius_mm);
    const double along = std::sqrt(limits.accel_mm_s2 * limits.accel_mm_s2 - across * across);
    const double longest_s = path.length_mm / 100.0 + 100.0 / along;
    EXPECT_LE(seconds(plan.duration), 1.002 * longest_s);
    const Vector3d end = tool_pose(plan, seconds(plan.duration)).position_mm;
    const Wide expected = point_about(start.position_mm, center, {0.1, 0, 1}, turns * kTurn_rad, 30.0);
    EXPECT_LT((end.cast<long double>() - expected).norm(), 1e-10L);
  }
}

TEST(ArcAbout, AFastHelixIsSlowedDownForTheJointsOnEveryTurn) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 3'000;
  limits.accel_mm_s2 = 100'000;
  const Vector3d center = start.position_mm + Vector3d{60, 0, 0};
  ASSERT_EQ(rig.plan(kReady, around(center, {0, 0, 1}, 20.0, -60.0, start, limits)), Progress::kDone);
  const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points());
  EXPECT_LE(peaks.most(false), 1.0);
  EXPECT_GT(peaks.accel, 0.9);
  EXPECT_GT(rig.planner.plan().segments[0].stretch, 1.5);
}

TEST(ArcAbout, AnAxisThroughTheStartIsNoCircle) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  ASSERT_EQ(rig.plan(kReady, around(start.position_mm, {0, 0, 1}, 1.0, 10.0, start, test::kGentle)),
            Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kNoCircle);
}

}  // namespace
}  // namespace armature
