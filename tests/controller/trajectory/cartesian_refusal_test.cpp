// What the planner refuses, why and where.
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
using test::down_from;
using test::expect_reached;
using test::joints_at;
using test::kBrisk;
using test::kGentle;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using test::turned_by;
using Progress = CartesianPlanner::Progress;
using Problem = PathProblem::Kind;

TEST(CartesianRefusal, RefusesALineOutOfReachAndTellsWhereAndByHowMuch) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady), near = moved(from, 0, 50, 0), far = moved(from, 500, 0, 0);
  ASSERT_EQ(rig.plan(kReady, std::vector{line_to(near, kGentle), line_to(far, kGentle)}), Progress::kRefused);
  const PathProblem& problem = rig.planner.problem();
  EXPECT_EQ(problem.kind, Problem::kUnreachable);
  EXPECT_EQ(problem.segment, 1);
  // The wrist centre is 72 mm above the tool; the shoulder at a height of 290 mm reaches a2 + hypot(a3, d4).
  const double reach = 270.0 + std::hypot(70.0, 302.0);
  const auto beyond = [&](const Eigen::Vector3d& tool) {
    return (tool + Eigen::Vector3d{0, 0, 72.0 - 290.0}).norm() - reach;
  };
  EXPECT_NEAR(problem.margin_mm, beyond(far.position_mm), 1e-6);
  EXPECT_EQ(problem.at, 1.0);
  EXPECT_EQ(rig.planner.inverses(), 0);
}

TEST(CartesianRefusal, RefusesPointsOfAnArcAndACircleOutOfReachBeforeTheyAreDriven) {
  PathRig rig{test::irb120()};
  // About a vertical axis 302 mm in front; the wrist centre is 340 mm above the shoulder and reaches to 470 mm there.
  const auto at_angle = [&](double angle_rad) {
    return down_from(rig, 302.0 + 200.0 * std::sin(angle_rad), -200.0 * std::cos(angle_rad), 630.0);
  };
  const double pi = std::numbers::pi, reach = 270.0 + std::hypot(70.0, 302.0);
  const auto beyond = [&](const Transform& tool) {
    return (tool.position_mm + Eigen::Vector3d{0, 0, 72.0 - 290.0}).norm() - reach;
  };
  const JointAngles start = joints_at(rig, at_angle(0.0));
  const Transform close = at_angle(0.1 * pi), far = at_angle(0.6 * pi), end = at_angle(pi);
  ASSERT_LT(beyond(close), 0.0);
  ASSERT_GT(beyond(far), 1.0);
  ASSERT_LT(beyond(end), 0.0);
  struct Case {
    const char* name;
    SegmentRequest request;
    double at;
  };
  const std::array at_once{
      Case{"via", test::arc_to(far.position_mm, end, kGentle), 0.6},
      Case{"second", test::circle_through(far.position_mm, at_angle(1.1 * pi), kGentle), 0.3},
      Case{"third", test::circle_through(close.position_mm, far, kGentle), 0.3},
      Case{"end", test::arc_to(close.position_mm, far, kGentle), 1.0},
  };
  for (const Case& c : at_once) {
    SCOPED_TRACE(c.name);
    ASSERT_EQ(rig.plan(start, c.request), Progress::kRefused);
    EXPECT_EQ(rig.planner.problem().kind, Problem::kUnreachable);
    EXPECT_EQ(rig.planner.inverses(), 0);
    EXPECT_NEAR(rig.planner.problem().at, c.at, 1e-12);
    EXPECT_NEAR(rig.planner.problem().margin_mm, beyond(far), 1e-6);
  }

  // Between points within reach only the way tells where it leaves the reach, and by how much.
  ASSERT_EQ(rig.plan(start, test::arc_to(close.position_mm, end, kGentle)), Progress::kRefused);
  const PathProblem& problem = rig.planner.problem();
  EXPECT_EQ(problem.kind, Problem::kUnreachable);
  EXPECT_GT(rig.planner.inverses(), 1'000);
  EXPECT_NEAR(beyond(at_angle(problem.at * pi)), 0.0, 0.02);  // a tick
  EXPECT_NEAR(problem.margin_mm, beyond(at_angle(0.5 * pi)), 1e-4);
}

TEST(CartesianRefusal, ACornerOutOfReachMayBeRounded) {
  PathRig rig{test::irb120()};
  const double reach = 270.0 + std::hypot(70.0, 302.0);
  const Transform out = down_from(rig, reach + 2.0, 0, 290), back = down_from(rig, reach - 120.0, 120, 290);
  const Transform start = down_from(rig, reach - 120.0, -120, 290);
  const JointAngles there = joints_at(rig, start);
  EXPECT_EQ(rig.plan(there, std::vector{line_to(out, kGentle, 40.0), line_to(back, kGentle)}), Progress::kDone);
  EXPECT_EQ(rig.plan(there, std::vector{line_to(out, kGentle), line_to(back, kGentle)}), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().segment, 0);
  EXPECT_EQ(rig.planner.inverses(), 0);
}

TEST(CartesianRefusal, NamesTheJointThatWouldLeaveItsLimits) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({0, 0, 0, 0, 90, 350});
  const Transform from = rig.tool_at(start);
  // The flange's z points down: joint 6 turns on when the tool turns backwards about the vertical.
  ASSERT_EQ(rig.plan(start, line_to(turned_by(from, -1.4, {0, 0, 1}), kGentle)), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kOutsideLimits);
  EXPECT_EQ(rig.planner.problem().axis, 6);
  EXPECT_NEAR(rig.planner.problem().angle_rad, 400.0 * test::kDeg, 1e-3) << "its limit";
  EXPECT_GT(rig.planner.problem().angle_rad, 400.0 * test::kDeg);
  EXPECT_NEAR(rig.planner.problem().at, 50.0 * test::kDeg / 1.4, 1e-3);
  EXPECT_EQ(rig.plan(start, line_to(turned_by(from, 1.4, {0, 0, 1}), kGentle)), Progress::kDone);
}

