#include "controller/trajectory/plan/cartesian_planner.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "controller/trajectory/joint/joint_move.hpp"
#include "tests/controller/support/expect_reached.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::expect_reached;
using test::kBrisk;
using test::kGentle;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using test::turned_by;
using Progress = CartesianPlanner::Progress;
using Problem = PathProblem::Kind;

TEST(CartesianPlanner, ALineRunsAtItsLimitsWhereTheJointsCanFollow) {
  PathRig rig{test::irb120()};
  const Transform target = moved(rig.tool_at(kReady), 30, 100, -40);
  ASSERT_EQ(rig.plan(kReady, line_to(target, kGentle)), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_EQ(plan.segments[0].stretch, 1.0);
  // Trapezoid: v / a + l / v.
  const double length = std::sqrt(30. * 30. + 100. * 100. + 40. * 40.);
  EXPECT_NEAR(static_cast<double>(plan.duration.value()) * 50e-6, 0.1 + length / 100.0, 51e-6);
  EXPECT_EQ(rig.planner.passes(), 1);
  const test::ToolPeaks peaks = test::tool_peaks(plan, kGentle);
  EXPECT_NEAR(peaks.speed, 1.0, 1e-3);
  EXPECT_NEAR(peaks.accel, 1.0, 1e-3);
  EXPECT_EQ(plan.start, kReady);
  expect_reached(rig, target);
}

TEST(CartesianPlanner, TheToolAndNotTheFlangeFollowsThePath) {
  const Transform tool{Eigen::AngleAxisd{0.7, Eigen::Vector3d{1, 2, 3}.normalized()}.toRotationMatrix(), {10, -20, 90}};
  PathRig rig{test::irb120(), 20.0, tool};
  const Transform from = rig.tool_at(kReady), target = moved(from, 0, 80, 0);
  ASSERT_EQ(rig.plan(kReady, line_to(target, kGentle)), Progress::kDone);
  for (const JointAngles& joints : rig.set_points()) {
    const Eigen::Vector3d off = rig.tool_at(joints).position_mm - from.position_mm;
    ASSERT_LT(std::hypot(off.x(), off.z()), 1e-9);
    ASSERT_LT((rig.tool_at(joints).rotation - from.rotation).cwiseAbs().maxCoeff(), 1e-12);
  }
  expect_reached(rig, target);
}

TEST(CartesianPlanner, AFullCircleInATiltedPlaneComesBackWithinItsTotalAcceleration) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  const Eigen::Vector3d second = from.position_mm + Eigen::Vector3d{-20, 40, 30};
  const Transform third = moved(from, -60, 10, -20);
  PathLimits limits = kGentle;
  limits.speed_mm_s = 1e4;  // the centripetal acceleration decides
  ASSERT_EQ(rig.plan(kReady, test::circle_through(second, third, limits)), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const double r = plan.segments[0].path.radius_mm;
  const test::ToolPeaks peaks = test::tool_peaks(plan, limits);
  EXPECT_LT(peaks.accel, 1.001);
  EXPECT_GT(peaks.accel, 0.99);
  const double fastest = std::sqrt(limits.accel_mm_s2 * r);  // all of it towards the centre
  EXPECT_NEAR(peaks.speed * limits.speed_mm_s, fastest, 0.01 * fastest);
  expect_reached(rig, from);
}

TEST(CartesianPlanner, TurnsInPlaceAtTheLimitsOfTurning) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  const Transform target = turned_by(from, 0.6, {0, 0, 1});
  ASSERT_EQ(rig.plan(kReady, line_to(target, kGentle)), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_NEAR(static_cast<double>(plan.duration.value()) * 50e-6, 0.1 + 0.6 / 0.5, 51e-6);
  EXPECT_NEAR(test::tool_peaks(plan, kGentle).turn_speed, 1.0, 1e-3);
  expect_reached(rig, target);
}

TEST(CartesianPlanner, ASlowTurnHoldsBackALine) {
  PathRig rig{test::irb120()};
  Transform target = turned_by(rig.tool_at(kReady), 1.0, {0, 0, 1});
  target = moved(target, 0, 20, 0);
  ASSERT_EQ(rig.plan(kReady, line_to(target, kGentle)), Progress::kDone);
  EXPECT_NEAR(static_cast<double>(rig.planner.plan().duration.value()) * 50e-6, 0.1 + 1.0 / 0.5, 51e-6);
  expect_reached(rig, target);
}

TEST(CartesianPlanner, TurnsByHalfARevolution) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  const Transform target = turned_by(from, std::numbers::pi, {0, 0, 1});
  ASSERT_EQ(rig.plan(kReady, line_to(target, kGentle)), Progress::kDone);
  expect_reached(rig, target);
  EXPECT_NEAR(std::fabs(rig.planner.plan().target[5].value()), std::numbers::pi, 1e-9);
}

