#include "controller/trajectory/joint_move.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/core/timebase.hpp"
#include "tests/controller/random.hpp"
#include "tests/controller/robots.hpp"

namespace armature {
namespace {

using test::degrees;

TEST(JointMove, Figure9Takes870Milliseconds) {
  const RobotModel robot = test::paper_robot();
  const JointPlan plan = plan_joint_move(robot, {}, degrees(test::kFigure9Deg), 1.0, SyncRule::kFig9);
  EXPECT_EQ(plan.duration, Ticks{17'400});
}

TEST(JointMove, StartsAndEndsExactly) {
  const RobotModel robot = test::paper_robot();
  test::Random random{6};
  for (int draw = 0; draw < 5'000; ++draw) {
    PerAxis<Radians> start, target;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      start[axis] = Radians{random.real(-2.9, 2.9)};
      target[axis] = random.integer(0, 4) == 0 ? start[axis] : Radians{random.real(-2.9, 2.9)};
    }
    const JointPlan plan = plan_joint_move(robot, start, target, random.real(0.01, 1.0), SyncRule::kFig9);
    const double end_s = static_cast<double>(plan.duration.value()) * kTickSeconds;
    ASSERT_EQ(position(plan, 0.0), start);
    ASSERT_EQ(position(plan, end_s), target);  // bit for bit
    ASSERT_EQ(position(plan, end_s + 1.0), target);
  }
}

TEST(JointMove, EveryJointIsMonotonicSoThatTheTargetDecidesAboutLimits) {
  const RobotModel robot = test::paper_robot();
  const JointPlan plan =
      plan_joint_move(robot, degrees({1, 2, 3, 4, 5, 6}), degrees(test::kFigure9Deg), 0.9, SyncRule::kFig9);
  PerAxis<Radians> last = plan.start;
  for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
    const auto now = position(plan, static_cast<double>(tick) * kTickSeconds);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double sign = plan.target[axis] < plan.start[axis] ? -1.0 : 1.0;
      ASSERT_GE(sign * (now[axis] - last[axis]).value(), -1e-15) << "tick " << tick << " axis " << axis + 1;
    }
    last = now;
  }
}

TEST(JointMove, SpeedScalesTheSpeedLimitsOnly) {
  const RobotModel robot = test::paper_robot();
  const JointPlan plan = plan_joint_move(robot, {}, degrees({80.4, 0, 0, 0, 0, 0}), 0.5, SyncRule::kFig9);
  EXPECT_NEAR(plan.profiles[0].peak_speed / test::kDeg, 60.0, 1e-6);
  EXPECT_NEAR(plan.profiles[0].accel / test::kDeg, 600.0, 1e-9);
  EXPECT_EQ(plan.duration, Ticks{28'800});  // 60/600 + 80.4/60 s
}

TEST(JointMove, ThePulseRateLimitsAFineDrive) {
  RobotModel robot = test::fine_robot();
  for (AxisModel& axis : robot.axes) axis.max_speed_rad_s *= 10.0;
  const JointPlan plan = plan_joint_move(robot, {}, degrees({90, -90, 90, -90, 90, -90}), 1.0, SyncRule::kFig9);
  for (const TrapezoidProfile& profile : plan.profiles) EXPECT_LE(profile.peak_speed / test::kDeg, 219.7265626);
}

TEST(JointMove, WithoutDistanceTakesNoTick) {
  const auto here = degrees({1, 2, 3, 4, 5, 6});
  const JointPlan plan = plan_joint_move(test::paper_robot(), here, here, 1.0, SyncRule::kFig9);
  EXPECT_EQ(plan.duration, Ticks{0});
  EXPECT_EQ(position(plan, 0.0), here);
}

}  // namespace
}  // namespace armature
