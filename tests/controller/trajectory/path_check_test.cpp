#include "controller/trajectory/plan/path_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/core/timebase.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

constexpr double kTs = kTickSeconds;

// Segments of these lengths in ticks, the next one beginning `overlap` ticks early. Only their times matter here.
CartesianPlan schedule(const std::vector<std::int64_t>& ticks, std::int64_t overlap = 0,
                       ProfileKind kind = ProfileKind::kSCurve) {
  CartesianPlan plan;
  std::int64_t end = 0;
  for (const std::int64_t duration : ticks) {
    CartesianSegment& segment = plan.segments[plan.count++];
    segment.start = Ticks{end - (plan.count > 1 ? overlap : 0)};
    segment.duration = Ticks{duration};
    segment.profile = kind;
    end = segment.start.value() + duration;
  }
  plan.duration = Ticks{end};
  return plan;
}

// Feeds joint `axis` with positions, tick by tick.
PathCheck::PerSegment check(const RobotModel& robot, const CartesianPlan& plan, std::size_t axis,
                            const std::vector<double>& rad) {
  PathCheck path_check{robot};
  path_check.begin({}, {});
  for (const double q : rad) {
    JointAngles joints{};
    joints[axis] = Radians{q};
    path_check.add(plan, joints, {});
  }
  path_check.finish(plan);
  return path_check.excess(plan);
}

// One limit of one joint only.
RobotModel robot_with(double speed, double accel, double jerk) {
  RobotModel robot = test::irb120();
  for (AxisModel& model : robot.axes) {
    model.max_speed_rad_s = speed;
    model.max_accel_rad_s2 = accel;
    model.max_jerk_rad_s3 = jerk;
  }
  return robot;
}

TEST(PathCheck, RatesAreMeasuredOverTicksAndAskForTheirRoot) {
  const CartesianPlan plan = schedule({10});
  // A single step of `h` to and fro at tick 5: differences h; 2 h; 3 h.
  const double h = 1e-3;
  std::vector<double> pulse(10, 0.0);
  pulse[4] = h;
  const auto speed = check(robot_with(h / kTs / 4.0, 1e99, 1e99), plan, 2, pulse);
  EXPECT_NEAR(speed[0].stretch, 4.0 / PathCheck::kCheckedShare, 1e-9);
  EXPECT_EQ(speed[0].axis, 3);
  EXPECT_EQ(speed[0].tick, Ticks{5});
  const auto accel = check(robot_with(1e99, 2.0 * h / (kTs * kTs) / 9.0, 1e99), plan, 5, pulse);
  EXPECT_NEAR(accel[0].stretch, 3.0 / std::sqrt(PathCheck::kCheckedShare), 1e-9);
  EXPECT_EQ(accel[0].axis, 6);
  EXPECT_EQ(accel[0].tick, Ticks{6});
  const auto jerk = check(robot_with(1e99, 1e99, 3.0 * h / (kTs * kTs * kTs) / 8.0), plan, 0, pulse);
  EXPECT_NEAR(jerk[0].stretch, 2.0 / std::cbrt(PathCheck::kCheckedShare), 1e-9);
  EXPECT_EQ(jerk[0].axis, 1);
}

TEST(PathCheck, KeepsAMarginForSetPointsBetweenTicks) {
  const CartesianPlan plan = schedule({10});
  std::vector<double> ramp;
  for (int tick = 1; tick <= 10; ++tick) ramp.push_back(1e-4 * tick);
  EXPECT_EQ(check(robot_with(1e-4 / kTs * 1.03, 1e99, 1e99), plan, 0, ramp)[0].stretch, 1.0);
  EXPECT_GT(check(robot_with(1e-4 / kTs * 1.005, 1e99, 1e99), plan, 0, ramp)[0].stretch, 1.0);
}

TEST(PathCheck, TheRestBeforeAndAfterCounts) {
  const CartesianPlan plan = schedule({10});
  std::vector<double> ramp;
  for (int tick = 1; tick <= 10; ++tick) ramp.push_back(1e-4 * tick);
  const auto excess = check(robot_with(1e99, 1e-4 / (kTs * kTs) / 4.0, 1e99), plan, 0, ramp);
  EXPECT_NEAR(excess[0].stretch, 2.0 / std::sqrt(PathCheck::kCheckedShare), 1e-9);
  std::vector<double> late(9, 0.0);
  late.push_back(1e-4);  // at speed in the last tick
  const auto stop = check(robot_with(1e99, 1e-4 / (kTs * kTs) / 4.0, 1e99), plan, 0, late);
  EXPECT_GT(stop[0].stretch, 1.9);
}

TEST(PathCheck, JerkOfTrapezoidsAndOfAxesWithoutALimitIsFree) {
  std::vector<double> pulse(10, 0.0);
  pulse[4] = 1e-3;
  EXPECT_GT(check(robot_with(1e99, 1e99, 1.0), schedule({10}), 0, pulse)[0].stretch, 1.0);
  EXPECT_EQ(check(robot_with(1e99, 1e99, 1.0), schedule({10}, 0, ProfileKind::kTrapezoid), 0, pulse)[0].stretch, 1.0);
  EXPECT_EQ(check(robot_with(1e99, 1e99, 0.0), schedule({10}), 0, pulse)[0].stretch, 1.0);
}

