// The speed of the tool along chains, from the set-points alone: constant wherever the limits allow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr double kBlend_mm = 5.0;

// Step by step of the set-points, by the forward kinematics: mm/s, and the tool half-way.
struct Step {
  double speed = 0.0;
  Vector3d at_mm = Vector3d::Zero();
};

std::vector<Step> steps_of(const PathRig& rig) {
  std::vector<Step> steps;
  const std::vector<JointAngles> joints = rig.set_points();
  Vector3d before = rig.tool_at(joints.front()).position_mm;
  for (const JointAngles& now : joints) {
    const Vector3d tool = rig.tool_at(now).position_mm;
    steps.push_back({(tool - before).norm() / kTickSeconds, 0.5 * (tool + before)});
    before = tool;
  }
  return steps;
}

struct SpeedCase {
  double speed = 0.0, accel = 0.0;
  ProfileKind profile = ProfileKind::kTrapezoid;
};

// Two lines with a right angle between them, rounded.
std::vector<Step> around_a_corner(PathRig& rig, const SpeedCase& of) {
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = of.speed;
  limits.accel_mm_s2 = of.accel;
  const Transform start = rig.tool_at(kReady), corner = moved(start, 0, 60, 0);
  const std::vector<SegmentRequest> chain{line_to(corner, limits, kBlend_mm, of.profile),
                                          line_to(moved(corner, 0, 0, 60), limits, 0.0, of.profile)};
  EXPECT_EQ(rig.plan(kReady, chain), Progress::kDone);
  return steps_of(rig);
}

double least_speed(const std::vector<Step>& steps, double share_of_ends) {
  const auto skipped = static_cast<std::ptrdiff_t>(share_of_ends * static_cast<double>(steps.size()));
  return std::min_element(steps.begin() + skipped, steps.end() - skipped,
                          [](const Step& a, const Step& b) { return a.speed < b.speed; })
      ->speed;
}

TEST(ToolSpeed, IsConstantThroughACornerThatTheAccelerationAllows) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    PathRig rig{test::irb120()};
    constexpr double kSpeed = 60.0;
    const std::vector<Step> steps = around_a_corner(rig, {kSpeed, 2'000.0, profile});
    EXPECT_GE(least_speed(steps, 0.1), 0.99 * kSpeed);
    for (const Step& step : steps) EXPECT_LE(step.speed, 1.001 * kSpeed);
  }
}

TEST(ToolSpeed, DropsOnlyAroundACornerThatNeedsMoreAcceleration) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    PathRig rig{test::irb120()};
    constexpr double kSpeed = 200.0, kAccel = 1'500.0;
    const std::vector<Step> steps = around_a_corner(rig, {kSpeed, kAccel, profile});
    const Vector3d corner_mm = moved(rig.tool_at(kReady), 0, 60, 0).position_mm;
    double least = kSpeed, fastest_before = 0.0;
    for (const Step& step : steps) {
      if ((step.at_mm - corner_mm).norm() < 20.0) least = std::min(least, step.speed);
      if (step.at_mm.z() < corner_mm.z() + 1e-6) fastest_before = std::max(fastest_before, step.speed);
    }
    EXPECT_LT(least, 0.9 * kSpeed);
    EXPECT_GT(least, 0.3 * kSpeed);  // no stop
    EXPECT_GE(fastest_before, 0.98 * kSpeed);
  }
}

// A line, a quarter of a circle and a line in its direction, with an acceleration that the arc allows.
TEST(ToolSpeed, IsConstantFromALineToATangentArcAndBack) {
  PathRig rig{test::irb120()};
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 100.0;
  limits.accel_mm_s2 = 2'000.0;
  const Transform start = rig.tool_at(kReady), a = moved(start, 0, 40, 0), b = moved(a, 0, 30, 30);
  const double r = 30.0, half = std::sqrt(0.5);
  const Vector3d via = a.position_mm + Vector3d{0, r * half, r * (1.0 - half)};
  const std::vector<SegmentRequest> chain{line_to(a, limits), test::arc_to(via, b, limits),
                                          line_to(moved(b, 0, 0, 40), limits)};
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  const std::vector<Step> steps = steps_of(rig);
  EXPECT_GE(least_speed(steps, 0.1), 0.99 * limits.speed_mm_s);
  for (const Step& step : steps) EXPECT_LE(step.speed, 1.001 * limits.speed_mm_s);
}

