// How close the planner's chains come to the shortest time that the path and the limits permit: the bound of
// law_oracle.hpp, from the poses of the path, the inverse kinematics and the requested limits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "controller/core/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/plan/path_corners.hpp"
#include "tests/controller/support/law_oracle.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr PathLimits kFast{.speed_mm_s = 1'000.0,
                           .accel_mm_s2 = 10'000.0,
                           .jerk_mm_s3 = 1e6,
                           .turn_speed_rad_s = 10.0,
                           .turn_accel_rad_s2 = 100.0,
                           .turn_jerk_rad_s3 = 1e4};
constexpr double kMost = 1.05;

// Limits at `count` + 1 equally spaced points of the planned path, without any margin. Derivatives are differences.
std::vector<LawLimits> limits_along(const PathRig& rig, const PathLimits& most, int count) {
  const CartesianPlan& plan = rig.planner.plan();
  const double length = length_of(plan), h = length / count;
  std::vector<JointAngles> joints{plan.start};
  std::vector<Eigen::Vector3d> places;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i <= count; ++i) {
    const Transform pose = tool_on_path(plan, h * i).tool.base_T_tool;
    places.push_back(pose.position_mm);
    rotations.push_back(pose.rotation);
    if (i > 0) joints.push_back(rig.arm.track(pose * inverse(rig.flange_T_tool), joints.back()).joints);
  }
  std::vector<LawLimits> result;
  for (int i = 0; i <= count; ++i) {
    const auto k = static_cast<std::size_t>(std::clamp(i, 1, count - 1));
    LawLimits limits;
    double speed = 1e30;
    const auto at_most = [&](double rate, double limit) {
      if (rate > 0.0) speed = std::min(speed, limit / rate);
    };
    for (std::size_t axis = 0; axis < rig.robot.axis_count; ++axis) {
      const double a = joints[k - 1][axis].value(), b = joints[k][axis].value(), c = joints[k + 1][axis].value();
      const AxisModel& model = rig.robot.axes[axis];
      limits.bands[axis] = {(c - a) / (2.0 * h) / model.max_accel_rad_s2,
                            (a - 2.0 * b + c) / (h * h) / model.max_accel_rad_s2};
      at_most(std::fabs(c - a) / (2.0 * h), AxisUnits{model}.max_speed_rad_s());
    }
    const auto ellipse = [](const Eigen::Vector3d& slope, const Eigen::Vector3d& bend, double limit) {
      return LawLimits::Ellipse{slope.squaredNorm() / (limit * limit), slope.dot(bend) / (limit * limit),
                                bend.squaredNorm() / (limit * limit)};
    };
    const Eigen::Vector3d slope = (places[k + 1] - places[k - 1]) / (2.0 * h);
    const Eigen::Vector3d bend = (places[k + 1] - 2.0 * places[k] + places[k - 1]) / (h * h);
    const auto turn = [&](std::size_t from, std::size_t to) -> Eigen::Vector3d {
      const Eigen::Matrix3d m = rotations[to] * rotations[from].transpose();
      return 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
    };
    const Eigen::Vector3d before = turn(k - 1, k), after = turn(k, k + 1);
    limits.ellipses = {ellipse(slope, bend, most.accel_mm_s2),
                       ellipse((before + after) / (2.0 * h), (after - before) / (h * h), most.turn_accel_rad_s2)};
    at_most(slope.norm(), most.speed_mm_s);
    at_most(((before + after) / (2.0 * h)).norm(), most.turn_speed_rad_s);
    limits.most_square = speed * speed;
    result.push_back(limits);
  }
  return result;
}

// The share of the bound that the planned motion takes.
double over_the_bound(PathRig& rig, const JointAngles& start, const std::vector<SegmentRequest>& chain,
                      int count = 8'000) {
  if (rig.plan(start, chain) != Progress::kDone) {
    ADD_FAILURE() << "refused: " << static_cast<int>(rig.planner.problem().kind);
    return 0.0;
  }
  const CartesianPlan& plan = rig.planner.plan();
  const std::vector<LawLimits> limits = limits_along(rig, chain.front().limits, count);
  const auto bound_s = static_cast<double>(test::least_duration_s(limits, length_of(plan) / count));
  const double planned_s = seconds(plan.duration);
  EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
  const double share = planned_s / bound_s;
  testing::Test::RecordProperty("over_the_bound", std::to_string(share));
  EXPECT_GT(share, 0.995);
  return share;
}

Transform down_from(const PathRig& rig, double x_mm, double y_mm, double z_mm) {
  return {rig.tool_at(kReady).rotation, {x_mm, y_mm, z_mm - 72.0}};
}
JointAngles joints_at(const PathRig& rig, const Transform& pose) {
  const IkSolutions solutions = rig.arm.inverse(pose, kReady);
  EXPECT_GE(solutions.selected, 0);
  return solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
}

