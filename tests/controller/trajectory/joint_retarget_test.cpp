#include "controller/trajectory/joint/joint_retarget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/joint/retarget_planner.hpp"
#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::degrees;

RobotModel robot_with_jerk() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * test::kDeg;
  robot.axes[2].max_jerk_rad_s3 = 2'500.0 * test::kDeg;
  return robot;
}

PerAxis<Radians> random_target(test::Random& random) {
  return make_per_axis([&](std::size_t) { return Radians{random.real(-1.5, 1.5)}; });
}

using SetPoints = std::vector<PerAxis<Radians>>;

// The largest differences of set-points, each over its limit.
struct Shares {
  double speed = 0.0, accel = 0.0, jerk = 0.0;
};
Shares shares_of(const RobotModel& robot, const SetPoints& points, std::size_t from = 3) {
  Shares shares;
  for (std::size_t k = std::max<std::size_t>(from, 3); k < points.size(); ++k) {
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      const auto q = [&](std::size_t back) { return points[k - back][axis].value(); };
      const AxisModel& model = robot.axes[axis];
      const double speed = std::fabs(q(0) - q(1)) / kTickSeconds;
      const double accel = std::fabs(q(0) - 2 * q(1) + q(2)) / (kTickSeconds * kTickSeconds);
      const double third = std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3));
      const double jerk = std::max(third - 4e-15, 0.0) / (kTickSeconds * kTickSeconds * kTickSeconds);
      shares.speed = std::max(shares.speed, speed / model.max_speed_rad_s);
      shares.accel = std::max(shares.accel, accel / model.max_accel_rad_s2);
      if (model.max_jerk_rad_s3 > 0.0) shares.jerk = std::max(shares.jerk, jerk / model.max_jerk_rad_s3);
    }
  }
  return shares;
}

class JointRetarget : public testing::TestWithParam<ProfileKind> {
 protected:
  const RobotModel robot = robot_with_jerk();
  const Arm arm{robot};
};

// One planner for all of them: nothing of the plan before may be left.
TEST_P(JointRetarget, InPartsItIsTheSamePlan) {
  test::Random random{22};
  RetargetPlanner planner{robot};
  int outside = 0;
  for (int draw = 0; draw < test::draws(500); ++draw) {
    SCOPED_TRACE("seed 22 draw " + std::to_string(draw));
    const auto state = make_per_axis([&](std::size_t) {
      return AxisState{.position = random.real(-3.05, 3.05), .velocity = random.real(-1.5, 1.5)};
    });
    const PerAxis<Radians> target = random_target(random);
    const double speed = random.real(0.1, 1.0);
    const RetargetPlan whole = plan_retarget(robot, state, target, speed, GetParam());
    planner.begin(state, {.target = target, .speed = speed, .kind = GetParam()});
    for (int part = 0; part < RetargetPlanner::kParts; ++part) {
      ASSERT_FALSE(planner.done());
      planner.step();
    }
    ASSERT_TRUE(planner.done());
    const RetargetPlan& plan = planner.plan();
    ASSERT_EQ(plan.duration, whole.duration);
    ASSERT_EQ(plan.target, target);
    ASSERT_EQ(plan.peak_speed_rad_s, whole.peak_speed_rad_s);
    ASSERT_EQ(plan.peak_accel_rad_s2, whole.peak_accel_rad_s2);
    for (const double share : {0.0, 0.3, 0.8, 1.0}) {
      const double t_s = share * seconds(plan.duration);
      ASSERT_EQ(position(plan, t_s), position(whole, t_s));
    }
    ASSERT_EQ(planner.outside(), axis_outside(whole, robot));
    outside += planner.outside() ? 1 : 0;
  }
  EXPECT_GT(outside, 0);
}

