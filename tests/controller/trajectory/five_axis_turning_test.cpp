// The tilted and the upright tool of a five-axis arm on lines, arcs and rounded corners: looked at in the joints alone.
#include "controller/trajectory/cartesian/five_axis_turning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kGentle;
using test::line_to;
using test::moved;
using test::PathRig;
using test::Random;
using Progress = CartesianPlanner::Progress;

const JointAngles kTiltedAside = degrees({20, -60, 70, 40, 30, 0});
const JointAngles kUpright = degrees({20, -60, 110, -50, 30, 0});
const Transform kBentTool{.rotation = rotation_from_rpy(0.3, -0.2, 0.1), .position_mm = {10, -15, 40}};

double pitch(const JointAngles& q) {
  return (q[1] + q[2] + q[3]).value();
}
double roll(const JointAngles& q) {
  return q[4].value();
}
double distance_to_line(const Eigen::Vector3d& p, const Transform& from, const Transform& to) {
  const Eigen::Vector3d way = to.position_mm - from.position_mm;
  const double s = std::clamp(way.dot(p - from.position_mm) / way.squaredNorm(), 0.0, 1.0);
  return (p - from.position_mm - s * way).norm();
}
SegmentRequest keeping(const PathRig& rig, const Transform& from, const Eigen::Vector3d& way_mm) {
  const Eigen::Vector3d to = from.position_mm + way_mm;
  SegmentRequest request = line_to({ArmPlane{rig.robot.arm, rig.flange_T_tool}.kept(from, to, true), to}, kGentle);
  request.keeps_orientation = true;
  return request;
}

TEST(FiveAxisTurning, AToolThatKeepsItsPitchAndRollDrawsStraightLinesWhateverItIs) {
  constexpr std::uint64_t kSeed = 91;
  Random random{kSeed};
  int done = 0;
  for (int draw = 0; draw < test::draws(60); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    const Transform tool{rotation_from_rpy(random.real(-1, 1), random.real(-1, 1), random.real(-3, 3)),
                         {random.real(-30, 30), random.real(-30, 30), random.real(0, 60)}};
    PathRig rig{test::hu2012(), 20.0, tool};
    JointAngles start{};
    for (std::size_t axis = 0; axis < 5; ++axis) start[axis] = Radians{random.real(-2.4, 2.4)};
    const Transform from = rig.tool_at(start);
    const SegmentRequest request =
        keeping(rig, from, {random.real(-40, 40), random.real(-40, 40), random.real(-40, 40)});
    const Transform& to = request.target;
    if (rig.plan(start, request) != Progress::kDone) {
      EXPECT_NE(rig.planner.problem().kind, PathProblem::Kind::kOrientation);
      continue;
    }
    ++done;
    const std::vector<JointAngles> joints = rig.set_points();
    for (std::size_t k = 0; k < joints.size(); k += 7) {
      ASSERT_LT(distance_to_line(rig.tool_at(joints[k]).position_mm, from, to), 1e-9);
      ASSERT_NEAR(pitch(joints[k]), pitch(start), 1e-9);
      ASSERT_NEAR(roll(joints[k]), roll(start), 1e-9);
    }
    ASSERT_LT((rig.tool_at(joints.back()).position_mm - to.position_mm).norm(), 1e-9);
  }
  EXPECT_GT(done, test::draws(25));
}

TEST(FiveAxisTurning, PitchAndRollChangeWithTheShareOfThePathAndEndAsAsked) {
  PathRig rig{test::hu2012(), 20.0, kBentTool};
  const Transform from = rig.tool_at(kTiltedAside);
  const JointAngles end = degrees({-15, -50, 75, 35, -20, 0});
  const Transform to = rig.tool_at(end);
  ASSERT_EQ(rig.plan(kTiltedAside, line_to(to, kGentle)), Progress::kDone);
  const double length = (to.position_mm - from.position_mm).norm();
  const std::vector<JointAngles> joints = rig.set_points();
  for (const JointAngles& q : joints) {
    const Transform tool = rig.tool_at(q);
    const double share = (tool.position_mm - from.position_mm).norm() / length;
    ASSERT_LT(distance_to_line(tool.position_mm, from, to), 1e-9);
    ASSERT_NEAR(pitch(q), pitch(kTiltedAside) + share * (pitch(end) - pitch(kTiltedAside)), 1e-9);
    ASSERT_NEAR(roll(q), roll(kTiltedAside) + share * (roll(end) - roll(kTiltedAside)), 1e-9);
  }
  EXPECT_LT((rig.tool_at(joints.back()).rotation - to.rotation).norm(), 1e-11);
}

