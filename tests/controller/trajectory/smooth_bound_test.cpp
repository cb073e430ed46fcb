// Chains with limited jerk: how close they come to the shortest time without it (topp_cases.hpp), and that the jerk of
// the joints and the whole jerk of the tool, also across the path, stay within 1.05 of their limits on the set-points.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "controller/trajectory/profile/scurve.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/tool_jerk.hpp"
#include "tests/controller/support/topp_cases.hpp"

namespace armature {
namespace {

using test::kFast;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr double kMaxJerk = 1.05;
constexpr double kMaxOverTopp = 1.25;  // of the bound that knows no jerk
constexpr double kMaxOfJerk = 1.05;    // of one that does

double plan_s(PathRig& rig, const JointAngles& start, std::vector<SegmentRequest> chain) {
  for (SegmentRequest& request : chain) request.profile = ProfileKind::kSCurve;
  if (rig.plan(start, chain) != Progress::kDone) {
    ADD_FAILURE() << "refused: " << static_cast<int>(rig.planner.problem().kind);
    return 0.0;
  }
  // As a motion loop sends them, and between ticks as after a hold.
  for (const double shift : {0.0, 0.37}) {
    const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points(shift));
    EXPECT_LE(peaks.most(false), 1.0 + 1e-3);
    EXPECT_LE(peaks.jerk, kMaxJerk);
    const test::ToolJerks jerks = test::tool_jerks(rig.planner.plan(), chain.front().limits, shift);
    EXPECT_LE(static_cast<double>(jerks.move), kMaxJerk);
    EXPECT_LE(static_cast<double>(jerks.turn), kMaxJerk);
  }
  EXPECT_LE(test::tool_peaks(rig.planner.plan(), chain.front().limits).most(), 1.001);
  return seconds(rig.planner.plan().duration);
}

double bound_s(const PathRig& rig, const PathLimits& limits, int count) {
  const double step = length_of(rig.planner.plan()) / count;
  return static_cast<double>(test::least_duration_s(test::limits_along(rig, limits, count), step));
}

TEST(SmoothBound, PathsOfTheCases) {
  for (const test::ToppCase& path : test::topp_cases()) {
    SCOPED_TRACE(path.name);
    PathRig rig{path.robot};
    const double taken_s = plan_s(rig, path.start, path.chain);
    const double share = taken_s / bound_s(rig, path.chain.front().limits, path.count);
    RecordProperty(path.name, std::to_string(share));
    EXPECT_LE(share, kMaxOverTopp);
  }
}

TEST(SmoothBound, OneLineTakesHardlyLongerThanTheFastestSCurve) {
  for (const double length_mm : {0.01, 0.1, 1.0, 10.0, 50.0, 200.0}) {
    PathRig rig{test::irb120()};
    const double taken_s = plan_s(rig, kReady, {line_to(moved(rig.tool_at(kReady), 0, length_mm, 0), kFast)});
    const SCurveProfile fastest =
        plan_scurve(length_mm, {.speed = kFast.speed_mm_s, .accel = kFast.accel_mm_s2, .jerk = kFast.jerk_mm_s3});
    EXPECT_LE(taken_s, 1.02 * fastest.duration_s + 2.0 * kTickSeconds) << length_mm;
    EXPECT_GE(taken_s, 0.99 * fastest.duration_s) << length_mm;
  }
}

// Without a blend the tool nearly stops at the jump of the curvature: its acceleration would change within a tick.
TEST(SmoothBound, LineArcLine) {
  PathRig rig{test::irb120()};
  const double blended_s = plan_s(rig, kReady, test::line_arc_line(0.1));
  EXPECT_LE(blended_s, kMaxOverTopp * bound_s(rig, kFast, 20'000));
  const double tangent_s = plan_s(rig, kReady, test::line_arc_line(0.0));
  double exact_s = 0.0;
  JointAngles at = kReady;
  for (const SegmentRequest& request : test::line_arc_line(0.0)) {
    exact_s += plan_s(rig, at, {request});
    at = rig.planner.plan().target;
  }
  EXPECT_LE(tangent_s, kMaxOfJerk * exact_s);
}

// Their corners need the limit of jerk at any speed.
TEST(SmoothBound, FourteenLinesOfAMillimetre) {
  PathRig rig{test::irb120()};
  const double taken_s = plan_s(rig, kReady, test::fourteen_lines());
  const double share = taken_s / test::bound_with_jerk_s(rig, kFast, 20'000);
  RecordProperty("over_the_bound", std::to_string(share));
  EXPECT_LE(share, kMaxOverTopp);
}

// Along the path its jerk is small, across it is v^3 / r^2.
TEST(SmoothBound, ASmallCircleKeepsTheWholeJerk) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  PathLimits limits = kFast;
  limits.speed_mm_s = 150.0, limits.accel_mm_s2 = 2'000.0;
  for (const double jerk_mm_s3 : {8'000.0, 20'000.0, 1e6}) {
    limits.jerk_mm_s3 = jerk_mm_s3;
    const auto circle = test::circle_through(moved(from, 20, 20, 0).position_mm, moved(from, 0, 40, 0), limits);
    const double taken_s = plan_s(rig, kReady, {circle});
    const double speed = std::min(limits.speed_mm_s, std::cbrt(jerk_mm_s3 * 20.0 * 20.0));
    const SCurveProfile along =
        plan_scurve(40.0 * std::numbers::pi, {.speed = speed, .accel = limits.accel_mm_s2, .jerk = jerk_mm_s3});
    EXPECT_LE(taken_s, kMaxOverTopp * along.duration_s) << jerk_mm_s3;
  }
}

}  // namespace
}  // namespace armature