TEST_P(JointRetarget, FromRestItTakesTheTicksOfAJointMove) {
  test::Random random{21};
  for (int draw = 0; draw < test::draws(2'000); ++draw) {
    const PerAxis<Radians> start = random_target(random), target = random_target(random);
    const auto state = make_per_axis([&](std::size_t axis) { return AxisState{.position = start[axis].value()}; });
    const double speed = random.real(0.01, 1.0);
    const RetargetPlan plan = plan_retarget(robot, state, target, speed, GetParam());
    const JointPlan move = plan_joint_move(robot, start, target, speed, SyncRule::kFig9, GetParam());
    ASSERT_EQ(plan.duration, move.duration) << "seed 21 draw " << draw;
    ASSERT_EQ(position(plan, 0.0), start);
    ASSERT_EQ(position(plan, seconds(plan.duration)), target);
    ASSERT_FALSE(axis_outside(plan, robot));
  }
}

TEST_P(JointRetarget, FromAnyStateAllJointsKeepTheirLimitsAndEndTogetherWithTheSlowest) {
  test::Random random{22};
  for (int draw = 0; draw < test::draws(200); ++draw) {
    PerAxis<AxisState> start;
    const PerAxis<Radians> target = random_target(random);
    const double speed = random.integer(0, 1) == 0 ? 1.0 : random.real(0.3, 1.0);
    double slowest_s = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = robot.axes[axis];
      const double accel = random.real(-1.0, 1.0) * model.max_accel_rad_s2;
      // The acceleration may return to 0 before the speed exceeds its limit.
      const double room = speed * model.max_speed_rad_s - 0.5 * accel * accel / model.max_jerk_rad_s3;
      start[axis] = {.position = random.real(-1.5, 1.5), .velocity = random.real(-1.0, 1.0) * std::max(room, 0.0)};
      if (room > 0.0) start[axis].accel = accel;
      const TimeLawLimits limits{
          .speed = speed * model.max_speed_rad_s, .accel = model.max_accel_rad_s2, .jerk = model.max_jerk_rad_s3};
      slowest_s = std::max(slowest_s, AxisReach{GetParam(), start[axis], limits}.shortest_s(target[axis].value()));
    }
    const RetargetPlan plan = plan_retarget(robot, start, target, speed, GetParam());
    ASSERT_GE(seconds(plan.duration) + 1e-6 * kTickSeconds, slowest_s);
    ASSERT_LT(seconds(plan.duration), slowest_s + kTickSeconds) << "seed 22 draw " << draw;
    SetPoints points;
    for (std::int64_t tick = 0; tick <= plan.duration.value() + 3; ++tick) {
      points.push_back(position(plan, seconds(Ticks{tick})));
    }
    ASSERT_EQ(points[points.size() - 4], target) << "seed 22 draw " << draw;
    const Shares shares = shares_of(robot, points);
    ASSERT_LE(shares.speed, speed * (1.0 + 1e-5)) << "seed 22 draw " << draw;
    ASSERT_LE(shares.accel, 1.0 + 1e-5) << "seed 22 draw " << draw;
    if (GetParam() == ProfileKind::kSCurve) {
      ASSERT_LE(shares.jerk, 1.0 + 1e-3) << "seed 22 draw " << draw;
    }
  }
}