TEST(FiveAxisTurning, TellsByHowMuchALineMissesTheOrientationAskedFor) {
  PathRig rig{test::hu2012(1.0), 20.0, kBentTool};
  const Transform from = rig.tool_at(kTiltedAside);
  const Transform to = test::turned_by(moved(from, 20, 10, -10), 0.2, {1.0, 0.3, 0.2});
  ASSERT_EQ(rig.plan(kTiltedAside, std::vector{line_to(moved(from, 5, 0, 0), kGentle), line_to(to, kGentle)}),
            Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const Eigen::Matrix3d miss = rig.tool_at(plan.target).rotation * to.rotation.transpose();
  const double miss_rad = Eigen::AngleAxisd{miss}.angle();
  EXPECT_GT(miss_rad, 0.02);
  EXPECT_NEAR(plan.segments[1].residual_rad, miss_rad, 1e-9);
}

TEST(FiveAxisTurning, ACircleWithATiltedToolComesBackToItsStart) {
  PathRig rig{test::hu2012(), 20.0, kBentTool};
  const Transform from = rig.tool_at(kTiltedAside);
  const Eigen::Vector3d p = from.position_mm, second = p + Eigen::Vector3d{-20, 20, 5}, third{p.x(), p.y() + 40, p.z()};
  ASSERT_EQ(rig.plan(kTiltedAside, test::circle_through(second, {from.rotation, third}, kGentle)), Progress::kDone)
      << static_cast<int>(rig.planner.problem().kind);
  const PositionPath circle = *armature::circle(p, second, third);
  for (const JointAngles& q : rig.set_points()) {
    const Eigen::Vector3d d = rig.tool_at(q).position_mm - circle.center_mm;
    ASSERT_NEAR(std::hypot(d.dot(circle.x), d.dot(circle.y)), circle.radius_mm, 1e-9);
    ASSERT_NEAR(d.dot(circle.x.cross(circle.y)), 0.0, 1e-9);
    ASSERT_NEAR(pitch(q), pitch(kTiltedAside), 1e-9);
  }
  for (std::size_t axis = 0; axis < 5; ++axis) {
    EXPECT_NEAR(rig.planner.plan().target[axis].value(), kTiltedAside[axis].value(), 1e-11) << axis;
  }
}

TEST(FiveAxisTurning, RollGoesTheShorterWay) {
  RobotModel robot = test::hu2012();
  robot.axes[4].min_rad = -4.0, robot.axes[4].max_rad = 4.0;
  PathRig rig{robot};
  const JointAngles start = degrees({20, -60, 70, 40, 170, 0}), end = degrees({10, -60, 70, 40, -160, 0});
  ASSERT_EQ(rig.plan(start, line_to(rig.tool_at(end), kGentle)), Progress::kDone);
  EXPECT_NEAR(roll(rig.planner.plan().target), 200.0 * test::kDeg, 1e-9);
}

// Exactly vertical; and as much off as encoder counts leave after a fault.
TEST(FiveAxisTurning, AnUprightHandKeepsItsOrientationInSpace) {
  for (const double off_deg : {0.0, 0.003, -0.008}) {
    SCOPED_TRACE(off_deg);
    PathRig rig{test::hu2012(), 20.0, kBentTool};
    JointAngles start = kUpright;
    start[3] += Radians{off_deg * test::kDeg};
    const Transform from = rig.tool_at(start);
    const SegmentRequest request = keeping(rig, from, {-20, 90, 10});
    EXPECT_EQ(request.target.rotation, from.rotation);
    ASSERT_EQ(rig.plan(start, request), Progress::kDone);
    const double away_rad = std::fabs(off_deg) * test::kDeg + 1e-10;
    double turned_rad = 0.0;
    for (const JointAngles& q : rig.set_points()) {
      const Transform tool = rig.tool_at(q);
      ASSERT_LT(distance_to_line(tool.position_mm, from, request.target), 1e-9);
      ASSERT_LT((tool.rotation - from.rotation).norm(), 2.0 * away_rad);
      turned_rad = std::max(turned_rad, std::fabs((q[4] - start[4]).value()));
    }
    EXPECT_GT(turned_rad, 0.3);  // joint 5 turns against joint 1
  }
}

TEST(FiveAxisTurning, ALineOverAxis1InThePlaneOfTheArmKeepsItsOrientation) {
  PathRig rig{test::hu2012(), 20.0, {.position_mm = {0, 0, 20}}};
  const Transform flange = FiveR{rig.robot.arm}.to_transform({.x_mm = 40, .z_mm = -10, .pitch_rad = 0.5});
  const IkSolutions solutions = rig.arm.inverse(flange, {});
  ASSERT_GE(solutions.selected, 0);
  const JointAngles start = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
  const Transform from = rig.tool_at(start), to = moved(from, -2.0 * from.position_mm.x(), 0, 0);
  const SegmentRequest request = keeping(rig, from, to.position_mm - from.position_mm);
  EXPECT_EQ(request.target.rotation, from.rotation);
  ASSERT_EQ(rig.plan(start, request), Progress::kDone) << static_cast<int>(rig.planner.problem().kind);
  for (const JointAngles& q : rig.set_points()) {
    ASSERT_LT(distance_to_line(rig.tool_at(q).position_mm, from, to), 1e-9);
    ASSERT_LT((rig.tool_at(q).rotation - from.rotation).norm(), 1e-9);
    ASSERT_NEAR(q[0].value(), start[0].value(), 1e-9);
  }
}

TEST(FiveAxisTurning, RoundsCornersBetweenTiltedPathsAndKeepsBothWaysOfPitchAndRoll) {
  PathRig rig{test::hu2012(), 20.0, kBentTool};
  const Transform from = rig.tool_at(kTiltedAside);
  const JointAngles corner = degrees({5, -55, 72, 38, 10, 0}), end = degrees({0, -40, 70, 35, -10, 0});
  const std::vector chain{line_to(rig.tool_at(corner), kGentle, 5.0), line_to(rig.tool_at(end), kGentle)};
  ASSERT_EQ(rig.plan(kTiltedAside, chain), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  ASSERT_LT(plan.segments[1].start, plan.segments[0].duration);
  double most_mm = 0.0;
  for (const JointAngles& q : rig.set_points()) {
    const Eigen::Vector3d p = rig.tool_at(q).position_mm;
    most_mm = std::max(most_mm, std::min(distance_to_line(p, from, chain[0].target),
                                         distance_to_line(p, chain[0].target, chain[1].target)));
  }
  EXPECT_GT(most_mm, 0.1);
  EXPECT_LT(most_mm, 5.0);
  EXPECT_LT((rig.tool_at(plan.target).position_mm - chain[1].target.position_mm).norm(), 1e-9);
  EXPECT_NEAR(pitch(plan.target), pitch(end), 1e-9);
  EXPECT_NEAR(roll(plan.target), roll(end), 1e-9);
}

TEST(FiveAxisTurning, StopsWhereAnUprightHandBeginsToTilt) {
  PathRig rig{test::hu2012()};
  SegmentRequest first = keeping(rig, rig.tool_at(kUpright), {20, 10, 0});
  first.blend_mm = 5.0;
  const std::vector chain{first, line_to(rig.tool_at(kTiltedAside), kGentle)};
  ASSERT_EQ(rig.plan(kUpright, chain), Progress::kDone);
  EXPECT_EQ(rig.planner.plan().segments[1].start, rig.planner.plan().segments[0].duration);
}

TEST(FiveAxisTurning, LimitsOfTurningHoldForPitchAndRollTogetherAndNotForTheHeading) {
  PathRig rig{test::hu2012()};
  PathLimits limits = kGentle;
  limits.turn_speed_rad_s = 0.2, limits.turn_accel_rad_s2 = 1.0;
  const auto peaks = [&](SegmentRequest request) {
    request.limits = limits;
    EXPECT_EQ(rig.plan(kTiltedAside, request), Progress::kDone) << static_cast<int>(rig.planner.problem().kind);
    test::ToolPeaks result = test::tool_peaks(rig.planner.plan(), limits);
    test::limit_pitch_and_roll(result, rig.set_points(), limits);
    return result;
  };
  const Transform from = rig.tool_at(kTiltedAside);
  const test::ToolPeaks turning = peaks(line_to(rig.tool_at(degrees({20, -60, 70, 70, 70, 0})), limits));
  EXPECT_NEAR(turning.turn_speed, 1.0, 1e-3);
  EXPECT_LE(turning.turn_accel, 1.0 + 1e-6);
  // 100 mm/s across the plane at 200 mm from the axis: the heading alone is faster than 0.2 rad/s.
  const test::ToolPeaks following = peaks(keeping(rig, from, {-40, 50, 0}));
  EXPECT_NEAR(following.speed, 1.0, 1e-3);
  EXPECT_LT(following.turn_speed, 1e-6);
}

}  // namespace
}  // namespace armature
