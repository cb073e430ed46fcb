// The motion along splines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/trajectory/cartesian/path_corners.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/spline_oracle.hpp"
#include "tests/controller/support/spline_request.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using test::kReady;
using test::moved;
using test::PathRig;
using test::spline_to;
using Progress = CartesianPlanner::Progress;

const int kRandomSplines = test::draws(6);

TEST(SplineMotion, RunsAtItsSpeedThroughItsPointsWithinAllLimits) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const Vector3d p = start.position_mm;
  const std::vector<Vector3d> through{p + Vector3d{20, 20, 5}, p + Vector3d{45, -5, 20}, p + Vector3d{70, 25, 20},
                                      p + Vector3d{90, 40, 0}};
  const Transform end = test::turned_by(moved(start, 60, 80, 10), 0.4, {0, 1, 1});
  for (const double speed : {20.0, 100.0, 400.0}) {
    SCOPED_TRACE(speed);
    PathLimits limits = test::kBrisk;
    limits.speed_mm_s = speed;
    limits.accel_mm_s2 = 3'000.0;
    ASSERT_EQ(rig.plan(kReady, spline_to(through, end, limits)), Progress::kDone);
    const CartesianPlan& plan = rig.planner.plan();
    EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
    const test::ToolPeaks peaks = test::tool_peaks(plan, limits);
    EXPECT_LE(peaks.most(), 1.0 + 2e-3);
    EXPECT_GE(peaks.speed, speed < 200.0 ? 0.99 : 0.5);
    const PositionPath& path = plan.segments[0].path;
    if (speed == 20.0) {
      EXPECT_LE(seconds(plan.duration), 1.006 * (path.length_mm / speed + speed / limits.accel_mm_s2));
    }
    // Every point is passed: between two set-points that are a step apart.
    std::vector<double> nearest(through.size(), 1e9);
    for (std::int64_t tick = 0; tick <= plan.duration.value(); ++tick) {
      const Vector3d tool = tool_pose(plan, seconds(Ticks{tick})).position_mm;
      for (std::size_t i = 0; i < through.size(); ++i) {
        nearest[i] = std::min(nearest[i], (tool - through[i]).norm());
      }
    }
    for (const double mm : nearest) EXPECT_LE(mm, 0.51 * speed * kTickSeconds);
    EXPECT_LT((tool_pose(plan, seconds(plan.duration)).position_mm - end.position_mm).norm(), 1e-12);
    EXPECT_LT((tool_pose(plan, seconds(plan.duration)).rotation - end.rotation).norm(), 1e-12);
  }
}

TEST(SplineMotion, JoinsALineInItsDirectionWithoutAStop) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const Transform corner = moved(start, 0, 40, 0);
  // Natural splines leave their ends almost in the direction of the first chords; this one is straight there.
  const std::vector<Vector3d> through{moved(corner, 0, 10, 0).position_mm, moved(corner, 0, 20, 0).position_mm};
  const std::vector<SegmentRequest> chain{test::line_to(corner, test::kGentle, 0.5),
                                          spline_to(through, moved(corner, 0, 40, 0), test::kGentle)};
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  EXPECT_EQ(joint_after(rig.planner.plan(), 0), PathJoint::kSmooth);
}

TEST(SplineMotion, CornersBesideItAreRoundedWithinTheirTolerance) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const Transform a = moved(start, 0, 30, 0), b = moved(a, 70, 25, 20), c = moved(b, 0, -40, 0);
  const Vector3d p = a.position_mm;
  const std::vector<Vector3d> through{p + Vector3d{20, 20, 5}, p + Vector3d{45, -5, 20}};
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 200.0;
  SegmentRequest spline = spline_to(through, b, limits);
  spline.blend_mm = 2.0;
  ASSERT_EQ(rig.plan(kReady, std::vector{test::line_to(a, limits, 2.0), spline, test::line_to(c, limits)}),
            Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_EQ(joint_after(plan, 0), PathJoint::kRounded);
  EXPECT_EQ(joint_after(plan, 1), PathJoint::kRounded);
  EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
  EXPECT_LE(test::tool_peaks(plan, limits).most(), 1.0 + 2e-3);
  const test::SplineOracle oracle{{a.position_mm, through[0], through[1], b.position_mm}};
  const auto to_line = [](const Vector3d& at, const Vector3d& from, const Vector3d& to) {
    const Vector3d way = to - from;
    return (from + std::clamp(way.dot(at - from) / way.squaredNorm(), 0.0, 1.0) * way - at).norm();
  };
  double worst = 0.0;
  for (std::int64_t tick = 0; tick <= plan.duration.value(); tick += 5) {
    const Vector3d at = tool_pose(plan, seconds(Ticks{tick})).position_mm;
    const double lines =
        std::min(to_line(at, start.position_mm, a.position_mm), to_line(at, b.position_mm, c.position_mm));
    worst = std::max(worst, std::min(lines, static_cast<double>(oracle.distance(at))));
  }
  EXPECT_LE(worst, 2.01);
  EXPECT_GE(worst, 0.2);
}

TEST(SplineMotion, RandomOnesKeepAllLimitsAndUseThem) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  test::Random random{153};
  int planned = 0;
  for (int i = 0; i < kRandomSplines; ++i) {
    SCOPED_TRACE(i);
    std::vector<Vector3d> through;
    for (std::size_t k = 0; k < 1 + static_cast<std::size_t>(i) % ThroughPoints::kMax; ++k) {
      through.push_back(start.position_mm + Vector3d{random.real(-30, 90), random.real(-90, 90), random.real(-60, 60)});
    }
    const Transform end = test::turned_by(moved(start, random.real(0, 60), 100, 0), random.real(0, 0.5), {1, 0, 1});
    PathLimits limits = test::kBrisk;
    limits.speed_mm_s = random.real(50, 800);
    const Progress progress = rig.plan(kReady, spline_to(through, end, limits));
    if (progress != Progress::kDone) {
      EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kOutsideLimits);
      continue;
    }
    ++planned;
    const double joints = test::joint_peaks(rig.robot, rig.set_points()).most(false);
    const double tool = test::tool_peaks(rig.planner.plan(), limits).most();
    EXPECT_LE(joints, 1.0);
    EXPECT_LE(tool, 1.0 + 2e-3);
    EXPECT_GE(std::max(joints, tool), 0.9);
  }
  EXPECT_GE(planned, kRandomSplines / 2);
}

TEST(SplineMotion, APointOutOfReachAndPointsThatCoincideAreRefused) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const Vector3d p = start.position_mm;
  ASSERT_EQ(rig.plan(kReady, spline_to({p + Vector3d{900, 150, 0}}, moved(start, 0, 300, 0), test::kGentle)),
            Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kUnreachable);
  EXPECT_GT(rig.planner.problem().at, 0.4);
  EXPECT_LT(rig.planner.problem().at, 0.6);
  ASSERT_EQ(rig.plan(kReady, spline_to({p}, moved(start, 0, 50, 0), test::kGentle)), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kNoSpline);
}

}  // namespace
}  // namespace armature