// Runs a move, and gives it a new target in motion, several times.
TEST_P(JointRetarget, ANewTargetInMotionKeepsTheLimitsAcrossTheChange) {
  test::Random random{23};
  for (int draw = 0; draw < test::draws(40); ++draw) {
    test::KeepingSampler sampler{robot, arm, {}};
    SetPoints points(3);
    sampler.start(plan_joint_move(robot, {}, random_target(random), 1.0, SyncRule::kFig9, GetParam()), 1.0);
    PerAxis<Radians> target{};
    for (int change = 0; change < 3; ++change) {
      for (auto ticks = random.integer(1, 6'000); ticks > 0; --ticks) points.push_back(sampler.advance(1.0));
      target = random_target(random);
      sampler.start(plan_retarget(robot, sampler.state(), target, 1.0, GetParam()));
    }
    while (sampler.busy()) points.push_back(sampler.advance(1.0));
    points.insert(points.end(), 3, sampler.advance(1.0));
    ASSERT_EQ(points.back(), target);
    const Shares shares = shares_of(robot, points);
    ASSERT_LE(shares.speed, 1.0 + 1e-4) << "seed 23 draw " << draw;
    ASSERT_LE(shares.accel, 1.0 + 1e-4) << "seed 23 draw " << draw;
    if (GetParam() == ProfileKind::kSCurve) {
      ASSERT_LE(shares.jerk, 1.0 + 2e-3) << "seed 23 draw " << draw;
    }
  }
}

// The state is then known from the set-points only.
TEST_P(JointRetarget, ANewTargetWhileTheRateChangesKeepsTheAccelerations) {
  test::Random random{25};
  for (int draw = 0; draw < test::draws(40); ++draw) {
    test::KeepingSampler sampler{robot, arm, {}};
    SetPoints points(3);
    sampler.start(plan_joint_move(robot, {}, random_target(random), 1.0, SyncRule::kFig9, GetParam()), 1.0);
    for (auto ticks = random.integer(1, 6'000); ticks > 0; --ticks) points.push_back(sampler.advance(1.0));
    for (auto ticks = random.integer(1, 300); ticks > 0; --ticks) points.push_back(sampler.advance(0.2));
    const PerAxis<Radians> target = random_target(random);
    sampler.start(plan_retarget(robot, sampler.state(), target, 1.0, GetParam()));
    while (sampler.busy()) points.push_back(sampler.advance(1.0));
    points.insert(points.end(), 3, sampler.position());
    ASSERT_EQ(points.back(), target);
    const Shares shares = shares_of(robot, points);
    ASSERT_LE(shares.speed, 1.0 + 1e-3) << "seed 25 draw " << draw;
    ASSERT_LE(shares.accel, 1.0 + 1e-3) << "seed 25 draw " << draw;
  }
}

TEST_P(JointRetarget, AnOverrideAHoldAndAStopKeepTheAccelerations) {
  test::Random random{24};
  for (int draw = 0; draw < test::draws(40); ++draw) {
    test::KeepingSampler sampler{robot, arm, {}};
    SetPoints points(3);
    sampler.start(plan_joint_move(robot, {}, random_target(random), 1.0, SyncRule::kFig9, GetParam()), 1.0);
    for (auto ticks = random.integer(1, 6'000); ticks > 0; --ticks) points.push_back(sampler.advance(1.0));
    const PerAxis<Radians> target = random_target(random);
    sampler.start(plan_retarget(robot, sampler.state(), target, 1.0, GetParam()));
    for (auto ticks = random.integer(1, 6'000); ticks > 0; --ticks) points.push_back(sampler.advance(0.5));
    for (int ticks = 0; ticks < 5'000; ++ticks) points.push_back(sampler.advance(0.0));
    for (auto ticks = random.integer(1, 6'000); ticks > 0; --ticks) points.push_back(sampler.advance(1.0));
    const bool stops = random.integer(0, 1) == 0;
    if (GetParam() == ProfileKind::kSCurve) {
      ASSERT_LE(shares_of(robot, points).jerk, 2.0 + 2e-3) << "seed 24 draw " << draw;
    }
    for (int ticks = 0; ticks < 200'000 && sampler.busy(); ++ticks) {
      points.push_back(stops ? sampler.brake() : sampler.advance(1.0));
      if (stops && sampler.rate() == 0.0) break;
    }
    points.insert(points.end(), 3, sampler.position());
    if (!stops) {
      ASSERT_EQ(points.back(), target);
    }
    const Shares shares = shares_of(robot, points);
    ASSERT_LE(shares.speed, 1.0 + 1e-4) << "seed 24 draw " << draw;
    ASSERT_LE(shares.accel, 1.0 + 1e-3) << "seed 24 draw " << draw;
  }
}

TEST_P(JointRetarget, AnAxisWithoutADriveStaysWhereItIs) {
  RobotModel five = robot;
  five.axis_count = 5;
  five.axes[5] = {};
  PerAxis<AxisState> start{};
  start[0] = {.position = 0.1, .velocity = 1.0};
  const auto target = degrees({10, -20, 30, -40, 50, 0});
  const RetargetPlan plan = plan_retarget(five, start, target, 1.0, GetParam());
  EXPECT_GT(plan.duration, Ticks{0});
  EXPECT_LT(plan.duration, Ticks{40'000});
  for (std::int64_t tick = 0; tick <= plan.duration.value(); tick += 10) {
    ASSERT_EQ(position(plan, seconds(Ticks{tick}))[5], Radians{0.0});
  }
}

TEST_P(JointRetarget, NamesTheAxisThatCannotStopBeforeItsLimit) {
  PerAxis<AxisState> start{};
  start[1] = {.position = robot.axes[1].max_rad - 0.05, .velocity = robot.axes[1].max_speed_rad_s};
  start[3] = {.position = robot.axes[3].min_rad + 0.01, .velocity = -robot.axes[3].max_speed_rad_s};
  RetargetPlan plan = plan_retarget(robot, start, {}, 1.0, GetParam());
  EXPECT_EQ(axis_outside(plan, robot), 3u);
  start[3].velocity = 0.0;
  EXPECT_EQ(axis_outside(plan_retarget(robot, start, {}, 1.0, GetParam()), robot), 1u);
  start[1].velocity = -start[1].velocity;
  EXPECT_FALSE(axis_outside(plan_retarget(robot, start, {}, 1.0, GetParam()), robot));
}

TEST_P(JointRetarget, TooSlowAMoveIsLongerThanTheLongestOne) {
  PerAxis<AxisState> start{};
  const auto target = degrees(test::kFigure9Deg);
  EXPECT_GT(plan_retarget(robot, start, target, 1e-9, GetParam()).duration, kLongestMove);
  EXPECT_GT(plan_retarget(robot, start, target, 1e-300, GetParam()).duration, kLongestMove);
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointRetarget, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& kind) {
                           return std::string{kind.param == ProfileKind::kSCurve ? "Scurve" : "Trapezoid"};
                         });

TEST(StateAfter, IsThatOfConstantAccelerationThroughThreePositions) {
  const AxisState state = state_after(1.0, 0.7, 0.5, 0.1);
  EXPECT_DOUBLE_EQ(state.position, 1.0);
  EXPECT_DOUBLE_EQ(after(state, 0.0, -0.1).position, 0.7);
  EXPECT_DOUBLE_EQ(after(state, 0.0, -0.2).position, 0.5);
}

}  // namespace
}  // namespace armature