TEST(CartesianPlanner, NothingToDoTakesNoTick) {
  PathRig rig{test::irb120()};
  const Transform here = rig.tool_at(kReady);
  const std::vector<SegmentRequest> chain{line_to(here, kGentle, 10.0), line_to(here, kGentle)};
  EXPECT_EQ(rig.plan(kReady, chain), Progress::kDone);
  EXPECT_EQ(rig.planner.plan().duration, Ticks{0});
  EXPECT_EQ(rig.planner.plan().target, kReady);
  EXPECT_EQ(rig.planner.plan().count, 2u);
  EXPECT_EQ(rig.plan(kReady, std::span<const SegmentRequest>{}), Progress::kDone);
  EXPECT_EQ(rig.planner.plan().duration, Ticks{0});
}

TEST(CartesianPlanner, AnEmptySegmentWithinAChainIsAnExactStop) {
  PathRig rig{test::irb120()};
  const Transform a = rig.tool_at(kReady), b = moved(a, 0, 50, 0), c = moved(b, 0, 0, -50);
  const std::vector<SegmentRequest> chain{line_to(a, kGentle, 10.0), line_to(b, kGentle, 10.0),
                                          line_to(b, kGentle, 10.0), line_to(c, kGentle)};
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_EQ(plan.segments[0].duration, Ticks{0});
  EXPECT_EQ(plan.segments[2].duration, Ticks{0});
  EXPECT_EQ(plan.segments[3].start, plan.segments[1].duration);
  EXPECT_EQ(plan.duration, plan.segments[1].duration + plan.segments[3].duration);
  expect_reached(rig, c);
}

TEST(CartesianPlanner, StretchesJustAsMuchAsTheJointsNeed) {
  const PathLimits fast{.speed_mm_s = 5e3,
                        .accel_mm_s2 = 1e5,
                        .jerk_mm_s3 = 1e7,
                        .turn_speed_rad_s = 50,
                        .turn_accel_rad_s2 = 1e3,
                        .turn_jerk_rad_s3 = 1e5};
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    PathRig rig{test::irb120()};
    const Transform from = rig.tool_at(kReady);
    for (const Transform& target :
         {moved(from, 0, 200, 0), moved(from, 100, 0, -100), turned_by(moved(from, 20, 0, 0), 1.0, {1, 0, 1})}) {
      ASSERT_EQ(rig.plan(kReady, line_to(target, fast, 0.0, kind)), Progress::kDone);
      EXPECT_GT(rig.planner.plan().segments[0].stretch, 1.5);
      EXPECT_LE(rig.planner.passes(), 3);
      const double most = test::joint_peaks(rig.robot, rig.set_points()).most(kind == ProfileKind::kSCurve);
      EXPECT_LE(most, 1.0);
      EXPECT_GT(most, 0.95);
      expect_reached(rig, target);
    }
  }
}