TEST(ToppBound, LineThatPassesAxis1AtAFewMillimetres) {
  for (const double miss_mm : {2.0, 4.0, 10.0}) {
    RobotModel robot = test::irb120();
    robot.axes[3].min_rad = robot.axes[5].min_rad = -7.0, robot.axes[3].max_rad = robot.axes[5].max_rad = 7.0;
    PathRig rig{robot};
    const Transform from = down_from(rig, miss_mm, -150, 650), to = down_from(rig, miss_mm, 150, 650);
    EXPECT_LE(over_the_bound(rig, joints_at(rig, from), {line_to(to, kFast)}, 40'000), kMost);
  }
}

TEST(ToppBound, LineThatEndsCloseToTheReachLimit) {
  PathRig rig{test::irb120()};
  const double reach = 270.0 + std::hypot(70.0, 302.0);
  const Transform from = down_from(rig, 400, 0, 290), to = down_from(rig, reach - 0.3, 0, 290);
  EXPECT_LE(over_the_bound(rig, joints_at(rig, from), {line_to(to, kFast)}, 40'000), kMost);
}

TEST(ToppBound, CircleWhereJointsLimit) {
  PathRig rig{test::irb120()};
  const Transform from = rig.tool_at(kReady);
  PathLimits limits = kFast;
  limits.speed_mm_s = 5'000.0, limits.accel_mm_s2 = 1e5;
  const auto request = test::circle_through(moved(from, 100, 100, 0).position_mm, moved(from, 0, 200, 0), limits);
  EXPECT_LE(over_the_bound(rig, degrees({0, 0, 0, 0, 90, 0}), {request}), kMost);
}

TEST(ToppBound, TenCollinearLines) {
  PathRig rig{test::irb120()};
  std::vector<SegmentRequest> chain;
  for (int i = 1; i <= 10; ++i) chain.push_back(line_to(moved(rig.tool_at(kReady), 0, 5.0 * i, 0), kFast, 0.05));
  EXPECT_LE(over_the_bound(rig, kReady, chain), kMost);
  const Ticks ten = rig.planner.plan().duration;
  ASSERT_EQ(rig.plan(kReady, chain.back()), Progress::kDone);
  EXPECT_LE(ten, rig.planner.plan().duration + Ticks{1});
}

TEST(ToppBound, LineArcLineWithCommonTangents) {
  PathRig rig{test::irb120()};
  const Transform a = rig.tool_at(kReady), b = moved(a, 0, 60, 0), c = moved(b, -80, 0, 0), d = moved(a, -80, 0, 0);
  const Eigen::Vector3d via = moved(b, -40, 40, 0).position_mm;
  const std::vector chain{line_to(b, kFast), test::arc_to(via, c, kFast), line_to(d, kFast)};
  EXPECT_LE(over_the_bound(rig, kReady, chain), kMost);
}

TEST(ToppBound, FourteenLinesOfAMillimetre) {
  PathRig rig{test::irb120()};
  std::vector<SegmentRequest> chain;
  Transform at = rig.tool_at(kReady);
  for (int i = 0; i < 14; ++i) {
    at = moved(at, std::sin(0.1 * i), std::cos(0.1 * i), 0);
    chain.push_back(line_to(at, kFast, 0.05));
  }
  EXPECT_LE(over_the_bound(rig, kReady, chain), kMost);
}

TEST(ToppBound, SquareWithRoundedCorners) {
  PathRig rig{test::irb120()};
  const Transform a = rig.tool_at(kReady);
  for (const double blend_mm : {0.1, 1.0, 5.0}) {
    const std::vector chain{line_to(moved(a, 0, 60, 0), kFast, blend_mm),
                            line_to(moved(a, -60, 60, 0), kFast, blend_mm),
                            line_to(moved(a, -60, 0, 0), kFast, blend_mm), line_to(a, kFast)};
    EXPECT_LE(over_the_bound(rig, kReady, chain, 40'000), kMost) << blend_mm;
  }
}

TEST(ToppBound, LineThroughTheWristSingularity) {
  PathRig rig{test::irb120()};
  const JointAngles start = degrees({0, 10, -20, 0, -20, 0});
  const Transform target = test::turned_by(rig.tool_at(start), 40.0 * test::kDeg, {0, 1, 0});
  EXPECT_LE(over_the_bound(rig, start, {line_to(target, kFast)}), kMost);
}

// A point that was taught a little beside the singularity: joint 4 has to turn by half a revolution.
TEST(ToppBound, LinesThatMissTheWristSingularity) {
  for (const double miss_mm : {1e-3, 0.1, 0.5, 3.0, 10.0}) {
    SCOPED_TRACE(miss_mm);
    RobotModel robot = test::irb120();
    robot.axes[3].min_rad = robot.axes[5].min_rad = -7.0, robot.axes[3].max_rad = robot.axes[5].max_rad = 7.0;
    PathRig rig{robot};
    const Transform from = moved(rig.tool_at(degrees({0, 0, 0, 0, 25, 0})), 0, miss_mm, 0);
    const Transform to = moved(from, 0, 0, -150);
    ASSERT_EQ(rig.plan(joints_at(rig, from), line_to(to, kFast)), Progress::kDone);
    EXPECT_LE(rig.planner.passes(), 3);
    EXPECT_LE(test::joint_peaks(robot, rig.set_points()).most(false), 1.0);
    // The grid of the bound shows joint 4 only where it takes more than a few of its points.
    if (miss_mm > 0.4) {
      EXPECT_LE(over_the_bound(rig, joints_at(rig, from), {line_to(to, kFast)}, 60'000), kMost);
    }
  }
}

}  // namespace
}  // namespace armature
