// The number of passes of the planner over a path is bounded.
#include <gtest/gtest.h>

#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

// With a jerk limit below the rounding of set-points no plan is ever clean, however slow.
TEST(CartesianPasses, APathThatSlownessDoesNotMendIsRefusedAfterTheMost) {
  RobotModel robot = test::irb120();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 8e-3;
  test::PathRig rig{robot, 1e6};
  ASSERT_EQ(rig.plan(test::kReady, test::line_to(test::moved(rig.tool_at(test::kReady), 0, 1e-4, 0), test::kGentle, 0.0,
                                                 ProfileKind::kSCurve)),
            CartesianPlanner::Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kTooFast);
  EXPECT_LT(rig.planner.problem().stretch, 1e6);
  EXPECT_EQ(rig.planner.passes(), CartesianPlanner::kMaxPasses);
}

}  // namespace
}  // namespace armature
