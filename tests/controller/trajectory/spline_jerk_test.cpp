// Splines and tangent chains with limited jerk: the jerk of the joints, and the whole jerk of the tool and of its
// rotation, from the set-points alone, and how long such motions take.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "controller/trajectory/cartesian/path_corners.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/spline_request.hpp"
#include "tests/controller/support/tool_jerk.hpp"
#include "tests/controller/support/topp_cases.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using test::spline_to;
using Progress = CartesianPlanner::Progress;

constexpr double kMaxJerk = 1.05;
constexpr double kMaxOverBound = 1.25;
const int kJerkSplines = test::draws(25);

// Third differences of the tool by the forward kinematics of the set-points, as a share of the limit.
double jerk_of_joints_tool(const PathRig& rig, double most_mm_s3, double shift) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  std::array<Wide, 4> last;
  const std::vector<JointAngles> joints = rig.set_points(shift);
  last.fill(rig.tool_at(joints.front()).position_mm.cast<long double>());
  long double most = 0.0L;
  for (const JointAngles& now : joints) {
    last = {rig.tool_at(now).position_mm.cast<long double>(), last[0], last[1], last[2]};
    most = std::max(most, (last[0] - 3.0L * last[1] + 3.0L * last[2] - last[3]).norm());
  }
  constexpr long double kTick = 50e-6L;
  return static_cast<double>(most / (kTick * kTick * kTick) / static_cast<long double>(most_mm_s3));
}

void expect_within_limits(const PathRig& rig, const PathLimits& limits) {
  for (const double shift : {0.0, 0.37}) {
    const test::JointPeaks joints = test::joint_peaks(rig.robot, rig.set_points(shift));
    EXPECT_LE(joints.most(false), 1.0 + 1e-3);
    EXPECT_LE(joints.jerk, kMaxJerk);
    const test::ToolJerks tool = test::tool_jerks(rig.planner.plan(), limits, shift);
    EXPECT_LE(static_cast<double>(tool.move), kMaxJerk);
    EXPECT_LE(static_cast<double>(tool.turn), kMaxJerk);
    EXPECT_LE(jerk_of_joints_tool(rig, limits.jerk_mm_s3, shift), kMaxJerk + 1e-3);
  }
  EXPECT_LE(test::tool_peaks(rig.planner.plan(), limits).most(), 1.001);
}

// Of the shortest time that the path permits with the limit of the jerk across it.
double share_of_bound(const PathRig& rig, const PathLimits& limits, int count) {
  return seconds(rig.planner.plan().duration) / test::bound_with_jerk_s(rig, limits, count);
}

TEST(SplineJerk, RandomSplinesKeepTheWholeJerk) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  test::Random random{171};
  int planned = 0;
  double slowest = 0.0;
  for (int i = 0; i < kJerkSplines; ++i) {
    SCOPED_TRACE(i);
    std::vector<Vector3d> through;
    Vector3d at = start.position_mm;
    for (int k = 0; k <= i % 6; ++k) {
      at += Vector3d{random.real(-15, 15), random.real(8, 30), random.real(-15, 15)};
      through.push_back(at);
    }
    at += Vector3d{random.real(-15, 15), random.real(8, 30), random.real(-15, 15)};
    const double turn_rad = i % 2 == 0 ? 0.0 : random.real(0, 0.3);
    const Transform end = test::turned_by({start.rotation, at}, turn_rad, {1, 0, 1});
    PathLimits limits = i % 3 == 0 ? test::kGentle : test::kBrisk;
    limits.speed_mm_s = random.real(50, 400);
    if (rig.plan(kReady, spline_to(through, end, limits, ProfileKind::kSCurve)) != Progress::kDone) {
      EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kOutsideLimits);
      continue;
    }
    ++planned;
    expect_within_limits(rig, limits);
    slowest = std::max(slowest, share_of_bound(rig, limits, 1'000));
  }
  EXPECT_GE(planned, kJerkSplines - 2);
  RecordProperty("slowest", std::to_string(slowest));
  EXPECT_LE(slowest, kMaxOverBound);
}

TEST(SplineJerk, ATangentChainOfLinesAndASplineKeepsTheWholeJerkWithoutAStop) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady), a = moved(start, 0, 30, 0);
  // The spline begins and ends in the directions of the lines beside it up to a small angle, which is rounded.
  const std::vector<Vector3d> through{moved(a, 0, 10, 0).position_mm, moved(a, 3, 30, 4).position_mm,
                                      moved(a, 10, 60, 8).position_mm, moved(a, 13, 80, 12).position_mm};
  const Transform b = moved(a, 13, 90, 12), c = moved(b, 0, 40, 0);
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 150.0;
  limits.jerk_mm_s3 = 60'000.0;
  SegmentRequest spline = spline_to(through, b, limits, ProfileKind::kSCurve);
  spline.blend_mm = 0.5;
  const std::vector<SegmentRequest> chain{line_to(a, limits, 0.5, ProfileKind::kSCurve), spline,
                                          line_to(c, limits, 0.0, ProfileKind::kSCurve)};
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  EXPECT_NE(joint_after(rig.planner.plan(), 0), PathJoint::kStop);
  EXPECT_NE(joint_after(rig.planner.plan(), 1), PathJoint::kStop);
  expect_within_limits(rig, limits);
}

TEST(SplineJerk, TangentLinesAndArcsKeepTheWholeJerkWithAndWithoutABlend) {
  for (const double blend_mm : {0.0, 0.1, 1.0}) {
    PathRig rig{test::irb120()};
    std::vector<SegmentRequest> chain = test::line_arc_line(blend_mm);
    for (SegmentRequest& request : chain) request.profile = ProfileKind::kSCurve;
    ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
    expect_within_limits(rig, chain.front().limits);
  }
}

}  // namespace
}  // namespace armature
