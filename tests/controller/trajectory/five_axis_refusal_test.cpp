// What five joints cannot do on a path is refused with its reason; the tool never leaves the path instead.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/trajectory/path/arm_plane.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kGentle;
using test::line_to;
using test::moved;
using test::PathRig;
using Problem = PathProblem::Kind;
using Progress = CartesianPlanner::Progress;

const JointAngles kTilted = degrees({0, -60, 70, 40, 30, 0});

SegmentRequest keeping(const PathRig& rig, const JointAngles& start, const Eigen::Vector3d& to_mm) {
  const ArmPlane plane{rig.robot.arm, rig.flange_T_tool};
  SegmentRequest request = line_to({plane.kept(rig.tool_at(start), to_mm, true), to_mm}, kGentle);
  request.keeps_orientation = true;
  return request;
}

TEST(FiveAxisRefusal, AnEndOrientationOutOfThePlaneBeyondTheAllowanceIsNamedAtTheEnd) {
  const Transform tool{.position_mm = {10, -15, 40}};
  PathRig strict{test::hu2012(0.02), 20.0, tool}, lenient{test::hu2012(0.04), 20.0, tool};
  Transform to = strict.tool_at(degrees({-30, -55, 75, 35, 20, 0}));
  // About the axis in the plane that is normal to the approach, which leaves the plane by 0.03.
  const Eigen::Vector3d normal{-std::sin(-30 * test::kDeg), std::cos(-30 * test::kDeg), 0};
  to = test::turned_by(to, 0.03, to.rotation.col(2).cross(normal));
  ASSERT_EQ(strict.plan(kTilted, line_to(to, kGentle)), Progress::kRefused);
  EXPECT_EQ(strict.planner.problem().kind, Problem::kOrientation);
  EXPECT_EQ(strict.planner.problem().at, 1.0);
  EXPECT_GT(strict.planner.problem().residual_rad, 0.02);
  EXPECT_LT(strict.planner.problem().residual_rad, 0.04);
  ASSERT_EQ(lenient.plan(kTilted, line_to(to, kGentle)), Progress::kDone);
  const Transform reached = lenient.tool_at(lenient.planner.plan().target);
  EXPECT_LT((reached.position_mm - to.position_mm).norm(), 1e-9);
  EXPECT_NEAR(Eigen::AngleAxisd(Eigen::Matrix3d{reached.rotation.transpose() * to.rotation}).angle(),
              strict.planner.problem().residual_rad, 1e-9);
}

TEST(FiveAxisRefusal, AnApproachAcrossThePlaneIsRefusedHoweverMuchIsAllowed) {
  PathRig rig{test::hu2012(3.0)};
  const Transform from = rig.tool_at(kTilted);
  Transform to = moved(from, 5, 0, 0);
  to.rotation.col(2) = Eigen::Vector3d{0, 1, 0};
  to.rotation.col(0) = Eigen::Vector3d{1, 0, 0};
  to.rotation.col(1) = Eigen::Vector3d{0, 0, -1};
  ASSERT_EQ(rig.plan(kTilted, line_to(to, kGentle)), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kOrientation);
}

TEST(FiveAxisRefusal, APointNearerToAxis1ThanTheToolIsAsideCannotBeReached) {
  // At a roll of 0 the tool is 40 mm aside of the arm's plane.
  PathRig rig{test::hu2012(), 20.0, {.position_mm = {0, 40, 0}}};
  const JointAngles start = degrees({0, -130, 90, 70, 0, 0});
  const Transform from = rig.tool_at(start);
  const double rho = std::hypot(from.position_mm.x(), from.position_mm.y());
  ASSERT_GT(rho, 41.0);
  const Eigen::Vector3d to = from.position_mm - 0.7 * Eigen::Vector3d{from.position_mm.x(), from.position_mm.y(), 0};
  ASSERT_LT(0.3 * rho, 39.0);
  ASSERT_EQ(rig.plan(start, keeping(rig, start, to)), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, Problem::kUnreachable);
  EXPECT_NEAR(rig.planner.problem().margin_mm, 40.0 - 0.3 * rho, 1e-6);
}

TEST(FiveAxisRefusal, ATiltedToolPassesAxis1OnlyAsSlowlyAsMayBe) {
  RobotModel robot = test::hu2012();
  robot.axes[0].min_rad = -4.0, robot.axes[0].max_rad = 4.0;
  const JointAngles start = degrees({0, -130, 60, 110, 0, 0});
  for (const double aside_mm : {0.001, 1.0}) {
    PathRig rig{robot}, impatient{robot, 1.1};
    const Transform from = rig.tool_at(start);
    const Eigen::Vector3d to = from.position_mm - Eigen::Vector3d{2.0 * from.position_mm.x(), aside_mm, 0};
    ASSERT_EQ(rig.plan(start, keeping(rig, start, to)), Progress::kDone) << aside_mm;
    EXPECT_LE(test::joint_peaks(robot, rig.set_points()).most(false), 1.0);
    EXPECT_GT(rig.planner.plan().segments[0].stretch, 1.2);
    EXPECT_EQ(rig.planner.plan().segments[0].stretched_for, 1);

    ASSERT_EQ(impatient.plan(start, keeping(rig, start, to)), Progress::kRefused) << aside_mm;
    EXPECT_EQ(impatient.planner.problem().kind, Problem::kTooFast);
    EXPECT_NEAR(impatient.planner.problem().at, 0.5, 0.02);
  }
}

}  // namespace
}  // namespace armature