TEST(CartesianPlanner, TheRestAfterAMoveOfATickOrTwoKeepsTheJerkLimit) {
  const PathLimits none{.speed_mm_s = 1e6,
                        .accel_mm_s2 = 1e12,
                        .jerk_mm_s3 = 1e18,
                        .turn_speed_rad_s = 1e6,
                        .turn_accel_rad_s2 = 1e12,
                        .turn_jerk_rad_s3 = 1e18};
  PathRig rig{test::irb120()};
  for (double length_mm = 2e-8; length_mm < 2e-6; length_mm *= 1.2) {
    const Transform target = moved(rig.tool_at(kReady), 0, length_mm, 0);
    ASSERT_EQ(rig.plan(kReady, line_to(target, none, 0.0, ProfileKind::kSCurve)), Progress::kDone) << length_mm;
    EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(true), 1.0) << length_mm;
  }
}

TEST(CartesianPlanner, StretchesOnlyTheSegmentThatNeedsIt) {
  PathRig rig{test::irb120()};
  const Transform a = moved(rig.tool_at(kReady), 0, 60, 0), b = moved(a, 0, 0, -60), c = moved(b, 40, 0, 0);
  PathLimits fast = kGentle;
  fast.speed_mm_s = 5e3, fast.accel_mm_s2 = 1e5;
  ASSERT_EQ(rig.plan(kReady, std::vector{line_to(a, kGentle), line_to(b, fast), line_to(c, kGentle)}), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_EQ(plan.segments[0].stretch, 1.0);
  EXPECT_GT(plan.segments[1].stretch, 1.5);
  EXPECT_EQ(plan.segments[2].stretch, 1.0);
}

TEST(CartesianPlanner, NamesTheJointThatAPathIsStretchedFor) {
  const RobotModel robot = test::irb120();
  PathRig rig{robot};
  const Transform from = rig.tool_at(kReady), target = turned_by(moved(from, 20, 60, -40), 0.5, {1, 0.3, 1});
  const std::vector there_and_back{line_to(target, kBrisk), line_to(from, kBrisk)};
  ASSERT_EQ(rig.plan(kReady, there_and_back), Progress::kDone);
  EXPECT_EQ(rig.planner.plan().segments[0].stretched_for, 0);
  const std::vector<JointAngles> points = rig.set_points();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    double speed_rad_s = 0.0, accel_rad_s2 = 0.0;
    for (std::size_t i = 2; i < points.size(); ++i) {
      const double step = (points[i][axis] - points[i - 1][axis]).value();
      const double before = (points[i - 1][axis] - points[i - 2][axis]).value();
      speed_rad_s = std::max(speed_rad_s, std::fabs(step) / kTickSeconds);
      accel_rad_s2 = std::max(accel_rad_s2, std::fabs(step - before) / (kTickSeconds * kTickSeconds));
    }
    RobotModel slow = robot, weak = robot;
    slow.axes[axis].max_speed_rad_s = speed_rad_s / 3.0;
    weak.axes[axis].max_accel_rad_s2 = accel_rad_s2 / 6.0;
    for (const RobotModel* limited : {&slow, &weak}) {
      PathRig limited_rig{*limited};
      ASSERT_EQ(limited_rig.plan(kReady, there_and_back), Progress::kDone);
      for (const std::size_t i : {0u, 1u}) {
        const char* const what = limited == &slow ? "slow" : "weak";
        EXPECT_GT(limited_rig.planner.plan().segments[i].stretch, 1.6) << what;
        EXPECT_EQ(limited_rig.planner.plan().segments[i].stretched_for, axis + 1) << what;
      }
    }
  }
}

