// How close the planner's chains come to the shortest time that the path and the limits permit: the bound of
// law_oracle.hpp, from the poses of the path, the inverse kinematics and the requested limits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/topp_cases.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kFast;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr double kMax = 1.05;

// The share of the bound that the planned motion takes.
double over_the_bound(PathRig& rig, const JointAngles& start, const std::vector<SegmentRequest>& chain,
                      int count = 8'000) {
  if (rig.plan(start, chain) != Progress::kDone) {
    ADD_FAILURE() << "refused: " << static_cast<int>(rig.planner.problem().kind);
    return 0.0;
  }
  const CartesianPlan& plan = rig.planner.plan();
  const std::vector<LawLimits> limits = test::limits_along(rig, chain.front().limits, count);
  const auto bound_s = static_cast<double>(test::least_duration_s(limits, length_of(plan) / count));
  const double planned_s = seconds(plan.duration);
  EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
  const double share = planned_s / bound_s;
  testing::Test::RecordProperty("over_the_bound", std::to_string(share));
  EXPECT_GT(share, 0.995);
  return share;
}

TEST(ToppBound, PathsOfTheCases) {
  for (const test::ToppCase& path : test::topp_cases()) {
    PathRig rig{path.robot};
    EXPECT_LE(over_the_bound(rig, path.start, path.chain, path.count), kMax) << path.name;
  }
}

TEST(ToppBound, TenCollinearLinesTakeAsLongAsOne) {
  PathRig rig{test::irb120()};
  std::vector<SegmentRequest> chain;
  for (int i = 1; i <= 10; ++i) chain.push_back(line_to(moved(rig.tool_at(kReady), 0, 5.0 * i, 0), kFast));
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  const Ticks ten = rig.planner.plan().duration;
  ASSERT_EQ(rig.plan(kReady, chain.back()), Progress::kDone);
  EXPECT_LE(ten, rig.planner.plan().duration + Ticks{1});
}

TEST(ToppBound, LineArcLineWithCommonTangents) {
  PathRig rig{test::irb120()};
  EXPECT_LE(over_the_bound(rig, kReady, test::line_arc_line(0.0)), kMax);
}

TEST(ToppBound, FourteenLinesOfAMillimetre) {
  PathRig rig{test::irb120()};
  EXPECT_LE(over_the_bound(rig, kReady, test::fourteen_lines()), kMax);
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
    ASSERT_EQ(rig.plan(test::joints_at(rig, from), line_to(to, kFast)), Progress::kDone);
    EXPECT_LE(rig.planner.passes(), 3);
    EXPECT_LE(test::joint_peaks(robot, rig.set_points()).most(false), 1.0);
    // The grid of the bound shows joint 4 only where it takes more than a few of its points.
    if (miss_mm > 0.4) {
      EXPECT_LE(over_the_bound(rig, test::joints_at(rig, from), {line_to(to, kFast)}, 60'000), kMax);
    }
  }
}

}  // namespace
}  // namespace armature