TEST(PathCheck, AxesThatTheArmHasNotAreNotLookedAt) {
  RobotModel robot = robot_with(1.0, 1.0, 1.0);
  robot.axis_count = 5;
  robot.axes[5] = {};
  const auto excess = check(robot, schedule({10}), 0, std::vector<double>(10, 0.0));
  EXPECT_EQ(excess[0].stretch, 1.0);
}

TEST(PathCheck, ASegmentIsSlowedDownForWhatHappensWithinIt) {
  const CartesianPlan plan = schedule({10, 0, 10, 10});
  for (std::size_t guilty = 0; guilty < 4; ++guilty) {
    if (guilty == 1) continue;  // has no ticks
    std::vector<double> q(30, 0.0);
    q[(guilty == 0 ? 0 : guilty - 1) * 10 + 4] = 1e-3;
    const auto excess = check(robot_with(1.0, 1e99, 1e99), plan, 0, q);
    for (std::size_t i = 0; i < plan.count; ++i) {
      EXPECT_EQ(excess[i].stretch > 1.0, i == guilty) << i << " " << guilty;
    }
  }
}

TEST(PathCheck, BothSidesOfACornerAreSlowedDownOnlyWhenNeitherIsToBlameAlone) {
  for (const std::int64_t overlap : {0, 4}) {
    const CartesianPlan plan = schedule({10, 10}, overlap);
    const auto ticks = static_cast<std::size_t>(plan.duration.value());
    // Up to speed gently, and a stop in the corner that is too sharp: of both.
    const std::size_t corner = overlap == 0 ? 10 : 9;
    std::vector<double> kink(ticks);
    double q = 0.0;
    for (std::size_t k = 0; k < ticks; ++k) {
      if (k < corner) q += 0.2e-5 * static_cast<double>(std::min<std::size_t>(k + 1, 5));
      kink[k] = q;
    }
    const RobotModel robot = robot_with(1e99, 0.5e-5 / (kTs * kTs), 1e99);
    EXPECT_GT(check(robot, plan, 0, kink)[0].stretch, 1.0);
    EXPECT_EQ(check(robot, plan, 0, kink)[0].stretch, check(robot, plan, 0, kink)[1].stretch);
    kink[ticks - 2] += 1e-3;  // and another one within the second
    EXPECT_EQ(check(robot, plan, 0, kink)[0].stretch, 1.0);
    EXPECT_GT(check(robot, plan, 0, kink)[1].stretch, 1.0);
  }
}

TEST(PathCheck, TheToolIsCheckedWhereSegmentsOverlapAgainstTheLargerLimits) {
  const PathLimits wide{.speed_mm_s = 1e9, .accel_mm_s2 = 1e9, .turn_speed_rad_s = 1e9, .turn_accel_rad_s2 = 1e9};
  const RobotModel robot = robot_with(1e99, 1e99, 1e99);
  const auto run = [&](std::int64_t overlap, double PathLimits::*limit, double value) {
    CartesianPlan plan = schedule({10, 10}, overlap);
    plan.segments[0].limits = plan.segments[1].limits = wide;
    plan.segments[0].limits.*limit = value;
    plan.segments[1].limits.*limit = 0.5 * value;
    PathCheck path_check{robot};
    path_check.begin({}, {});
    for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
      ToolSample sample;  // jumps within the overlap by 1 mm and by 1e-3 rad
      if (tick >= 8) {
        sample.tool.base_T_tool = test::turned_by(test::moved({}, 0.6, 0.8, 0), 1e-3, {1, 2, 3});
        sample.rotation = sample.tool.base_T_tool.rotation;
      }
      path_check.add(plan, {}, sample);
    }
    path_check.finish(plan);
    return path_check.excess(plan);
  };
  const double tolerance = 1.0 + PathCheck::kToolTolerance;
  EXPECT_EQ(run(4, &PathLimits::speed_mm_s, 1.01 / kTs)[0].stretch, 1.0);
  EXPECT_NEAR(run(4, &PathLimits::speed_mm_s, 0.5 / kTs)[1].stretch, 2.0 / tolerance, 1e-9);
  EXPECT_EQ(run(4, &PathLimits::speed_mm_s, 0.5 / kTs)[0].axis, 0);
  EXPECT_NEAR(run(4, &PathLimits::accel_mm_s2, 0.25 / (kTs * kTs))[0].stretch, 2.0 / std::sqrt(tolerance), 1e-9);
  EXPECT_NEAR(run(4, &PathLimits::turn_speed_rad_s, 0.5e-3 / kTs)[0].stretch, 2.0 / tolerance, 1e-6);
  EXPECT_NEAR(run(4, &PathLimits::turn_accel_rad_s2, 0.25e-3 / (kTs * kTs))[1].stretch, 2.0 / std::sqrt(tolerance),
              1e-6);
  EXPECT_EQ(run(0, &PathLimits::speed_mm_s, 0.5 / kTs)[0].stretch, 1.0);  // a law by itself keeps its limits
}