TEST(CartesianRefusal, RefusesPathsThatPassTooNearASingularityByItsName) {
  RobotModel robot = test::irb120();
  robot.axes[3].min_rad = -4.0, robot.axes[3].max_rad = 4.0;
  PathRig rig{robot, 1.3};
  struct Case {
    const char* name;
    Transform from, to;
    std::uint8_t singular;
  };
  // Sinking, the forearm comes into line with the tool, but for 3 mm.
  const Transform tilted = moved(rig.tool_at(degrees({0, 0, 0, 0, 25, 0})), 0, 3, 0);
  const std::array cases{
      Case{"wrist", tilted, moved(tilted, 0, 0, -150), kWristSingular},
      Case{"shoulder", down_from(rig, 4, -150, 650), down_from(rig, 4, 150, 650), kShoulderSingular},
      Case{"elbow", down_from(rig, 400, 0, 290), down_from(rig, 580.0, 0, 290), kElbowSingular},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const JointAngles start = joints_at(rig, c.from);
    ASSERT_EQ(rig.plan(start, line_to(c.to, kBrisk)), Progress::kRefused);
    const PathProblem& problem = rig.planner.problem();
    EXPECT_EQ(problem.kind, Problem::kTooFast);
    EXPECT_EQ(problem.singular, c.singular);
    EXPECT_GT(problem.stretch, 1.3);
    EXPECT_GE(problem.axis, 1);
    EXPECT_LE(problem.axis, 6);
    // Where it is: the pose there is nearly singular, too.
    const Eigen::Vector3d place = c.from.position_mm + problem.at * (c.to.position_mm - c.from.position_mm);
    const Manipulability m = rig.arm.manipulability(joints_at(rig, {c.from.rotation, place}));
    EXPECT_LT(std::min({m.shoulder, m.elbow, m.wrist}), 0.1) << problem.at;
  }
}

// The arm of five joints, its tool pointing forwards and down in the plane of its axis 1.
const JointAngles kFiveReady = degrees({0, -60, 70, 40, 0, 0});

TEST(CartesianRefusal, FiveJointsFollowALineInTheirPlane) {
  PathRig rig{test::hu2012()};
  const Transform target = moved(rig.tool_at(kFiveReady), 40, 0, -25);
  ASSERT_EQ(rig.plan(kFiveReady, line_to(target, kGentle)), Progress::kDone);
  expect_reached(rig, target);
  for (const JointAngles& joints : rig.set_points()) EXPECT_EQ(joints[5], Radians{});
}