// In a rounded corner the largest rate of the parameter is not a line between two points of the law.
TEST(ToolSpeed, KeepsItsLimitInRoundedCornersToAMillionth) {
  constexpr std::uint64_t kSeed = 20'261'126;
  test::Random random{kSeed};
  for (int draw = 0; draw < 60; ++draw) {
    PathRig rig{test::irb120()};
    PathLimits limits = test::kBrisk;
    limits.speed_mm_s = random.real(50.0, 200.0);
    std::vector<SegmentRequest> chain;
    Transform at = rig.tool_at(kReady);
    for (int i = 0; i < 3; ++i) {
      const double x = random.real(-30, 30), y = random.real(-30, 30), z = random.real(-30, 30);
      at = moved(at, x, y, z);
      chain.push_back(line_to(at, limits, i < 2 ? random.real(0.5, 10.0) : 0.0));
    }
    ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
    double fastest = 0.0;
    for (const Step& step : steps_of(rig)) fastest = std::max(fastest, step.speed);
    EXPECT_LE(fastest, (1.0 + 1e-6) * limits.speed_mm_s) << "seed " << kSeed << " draw " << draw;
  }
}

// Lines whose direction changes by an angle that is passed without a corner: within a tick, the speed jumps there.
constexpr double kKink_rad = 9e-4;

std::vector<SegmentRequest> lines_with_kinks(const Transform& start, double length_mm, int count,
                                             const PathLimits& limits) {
  std::vector<SegmentRequest> chain;
  Transform at = start;
  for (int i = 0; i < count; ++i) {
    const double angle = i % 2 == 0 ? 0.0 : kKink_rad;
    at = moved(at, 0, length_mm * std::cos(angle), length_mm * std::sin(angle));
    chain.push_back(line_to(at, limits));
  }
  return chain;
}

TEST(ToolSpeed, AtASmallKinkJumpsByThreeTenthsOfTheAcceleration) {
  PathRig rig{test::irb120()};
  const PathLimits limits = test::kBrisk;
  ASSERT_EQ(rig.plan(kReady, lines_with_kinks(rig.tool_at(kReady), 60.0, 2, limits)), Progress::kDone);
  EXPECT_EQ(rig.planner.passes(), 1);
  const double most = 0.3 * limits.accel_mm_s2 * kTickSeconds / kKink_rad;
  ASSERT_LT(most, 0.2 * limits.speed_mm_s);
  const Vector3d kink_mm = moved(rig.tool_at(kReady), 0, 60, 0).position_mm;
  double there = 0.0, nearest_mm = 1e9;
  for (const Step& step : steps_of(rig)) {
    const double off_mm = (step.at_mm - kink_mm).norm();
    if (off_mm < nearest_mm) nearest_mm = off_mm, there = step.speed;
  }
  EXPECT_GT(there, 0.95 * most);
  EXPECT_LT(there, 1.01 * most);
}

// With all of the acceleration beside it, the jump would be an excess that needs a second pass.
TEST(ToolSpeed, LeavesRoomForSmallKinksInTheAcceleration) {
  PathRig rig{test::irb120()};
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 200.0;
  limits.accel_mm_s2 = 4'000.0;
  for (const double length_mm : {0.2, 0.5, 1.0, 3.0}) {
    SCOPED_TRACE(length_mm);
    ASSERT_EQ(rig.plan(kReady, lines_with_kinks(rig.tool_at(kReady), length_mm, 16, limits)), Progress::kDone);
    EXPECT_EQ(rig.planner.passes(), 1);
    EXPECT_LE(test::tool_peaks(rig.planner.plan(), limits).accel, 1.001);
  }
}

}  // namespace
}  // namespace armature
