#include "controller/trajectory/joint/joint_move.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

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
  EXPECT_NEAR(plan.profiles[0].trapezoid.peak_speed / test::kDeg, 60.0, 1e-6);
  EXPECT_NEAR(plan.profiles[0].trapezoid.accel / test::kDeg, 600.0, 1e-9);
  EXPECT_EQ(plan.duration, Ticks{28'800});  // 60/600 + 80.4/60 s
}

TEST(JointMove, ThePulseRateLimitsAFineDrive) {
  RobotModel robot = test::fine_robot();
  for (AxisModel& axis : robot.axes) axis.max_speed_rad_s *= 10.0;
  const JointPlan plan = plan_joint_move(robot, {}, degrees({90, -90, 90, -90, 90, -90}), 1.0, SyncRule::kFig9);
  for (const TimeLaw& profile : plan.profiles) EXPECT_LE(profile.peak_speed() / test::kDeg, 219.7265626);
}

RobotModel smooth_robot() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * test::kDeg;
  robot.axes[2].max_jerk_rad_s3 = 2'500.0 * test::kDeg;
  return robot;
}

TEST(JointMove, AsScurvesAllJointsKeepTheirLimitsAndEndTogetherWithTheSlowest) {
  const RobotModel robot = smooth_robot();
  test::Random random{7};
  for (int draw = 0; draw < 2'000; ++draw) {
    PerAxis<Radians> start, target;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      start[axis] = Radians{random.real(-2.9, 2.9)};
      target[axis] = random.integer(0, 4) == 0 ? start[axis] : start[axis] + Radians{random.real(-1.0, 1.0)};
    }
    const double speed = random.real(0.01, 1.0);
    const JointPlan plan = plan_joint_move(robot, start, target, speed, SyncRule::kFig9, ProfileKind::kSCurve);
    const double end_s = static_cast<double>(plan.duration.value()) * kTickSeconds;
    // A millionth of a tick is forgiven.
    const double slack = 1.0 + 1e-13 + 6e-6 / static_cast<double>(plan.duration.value());
    double slowest_s = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = robot.axes[axis];
      const TimeLaw& law = plan.profiles[axis];
      const double distance = (target[axis] - start[axis]).value();
      const TimeLawLimits limits{
          .speed = speed * model.max_speed_rad_s, .accel = model.max_accel_rad_s2, .jerk = model.max_jerk_rad_s3};
      const TimeLaw fastest = plan_time_law(ProfileKind::kSCurve, distance, limits);
      ASSERT_EQ(law.duration_s(), end_s) << "seed 7 draw " << draw << " axis " << axis + 1;
      ASSERT_EQ(law.shape(), fastest.shape());
      ASSERT_LE(law.peak_speed(), limits.speed * slack) << "seed 7 draw " << draw << " axis " << axis + 1;
      ASSERT_LE(law.peak_accel(), limits.accel * slack) << "seed 7 draw " << draw << " axis " << axis + 1;
      ASSERT_LE(law.scurve.jerk, limits.jerk * slack) << "seed 7 draw " << draw << " axis " << axis + 1;
      slowest_s = std::fmax(slowest_s, fastest.duration_s());
    }
    ASSERT_EQ(plan.duration, whole_ticks(slowest_s)) << "seed 7 draw " << draw;
    ASSERT_EQ(position(plan, 0.0), start);
    ASSERT_EQ(position(plan, end_s), target);  // bit for bit
  }
}

TEST(JointMove, AsScurvesItIsMonotonicAndSmoothFromTickToTick) {
  const RobotModel robot = smooth_robot();
  const JointPlan plan =
      plan_joint_move(robot, {}, degrees(test::kFigure9Deg), 1.0, SyncRule::kFig9, ProfileKind::kSCurve);
  for (std::int64_t tick = 0; tick <= plan.duration.value() + 3; ++tick) {
    const auto at = [&](std::int64_t k) { return position(plan, static_cast<double>(k) * kTickSeconds); };
    const auto q0 = at(tick - 3), q1 = at(tick - 2), q2 = at(tick - 1), q3 = at(tick);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double sign = plan.target[axis] < plan.start[axis] ? -1.0 : 1.0;
      ASSERT_GE(sign * (q3[axis] - q2[axis]).value(), -1e-15) << "tick " << tick << " axis " << axis + 1;
      const double third = q3[axis].value() - 3.0 * q2[axis].value() + 3.0 * q1[axis].value() - q0[axis].value();
      const double jerk = std::fabs(third) / (kTickSeconds * kTickSeconds * kTickSeconds);
      const double rounding = 3e-15 / (kTickSeconds * kTickSeconds * kTickSeconds);
      ASSERT_LE(jerk, robot.axes[axis].max_jerk_rad_s3 * 1.001 + rounding) << "tick " << tick << " axis " << axis + 1;
    }
  }
}

TEST(JointMove, AxesWithoutADriveNeedNoLimits) {
  RobotModel robot = smooth_robot();
  robot.axis_count = 5;
  robot.axes[5] = {};
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    const auto target = degrees({10, -20, 30, -40, 50, 0});
    const JointPlan plan = plan_joint_move(robot, {}, target, 1.0, SyncRule::kFig9, kind);
    EXPECT_GT(plan.duration, Ticks{0});
    EXPECT_LT(plan.duration, Ticks{40'000});
    EXPECT_EQ(plan.profiles[5].shape(), ProfileShape::kNone);
    for (std::int64_t tick = 0; tick <= plan.duration.value(); tick += 10) {
      ASSERT_EQ(position(plan, static_cast<double>(tick) * kTickSeconds)[5], Radians{0.0});
    }
  }
}

TEST(JointMove, AsScurvesTooSlowAMoveSaturatesItsDuration) {
  const RobotModel robot = smooth_robot();
  Ticks faster{0};
  for (double speed = 1.0; speed > 0.0; speed *= 0.5) {
    const JointPlan plan =
        plan_joint_move(robot, {}, degrees(test::kFigure9Deg), speed, SyncRule::kFig9, ProfileKind::kSCurve);
    ASSERT_GE(plan.duration, faster) << speed;
    faster = plan.duration;
  }
  EXPECT_GT(faster, kLongestMove);
}

TEST(JointMove, WithoutDistanceTakesNoTick) {
  const auto here = degrees({1, 2, 3, 4, 5, 6});
  const JointPlan plan = plan_joint_move(test::paper_robot(), here, here, 1.0, SyncRule::kFig9);
  EXPECT_EQ(plan.duration, Ticks{0});
  EXPECT_EQ(position(plan, 0.0), here);
  EXPECT_EQ(plan_joint_move({}, here, here, 1.0, SyncRule::kFig9, ProfileKind::kSCurve).duration, Ticks{0});
}

}  // namespace
}  // namespace armature
