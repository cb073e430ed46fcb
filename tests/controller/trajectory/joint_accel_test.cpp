// Moves with a share of the joints' acceleration limits.
#include <gtest/gtest.h>

#include <vector>

#include "controller/trajectory/joint/joint_move.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

PathLimits fast(double joint_accel) {
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = 2'000.0;
  limits.accel_mm_s2 = 200'000.0;
  limits.jerk_mm_s3 = 1e7;
  limits.joint_accel = joint_accel;
  return limits;
}

TEST(JointAccel, APathUsesItsShareOfTheAccelerationsAndNoMore) {
  PathRig rig{test::irb120()};
  const Transform end = moved(rig.tool_at(kReady), 0, 250, 50);
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    for (const double share : {1.0, 0.4, 0.05}) {
      SCOPED_TRACE(share);
      ASSERT_EQ(rig.plan(kReady, line_to(end, fast(share), 0.0, profile)), Progress::kDone);
      const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points());
      EXPECT_LE(peaks.accel, share);
      if (profile == ProfileKind::kTrapezoid) {
        EXPECT_GE(peaks.accel, 0.9 * share);
      }
    }
  }
}

TEST(JointAccel, EachSegmentOfAChainHasItsOwn) {
  PathRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady), middle = moved(start, 0, 120, 0), end = moved(start, 0, 240, 0);
  const std::vector<SegmentRequest> chain{line_to(middle, fast(0.1), 1.0), line_to(end, fast(1.0))};
  ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  std::vector<JointAngles> first, second;
  JointAngles joints = plan.start;
  for (std::int64_t tick = 0; tick <= plan.duration.value(); ++tick) {
    joints = position(plan, rig.arm, seconds(Ticks{tick}), joints);
    (Ticks{tick} < plan.segments[1].start ? first : second).push_back(joints);
  }
  EXPECT_LE(test::joint_peaks(rig.robot, first).accel, 0.1);
  EXPECT_GE(test::joint_peaks(rig.robot, second).accel, 0.5);
}

TEST(JointAccel, AJointMoveTakesTheTimeOfItsShare) {
  const RobotModel robot = test::irb120();
  const JointAngles target = test::degrees({40, 10, -20, 30, 60, 90});
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    const JointPlan whole = plan_joint_move(robot, kReady, target, 1.0, SyncRule::kFig9, kind);
    const JointPlan part = plan_joint_move(robot, kReady, target, 1.0, SyncRule::kFig9, kind, 0.25);
    EXPECT_GT(part.duration, whole.duration);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_LE(part.profiles[axis].peak_accel(), 0.25 * robot.axes[axis].max_accel_rad_s2 * (1 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace armature
