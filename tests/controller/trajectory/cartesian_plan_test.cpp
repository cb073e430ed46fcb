#include "controller/trajectory/cartesian/cartesian_plan.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;

// Lines through three poses in 900 ticks at a constant speed, with a corner of `c` on both sides.
CartesianPlan corner(const Transform& a, const Transform& b, const Transform& c, double rounded = 0.0) {
  CartesianPlan plan;
  plan.count = 2;
  plan.duration = Ticks{900};
  const std::array<Transform, 3> poses{a, b, c};
  double from = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    CartesianSegment& segment = plan.segments[i];
    segment.path = line(poses[i].position_mm, poses[i + 1].position_mm);
    segment.orientation = turn(poses[i].rotation, poses[i + 1].rotation);
    segment.from = from;
    segment.length = segment.path.length_mm;
    from += segment.length;
  }
  plan.segments[0].corner = rounded;
  plan.segments[0].duration = plan.segments[1].start = Ticks{400};
  plan.segments[1].duration = Ticks{500};
  const double speed = from / (900.0 * kTickSeconds);
  plan.table.append({.t_s = 0.0, .s = 0.0, .speed = speed});
  plan.table.append({.t_s = 900.0 * kTickSeconds, .s = from, .speed = speed});
  plan.table.end(plan.duration);
  return plan;
}

const Transform kA{Eigen::Matrix3d::Identity(), {100, 200, 300}};
const Transform kB = test::turned_by(test::moved(kA, 50, 0, 0), 0.5, {1, 0, 0});
const Transform kC = test::turned_by(test::moved(kB, 0, 80, 0), 0.7, {0, 1, 1});

double at(double tick) {
  return tick * kTickSeconds;
}

// B of the corner.
double second_share(double u) {
  return u * u * u - 0.5 * u * u * u * u;
}

TEST(CartesianPlan, IsWhereItsSegmentsAreBesidesTheCorner) {
  const CartesianPlan plan = corner(kA, kB, kC, 20.0);
  for (const double s_mm : {0.0, 17.5, 29.0}) {
    const Transform pose = tool_on_path(plan, s_mm).tool.base_T_tool;
    EXPECT_LT((pose.position_mm - point(plan.segments[0].path, s_mm / 50.0)).norm(), 1e-12);
    EXPECT_LT((pose.rotation - rotation(plan.segments[0].orientation, s_mm / 50.0)).norm(), 1e-14);
  }
  for (const double s_mm : {71.0, 100.0, 129.9}) {
    const double share = (s_mm - 50.0) / 80.0;
    const Transform pose = tool_on_path(plan, s_mm).tool.base_T_tool;
    EXPECT_LT((pose.position_mm - point(plan.segments[1].path, share)).norm(), 1e-12);
    EXPECT_LT((pose.rotation - rotation(plan.segments[1].orientation, share)).norm(), 1e-14);
  }
}

TEST(CartesianPlan, SuperposesBothSegmentsInTheCorner) {
  const CartesianPlan plan = corner(kA, kB, kC, 20.0);
  for (const double u : {0.01, 0.3, 0.5, 0.77, 0.99}) {
    const double b = second_share(u), covered = 40.0 * b, left = 20.0 - 40.0 * (u - b);
    const Transform pose = tool_on_path(plan, 30.0 + 40.0 * u).tool.base_T_tool;
    EXPECT_LT((pose.position_mm - Eigen::Vector3d{150.0 - left, 200.0 + covered, 300.0}).norm(), 1e-11);
    // The second turn is about an axis of the base, seen from the corner.
    const Eigen::Matrix3d& at_corner = kB.rotation;
    const Eigen::Matrix3d first =
        Eigen::AngleAxisd{0.5 * (1.0 - left / 50.0), Eigen::Vector3d::UnitX()}.toRotationMatrix();
    const Eigen::Matrix3d second =
        Eigen::AngleAxisd{0.7 * covered / 80.0, Eigen::Vector3d{0, 1, 1}.normalized()}.toRotationMatrix();
    EXPECT_LT((pose.rotation - first * (at_corner.transpose() * second * at_corner)).norm(), 1e-13);
  }
}

TEST(CartesianPlan, IsContinuousAndExactAtBothEnds) {
  const CartesianPlan plan = corner(kA, kB, kC, 20.0);
  Transform last = tool_pose(plan, 0.0);
  for (double tick = 0.25; tick <= 901.0; tick += 0.25) {
    const Transform now = tool_pose(plan, at(tick));
    ASSERT_LT((now.position_mm - last.position_mm).norm(), 0.25 * 1.001 * 130.0 / 900.0) << tick;
    ASSERT_LT((now.rotation - last.rotation).norm(), 0.01) << tick;
    last = now;
  }
  EXPECT_EQ(tool_pose(plan, -1.0).position_mm, kA.position_mm);
  EXPECT_EQ(tool_pose(plan, at(900)).position_mm, kC.position_mm);  // bit for bit
  EXPECT_EQ(tool_pose(plan, at(900)).rotation, kC.rotation);
  EXPECT_EQ(tool_pose(plan, 1e9).position_mm, kC.position_mm);
}

TEST(CartesianPlan, NamesTheSegmentThatBeganLast) {
  const CartesianPlan plan = corner(kA, kB, kC);
  EXPECT_EQ(segment_at(plan, -1.0), 0u);
  EXPECT_EQ(segment_at(plan, 0.0), 0u);
  EXPECT_EQ(segment_at(plan, at(399)), 0u);
  EXPECT_EQ(segment_at(plan, at(400)), 1u);
  EXPECT_EQ(segment_at(plan, 1e9), 1u);
  EXPECT_EQ(segment_at(CartesianPlan{}, 0.0), 0u);
}