TEST(CartesianRefusal, TellsByHowMuchFiveJointsMissAnOrientation) {
  const auto across = [](double max_projection_rad, PathProblem& problem) {
    PathRig rig{test::hu2012(max_projection_rad)};
    const Transform from = rig.tool_at(kFiveReady), target = moved(from, 0, 60, 0);
    const auto progress = rig.plan(kFiveReady, line_to(target, kGentle));
    problem = rig.planner.problem();
    if (progress == Progress::kDone) {
      const Transform reached = rig.tool_at(rig.planner.plan().target);
      EXPECT_LT((reached.position_mm - target.position_mm).norm(), 1e-9);
    }
    // The approach is to stay in the plane y = 0 while the arm turns: the angle between it and the arm's plane.
    const Eigen::Vector3d normal = Eigen::Vector3d{-target.position_mm.y(), target.position_mm.x(), 0}.normalized();
    return std::pair{progress, std::asin(std::fabs(normal.dot(from.rotation.col(2))))};
  };
  PathProblem problem;
  const auto [progress, residual] = across(0.0, problem);
  ASSERT_EQ(progress, Progress::kRefused);
  EXPECT_EQ(problem.kind, Problem::kOrientation);
  EXPECT_NEAR(problem.residual_rad, residual, 1e-9);
  EXPECT_EQ(problem.at, 1.0);
  EXPECT_EQ(across(residual + 1e-6, problem).first, Progress::kDone);
  EXPECT_EQ(across(residual - 1e-6, problem).first, Progress::kRefused);
}

TEST(CartesianRefusal, TooFastWithoutASingularityNamesNone) {
  PathRig rig{test::irb120(), 1.0};
  PathLimits fast = kGentle;
  fast.speed_mm_s = 5e3, fast.accel_mm_s2 = 1e5;
  ASSERT_EQ(rig.plan(kReady, line_to(moved(rig.tool_at(kReady), 0, 100, 0), fast)), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kTooFast);
  EXPECT_EQ(rig.planner.problem().singular, kNotSingular);
}

TEST(CartesianRefusal, RefusesAnArcWithoutACircle) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady), a = moved(from, 0, 50, 0), b = moved(from, 0, 100, 0),
                  c = moved(from, 0, 150, 0);
  ASSERT_EQ(rig.plan(kReady, std::vector{line_to(a, kGentle), test::arc_to(b.position_mm, c, kGentle)}),
            Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kNoCircle);
  EXPECT_EQ(rig.planner.problem().segment, 1);
}

TEST(CartesianRefusal, RefusesASegmentThatWouldTakeMoreThan600Seconds) {
  PathRig rig{test::irb120()};
  PathLimits crawl = kGentle;
  crawl.speed_mm_s = 0.01;
  const auto begin = [&](double mm) {
    rig.planner.begin(kReady, std::vector{line_to(moved(rig.tool_at(kReady), 0, mm, 0), crawl)});
    return rig.planner.progress();
  };
  EXPECT_EQ(begin(5.9), Progress::kWorking);
  ASSERT_EQ(begin(6.1), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kTooLong);
}

TEST(CartesianRefusal, RefusesNumbersThatAreNone) {
  PathRig rig{test::irb120()};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(rig.plan(kReady, line_to(moved(rig.tool_at(kReady), 0, bad, 0), kGentle)), Progress::kRefused);
    EXPECT_EQ(rig.planner.problem().kind, Problem::kInvalidPose);
  }
}

TEST(CartesianRefusal, RefusesLimitsThatAreNoneOnLinesAndArcs) {
  PathRig rig{test::irb120()};
  const Transform end = moved(rig.tool_at(kReady), 0, 10, 0);
  SegmentRequest around = line_to(end, kGentle);
  around.kind = SegmentRequest::Kind::kArc;
  around.via_mm = moved(rig.tool_at(kReady), 5, 5, 0).position_mm;
  for (SegmentRequest request : {line_to(end, kGentle), around}) {
    for (double PathLimits::*limit :
         {&PathLimits::speed_mm_s, &PathLimits::accel_mm_s2, &PathLimits::jerk_mm_s3, &PathLimits::turn_speed_rad_s,
          &PathLimits::turn_accel_rad_s2, &PathLimits::turn_jerk_rad_s3}) {
      for (const double bad :
           {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200, 0.0, -1.0}) {
        request.profile = ProfileKind::kSCurve;
        request.limits = kGentle;
        request.limits.*limit = bad;
        EXPECT_EQ(rig.plan(kReady, request), Progress::kRefused) << bad;
        EXPECT_EQ(rig.planner.problem().kind, Problem::kInvalidLimits) << bad;
      }
    }
  }
}

TEST(CartesianRefusal, RefusesMoreSegmentsThanAPlanHolds) {
  PathRig rig{test::irb120()};
  const std::vector<SegmentRequest> chain(CartesianPlan::kMaxSegments + 1, line_to(rig.tool_at(kReady), kGentle));
  EXPECT_EQ(rig.plan(kReady, chain), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kTooManySegments);
}

}  // namespace
}  // namespace armature
