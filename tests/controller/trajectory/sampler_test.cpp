#include "controller/trajectory/run/sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::degrees;

class SamplerTest : public testing::Test {
 protected:
  const RobotModel robot = test::paper_robot();
  const Arm arm{robot};

  JointPlan plan_to(const PerAxis<double>& target_deg, double speed = 1.0) const {
    return plan_joint_move(robot, {}, degrees(target_deg), speed, SyncRule::kFig9);
  }
};

TEST_F(SamplerTest, HoldsItsPosition) {
  test::KeepingSampler sampler{robot, arm, degrees({1, 2, 3, 4, 5, 6})};
  EXPECT_FALSE(sampler.busy());
  EXPECT_EQ(sampler.advance(1.0), degrees({1, 2, 3, 4, 5, 6}));
  sampler.reset_to(degrees({6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(sampler.advance(1.0), degrees({6, 5, 4, 3, 2, 1}));
}

TEST_F(SamplerTest, GivesOneSetPointPerTickAndEndsExactly) {
  const JointPlan plan = plan_to(test::kFigure9Deg);
  test::KeepingSampler sampler{robot, arm, {}};
  sampler.start(plan, 1.0);
  for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
    ASSERT_TRUE(sampler.busy());
    ASSERT_EQ(sampler.advance(1.0), position(plan, static_cast<double>(tick) * kTickSeconds));
  }
  EXPECT_FALSE(sampler.busy());
  EXPECT_EQ(sampler.position(), degrees(test::kFigure9Deg));
}

TEST_F(SamplerTest, AMoveWithoutDistanceEndsAtOnce) {
  test::KeepingSampler sampler{robot, arm, {}};
  sampler.start(plan_to({}), 1.0);
  EXPECT_FALSE(sampler.busy());
  EXPECT_EQ(sampler.advance(1.0), (PerAxis<Radians>{}));
}

struct StopRun {
  std::vector<PerAxis<Radians>> path;  // all set-points from the start of the move
  std::size_t stop_at = 0;             // index of the last set-point before the stop
};

StopRun stop_after(const RobotModel& robot, const JointPlan& plan, std::int64_t ticks) {
  const Arm arm{robot};
  test::KeepingSampler sampler{robot, arm, plan.start};
  StopRun run{.path = {plan.start}};
  sampler.start(plan, 1.0);
  for (std::int64_t i = 0; i < ticks; ++i) run.path.push_back(sampler.advance(1.0));
  run.stop_at = run.path.size() - 1;
  for (int i = 0; i < 100'000; ++i) {
    run.path.push_back(sampler.advance(0.0));
    if (sampler.rate() == 0.0) break;
  }
  EXPECT_EQ(sampler.rate(), 0.0);
  run.path.push_back(sampler.advance(0.0));
  EXPECT_EQ(run.path.back(), run.path[run.path.size() - 2]) << "moves after the stop";
  return run;
}

double second_difference(const StopRun& run, std::size_t i, std::size_t axis) {
  const double bend =
      (run.path[i + 1][axis] - run.path[i][axis]).value() - (run.path[i][axis] - run.path[i - 1][axis]).value();
  return bend / (kTickSeconds * kTickSeconds);
}

TEST_F(SamplerTest, StopsWithinEveryJointsAccelerationWhereverItHappens) {
  const JointPlan plan = plan_to(test::kFigure9Deg);
  for (const std::int64_t at : {0, 1, 2, 100, 2'000, 3'999, 4'000, 4'001, 8'700, 13'399, 13'400, 15'000, 17'399}) {
    const StopRun run = stop_after(robot, plan, at);
    for (std::size_t i = std::max<std::size_t>(1, run.stop_at); i + 1 < run.path.size(); ++i) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        ASSERT_LE(std::fabs(second_difference(run, i, axis)), robot.axes[axis].max_accel_rad_s2 * 1.001)
            << "stopped after " << at << ", tick " << i << ", axis " << axis + 1;
      }
    }
  }
}

TEST_F(SamplerTest, StopsAsSoonAsTheLimitingJointCan) {
  // Alone in its cruise a joint brakes with its full acceleration: v^2 / 2a, and v / a.
  const JointPlan plan = plan_to({80.4, 0, 0, 0, 0, 0});
  const StopRun run = stop_after(robot, plan, 8'700);
  const double way_deg = (run.path.back()[0] - run.path[run.stop_at][0]).value() / test::kDeg;
  EXPECT_NEAR(way_deg, 120.0 * 120.0 / (2.0 * 600.0), 0.01);
  EXPECT_NEAR(static_cast<double>(run.path.size() - run.stop_at), 120.0 / 600.0 / kTickSeconds, 5.0);
}

TEST_F(SamplerTest, StopsOnThePath) {
  test::Random random{7};
  const JointPlan plan = plan_to(test::kFigure9Deg);
  for (int draw = 0; draw < test::draws(50); ++draw) {
    const StopRun run = stop_after(robot, plan, random.integer(0, 17'399));
    // Joint 1 tells how far along the path; the others must be where the plan has them then.
    for (std::size_t i = run.stop_at; i < run.path.size(); i += 97) {
      double low_s = 0.0, high_s = 0.87;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle_s = 0.5 * (low_s + high_s);
        (position(plan, middle_s)[0] < run.path[i][0] ? low_s : high_s) = middle_s;
      }
      const auto planned = position(plan, high_s);
      for (std::size_t axis = 1; axis < kAxes; ++axis) {
        // Within a nanosecond-ish of path time: the path is flat at its ends.
        ASSERT_NEAR(planned[axis].value(), run.path[i][axis].value(), 2e-7) << "axis " << axis + 1;
      }
    }
  }
}

TEST_F(SamplerTest, NeverTurnsBackNorPassesTheTarget) {
  const JointPlan plan = plan_to(test::kFigure9Deg);
  for (std::int64_t at = 0; at < 17'400; at += 311) {
    const StopRun run = stop_after(robot, plan, at);
    for (std::size_t i = run.stop_at; i + 1 < run.path.size(); ++i) {
      ASSERT_GE(run.path[i + 1][0], run.path[i][0]);
      ASSERT_LE(run.path[i + 1][1], run.path[i][1]);
      ASSERT_LE(run.path[i + 1][0], plan.target[0]);
    }
  }
}

TEST_F(SamplerTest, AStopWhileStandingChangesNothing) {
  test::KeepingSampler sampler{robot, arm, degrees({1, 2, 3, 4, 5, 6})};
  EXPECT_EQ(sampler.advance(0.0), degrees({1, 2, 3, 4, 5, 6}));
  EXPECT_FALSE(sampler.busy());
  EXPECT_EQ(sampler.rate(), 0.0);
}

TEST_F(SamplerTest, AMoveAfterAStopRunsAtFullRate) {
  test::KeepingSampler sampler{robot, arm, {}};
  sampler.start(plan_to(test::kFigure9Deg), 1.0);
  for (int i = 0; i < 5'000; ++i) (void)sampler.advance(1.0);
  do {
    (void)sampler.advance(0.0);
  } while (sampler.rate() > 0.0);
  EXPECT_TRUE(sampler.busy());  // could go on
  sampler.reset_to(sampler.position());
  const JointPlan back = plan_joint_move(robot, sampler.position(), {}, 1.0, SyncRule::kFig9);
  sampler.start(back, 1.0);
  std::int64_t ticks = 0;
  for (; sampler.busy(); ++ticks) (void)sampler.advance(1.0);
  EXPECT_EQ(ticks, back.duration.value());
  EXPECT_EQ(sampler.position(), (PerAxis<Radians>{}));
}

// Any number of changes of the rate at any time: the set-points stay on the plan, never turn back, keep the limits at
// 100 %, and end exactly at the target.
TEST_F(SamplerTest, HoldsAndOverridesAtAnyTimeKeepPathAndLimits) {
  constexpr std::uint64_t kSeed = 23;
  test::Random random{kSeed};
  RobotModel jerky = test::paper_robot();
  for (AxisModel& axis : jerky.axes) axis.max_jerk_rad_s3 = 200.0;
  for (int draw = 0; draw < test::draws(40); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PerAxis<double> target_deg;
    for (double& target : target_deg) target = random.integer(0, 4) == 0 ? 0.0 : random.real(-25.0, 25.0);
    const auto rule = static_cast<SyncRule>(random.integer(0, 2));
    const auto profile = random.integer(0, 2) == 0 ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
    const JointPlan plan = plan_joint_move(jerky, {}, degrees(target_deg), random.real(0.2, 1.0), rule, profile);
    double wanted = random.integer(0, 1) == 0 ? 1.0 : random.real(0.01, 1.0);
    test::KeepingSampler sampler{jerky, arm, {}};
    sampler.start(plan, wanted);
    std::vector<PerAxis<Radians>> points{{}, {}};
    double elapsed = 0.0;
    for (std::int64_t tick = 0, change = random.integer(0, 900); sampler.busy(); ++tick) {
      if (tick == change) {
        const double choices[] = {0.0, 0.01, 1.0, random.real(0.01, 1.0)};
        wanted = choices[random.integer(0, 3)];
        change += random.integer(1, 900);
        if (tick > 20'000) wanted = 1.0;
      }
      points.push_back(sampler.advance(wanted));
      ASSERT_GE(sampler.elapsed(), elapsed);
      ASSERT_LE(sampler.elapsed(), elapsed + 1.0);
      elapsed = sampler.elapsed();
      const auto planned = position(plan, elapsed * kTickSeconds);
      const std::size_t k = points.size() - 1;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        ASSERT_NEAR(points[k][axis].value(), planned[axis].value(), 1e-10) << "axis " << axis + 1;
        const double step = (points[k][axis] - points[k - 1][axis]).value();
        const double bend = step - (points[k - 1][axis] - points[k - 2][axis]).value();
        ASSERT_LE(std::fabs(step) / kTickSeconds, robot.axes[axis].max_speed_rad_s * (1.0 + 2e-6));
        ASSERT_LE(std::fabs(bend) / (kTickSeconds * kTickSeconds), robot.axes[axis].max_accel_rad_s2 * (1.0 + 2e-6))
            << "axis " << axis + 1 << ", tick " << tick << ", rate " << sampler.rate();
      }
      ASSERT_LT(tick, 100'000) << "does not end";
    }
    EXPECT_EQ(sampler.position(), degrees(target_deg));
  }
}

TEST_F(SamplerTest, SCurvesOfJointsKeepTwiceTheirJerkWhileTheRateChanges) {
  constexpr std::uint64_t kSeed = 24;
  test::Random random{kSeed};
  RobotModel jerky = test::paper_robot();
  for (AxisModel& axis : jerky.axes) axis.max_jerk_rad_s3 = 200.0;
  double most = 0.0;
  for (int draw = 0; draw < test::draws(30); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    PerAxis<double> target_deg;
    for (double& target : target_deg) target = random.real(-40.0, 40.0);
    const JointPlan plan =
        plan_joint_move(jerky, {}, degrees(target_deg), random.real(0.2, 1.0), SyncRule::kFig9, ProfileKind::kSCurve);
    test::KeepingSampler sampler{jerky, arm, {}};
    sampler.start(plan, 1.0);
    std::vector<PerAxis<Radians>> q(3);
    double wanted = 1.0;
    for (std::int64_t tick = 0, change = random.integer(0, 9'000); sampler.busy(); ++tick) {
      if (tick == change) {
        wanted = tick > 40'000 ? 1.0 : random.integer(0, 1) == 0 ? 0.0 : random.real(0.05, 1.0);
        change += random.integer(1, 6'000);
      }
      q.push_back(sampler.advance(wanted));
      const std::size_t k = q.size() - 1;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double change_of_bend = (q[k][axis] - q[k - 1][axis]).value() -
                                      2.0 * (q[k - 1][axis] - q[k - 2][axis]).value() +
                                      (q[k - 2][axis] - q[k - 3][axis]).value();
        most = std::max(most, std::fabs(change_of_bend) / (kTickSeconds * kTickSeconds * kTickSeconds) / 200.0);
      }
      ASSERT_LT(tick, 200'000) << "does not end";
    }
  }
  EXPECT_LE(most, 2.0 * 1.001);
  EXPECT_GT(most, 1.0);
}

TEST_F(SamplerTest, AMoveThatBeginsUnderAnOverrideHasItsRateFromTheFirstTick) {
  const JointPlan plan = plan_to(test::kFigure9Deg);
  test::KeepingSampler sampler{robot, arm, {}};
  sampler.start(plan, 0.25);
  std::int64_t ticks = 0;
  for (; sampler.busy(); ++ticks) (void)sampler.advance(0.25);
  EXPECT_EQ(ticks, 4 * plan.duration.value());
  EXPECT_EQ(sampler.inverses(), 0);  // joint plans have none
}

}  // namespace
}  // namespace armature