TEST(CartesianPlan, JointsAreExactlyStartAndTargetAtTheEndsAndFollowTheToolBetween) {
  test::PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 5, -5, 20, 60, 30});
  ASSERT_EQ(rig.plan(start, test::line_to(test::moved(rig.tool_at(start), 10, 60, 5), test::kBrisk)),
            CartesianPlanner::Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const double end_s = static_cast<double>(plan.duration.value()) * kTickSeconds;
  EXPECT_EQ(position(plan, rig.arm, 0.0, {}), start);
  EXPECT_EQ(position(plan, rig.arm, -1.0, {}), start);
  EXPECT_EQ(position(plan, rig.arm, end_s, {}), plan.target);
  EXPECT_EQ(position(plan, rig.arm, end_s + 1.0, {}), plan.target);
  const JointAngles middle = position(plan, rig.arm, 0.5 * end_s, start);
  EXPECT_LT((rig.tool_at(middle).position_mm - tool_pose(plan, 0.5 * end_s).position_mm).norm(), 1e-9);
}

TEST(CartesianPlan, TheJointsGoOnSmoothlyOutsideTheirLimits) {
  test::PathRig rig{test::irb120()};
  const JointAngles start = degrees({10, 5, -5, 20, 60, 30});
  ASSERT_EQ(rig.plan(start, test::line_to(test::moved(rig.tool_at(start), 10, 60, 5), test::kBrisk)),
            CartesianPlanner::Progress::kDone);
  RobotModel narrow = rig.robot;
  narrow.axes[0].max_rad = 12.0 * test::kDeg;  // passed on the way
  const Arm arm{narrow};
  JointAngles joints = start, expected = start;
  for (double tick = 0.5; tick < static_cast<double>(rig.planner.plan().duration.value()); tick += 1.0) {
    joints = position(rig.planner.plan(), arm, at(tick), joints);
    expected = position(rig.planner.plan(), rig.arm, at(tick), expected);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_NEAR(joints[axis].value(), expected[axis].value(), 1.1e-9) << tick;
    }
  }
  EXPECT_GT(joints[0].value(), narrow.axes[0].max_rad + 1e-3);
}

TEST(CartesianPlan, TheArmStretchesTowardsAPoseBeyondItsReach) {
  const Arm arm{test::irb120()};
  const CartesianPlan plan = corner(kA, kB, test::moved(kB, 0, 5'000, 0));
  const JointAngles joints = position(plan, arm, at(800), degrees({60, 2, 3, 4, 5, 6}));
  EXPECT_LT(arm.manipulability(joints).elbow, 1e-12);
  const Eigen::Vector3d wanted = tool_pose(plan, at(800)).position_mm;
  EXPECT_NEAR(joints[0].value(), std::atan2(wanted.y(), wanted.x()), 0.05);
}

// Joint 5 passes 0 and the flange's axis misses axis 4 by so little that the ticks do not see the half turn.
TEST(CartesianPlan, NearMissesOfTheWristSingularityKeepTheirLimitsBetweenTicks) {
  test::PathRig rig{test::irb120()};
  int accepted = 0;
  for (const double miss : {0.0, 1e-13, 1e-12, 5e-12, 8e-12, 1e-11, 1.2e-11, 1.4e-11, 1.6e-11, 1.8e-11, 2e-11}) {
    for (const double angle : {20.0, 20.37}) {
      JointAngles start = degrees({0, 10, -20, 0, -angle, 0});
      start[3] = Radians{miss / std::sin(angle * test::kDeg)};
      const Transform target = test::turned_by(rig.tool_at(start), 2.06 * angle * test::kDeg, {0, 1, 0});
      if (rig.plan(start, test::line_to(target, test::kBrisk)) != CartesianPlanner::Progress::kDone) continue;
      ++accepted;
      for (const double shift : {0.0, 0.13, 0.37, 0.5, 0.61, 0.88}) {
        const std::vector<JointAngles> joints = rig.set_points(shift);
        EXPECT_LE(test::joint_peaks(rig.robot, joints).accel, 1.0) << miss << " " << angle << " " << shift;
        ASSERT_GT(joints.back()[4].value(), 0.1);
      }
    }
  }
  EXPECT_GE(accepted, 6);
}

TEST(CartesianPlan, LeavesTheStretchedArmByTheFirstElbowWhereBothAreInside) {
  const Arm arm{test::hu2012()};
  const IkTracking tracking = arm.track(arm.forward(degrees({0, -30, -0.5, 70, 0, 0})), degrees({0, -30, 0, 70, 0, 0}));
  EXPECT_NEAR(tracking.joints[2].value(), 0.5 * test::kDeg, 1e-9);
}

// Both elbows are as near: only one has its joint 3 inside the limits.
TEST(CartesianPlan, LeavesTheStretchedArmByTheElbowInsideItsLimits) {
  for (const bool up : {false, true}) {
    RobotModel robot = test::hu2012();
    (up ? robot.axes[2].max_rad : robot.axes[2].min_rad) = 0.0;
    const Arm arm{robot};
    const JointAngles stretched = degrees({0, -30, 0, 70, 0, 0});
    const JointAngles bent = degrees({0, -30, up ? -0.5 : 0.5, 70, 0, 0});
    const IkTracking tracking = arm.track(arm.forward(bent), stretched);
    ASSERT_TRUE(solved(tracking.status)) << up;
    EXPECT_NEAR(tracking.joints[2].value(), bent[2].value(), 1e-9);
  }
}

}  // namespace
}  // namespace armature