TEST(CartesianPlanner, ThePulseGeneratorsLimitAFineDrive) {
  RobotModel robot = test::irb120();
  for (AxisModel& axis : robot.axes) axis.pulses_per_rev = 1'310'720;  // 21.97 deg/s
  PathRig rig{robot};
  ASSERT_EQ(rig.plan(kReady, line_to(moved(rig.tool_at(kReady), 0, 150, 0), kBrisk)), Progress::kDone);
  EXPECT_GT(rig.planner.plan().segments[0].stretch, 2.0);
  const test::JointPeaks peaks = test::joint_peaks(robot, rig.set_points());
  EXPECT_LE(peaks.speed, 1.0);
  EXPECT_GT(peaks.speed, 0.95);
}

TEST(CartesianPlanner, WorksInSlicesOfAnySizeWithTheSameResult) {
  const JointAngles start = degrees({10, 5, -5, 20, 60, 30});
  PathRig whole{test::irb120()}, sliced{test::irb120()};
  const Transform target = moved(whole.tool_at(start), 40, -60, 20);
  const SegmentRequest request = line_to(target, kBrisk);
  ASSERT_EQ(whole.plan(start, request), Progress::kDone);
  EXPECT_EQ(sliced.planner.progress(), Progress::kIdle);
  EXPECT_EQ(sliced.planner.work(100), Progress::kIdle);
  sliced.planner.begin(start, std::span{&request, 1});
  EXPECT_EQ(sliced.planner.work(0), Progress::kWorking);
  std::size_t slices = 1;
  while (sliced.planner.work(static_cast<std::int64_t>(slices % 7 + 1)) == Progress::kWorking) ++slices;
  ASSERT_EQ(sliced.planner.progress(), Progress::kDone);
  EXPECT_GT(slices, 30u);
  EXPECT_EQ(sliced.planner.plan().target, whole.planner.plan().target);  // bit for bit
  EXPECT_EQ(sliced.planner.plan().duration, whole.planner.plan().duration);
}

// What core 1 is charged before the first motion, at 7 us each: it does not depend on the speed.
TEST(CartesianPlanner, ASlowPathIsPlannedAsSoonAsAFastOne) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    for (const double speed_mm_s : {1.0, 2.0, 20.0, 100.0}) {
      PathRig rig{test::irb120()};
      PathLimits limits = kGentle;
      limits.speed_mm_s = speed_mm_s;
      const Transform from = rig.tool_at(kReady);
      ASSERT_EQ(rig.plan(kReady, line_to(moved(from, 0, 100, 0), limits, 0.0, profile)), Progress::kDone);
      EXPECT_LT(rig.planner.inverses(), 5'000) << speed_mm_s;
      if (profile == ProfileKind::kSCurve) continue;
      std::vector<SegmentRequest> sides;
      for (int i = 1; i <= 16; ++i) {
        const double x = i % 4 == 1 || i % 4 == 2 ? -20.0 : 0.0, y = i % 4 == 2 || i % 4 == 3 ? 20.0 : 0.0;
        sides.push_back(line_to(moved(from, x, y, -0.1 * i), limits, 1.0, profile));
      }
      ASSERT_EQ(rig.plan(kReady, sides), Progress::kDone);
      EXPECT_LT(rig.planner.inverses(), 50'000) << speed_mm_s;
    }
  }
}

TEST(CartesianPlanner, StartsAfreshAfterGivingUpAndAfterARefusal) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  const SegmentRequest good = line_to(moved(from, 0, 50, 0), kGentle), bad = line_to(moved(from, 900, 0, 0), kGentle);
  rig.planner.begin(kReady, std::span{&bad, 1});
  rig.planner.work(50);
  rig.planner.cancel();
  EXPECT_EQ(rig.planner.progress(), Progress::kIdle);
  EXPECT_EQ(rig.planner.work(50), Progress::kIdle);
  ASSERT_EQ(rig.plan(kReady, bad), Progress::kRefused);
  ASSERT_EQ(rig.plan(kReady, good), Progress::kDone);
  EXPECT_EQ(rig.planner.passes(), 1);
  expect_reached(rig, good.target);
}

}  // namespace
}  // namespace armature