TEST(PathCheck, WhatOnlyThreeSegmentsTogetherDoSlowsAllThreeDown) {
  const CartesianPlan plan = schedule({10, 1, 30, 10});
  // A jerk in the one difference that sees the first three, then steady acceleration; the fourth has to stop it.
  std::vector<double> q(51, 0.0);
  for (std::size_t k = 12; k <= q.size(); ++k) q[k - 1] = 1e-6 * static_cast<double>((k - 11) * (k - 10)) / 2.0;
  const auto excess = check(robot_with(1e99, 1e99, 0.125e-6 / (kTs * kTs * kTs)), plan, 0, q);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(excess[i].stretch, 2.0 / std::cbrt(PathCheck::kCheckedShare), 1e-6) << i;
}

TEST(PathCheck, Joints4And6GetHalfOfTheirAccelerationAroundTheWristSingularity) {
  const CartesianPlan plan = schedule({30});
  const auto stretch = [&](std::size_t axis, int through) {
    PathCheck path_check{robot_with(1e99, 1e-6 / (kTs * kTs) / 0.6, 0.0)};
    path_check.begin({}, {});
    for (int tick = 1; tick <= 30; ++tick) {
      JointAngles joints{};  // second difference of 0.6 of the limit at tick 10; runs on, which ends at the end
      joints[axis] = Radians{tick < 10 ? 0.0 : 1e-6 * (tick - 9)};
      path_check.add(plan, joints, {}, tick == through);
    }
    return path_check.excess(plan)[0].stretch;
  };
  for (const std::size_t axis : {3u, 5u}) {
    for (const int through : {7, 10, 12})
      EXPECT_NEAR(stretch(axis, through), std::sqrt(1.2 / PathCheck::kCheckedShare), 1e-6) << through;
    for (const int through : {0, 6, 13}) EXPECT_EQ(stretch(axis, through), 1.0) << through;
  }
  EXPECT_EQ(stretch(1, 10), 1.0);
}

// A kink of the speed at tick 10, 0.1 of the acceleration limit: its jerk is 0.4 of the limit.
TEST(PathCheck, Joints4And6OfAnSCurveGetThreeTenthsOfTheirJerkAroundTheWristSingularity) {
  for (const ProfileKind kind : {ProfileKind::kSCurve, ProfileKind::kTrapezoid}) {
    CartesianPlan plan = schedule({30});
    plan.segments[0].profile = kind;
    const auto stretch = [&](std::size_t axis, int through) {
      PathCheck path_check{robot_with(1e99, 1e-6 / (kTs * kTs) / 0.1, 1e-6 / (kTs * kTs * kTs) / 0.4)};
      path_check.begin({}, {});
      for (int tick = 1; tick <= 30; ++tick) {
        JointAngles joints{};
        joints[axis] = Radians{tick < 10 ? 0.0 : 1e-6 * (tick - 9)};
        path_check.add(plan, joints, {}, tick == through);
      }
      return path_check.excess(plan)[0].stretch;
    };
    const double seen = kind == ProfileKind::kSCurve ? std::cbrt(0.4 / 0.3 / PathCheck::kCheckedShare) : 1.0;
    for (const int through : {8, 10, 12}) {
      EXPECT_NEAR(stretch(3, through), seen, 1e-6) << through;
      EXPECT_NEAR(stretch(5, through), seen, 1e-6) << through;
    }
    for (const int through : {0, 6, 14}) EXPECT_EQ(stretch(3, through), 1.0) << through;
    EXPECT_EQ(stretch(1, 10), 1.0);
  }
}

TEST(PathCheck, JointsThatTurnRoundBetweenTicksKeepADistanceToTheirLimits) {
  const CartesianPlan plan = schedule({10, 10});
  const double bend = 100.0 * kTs * kTs;
  // `top`: where between the ticks 5 and 6 of the first segment the joint turns round; or at its end, at rest.
  const auto axis_at_limit = [&](double distance, double sign, bool rests) {
    RobotModel robot = robot_with(1e99, 100.0, 0.0);
    (sign > 0 ? robot.axes[2].max_rad : robot.axes[2].min_rad) = sign * (1.0 + distance);
    PathCheck path_check{robot};
    JointAngles joints{};
    std::uint8_t axis = 0;
    for (int tick = 0; tick <= 20; ++tick) {
      const double away = rests ? tick - 10 : tick < 11 ? tick - 5.5 : 4.5;
      joints[2] = Radians{sign * (1.0 - 0.5 * bend * (away * away - (rests ? 0.0 : 0.25)))};
      if (tick == 0) path_check.begin(joints, {});
      if (tick > 0) path_check.add(plan, joints, {});
      if (axis == 0) axis = path_check.axis_at_its_limit();
    }
    return axis;
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(axis_at_limit(0.11 * bend, sign, false), 3);
    EXPECT_EQ(axis_at_limit(0.13 * bend, sign, false), 0);
    EXPECT_EQ(axis_at_limit(0.0, sign, true), 0) << "an exact stop on the limit";
  }
}

}  // namespace
}  // namespace armature
