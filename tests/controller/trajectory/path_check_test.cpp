#include "controller/trajectory/check/path_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

constexpr double kTs = kTickSeconds;

// Segments of these lengths in ticks. Only their times matter here.
CartesianPlan schedule(const std::vector<std::int64_t>& ticks, ProfileKind kind = ProfileKind::kSCurve) {
  CartesianPlan plan;
  for (const std::int64_t duration : ticks) {
    CartesianSegment& segment = plan.segments[plan.count++];
    segment.start = plan.duration;
    segment.duration = Ticks{duration};
    segment.profile = kind;
    plan.duration += segment.duration;
  }
  return plan;
}

// Gets the largest excess of all that a check finds.
class Worst {
 public:
  explicit Worst(const RobotModel& robot) : check_{robot} { check_.begin({}, {}); }
  void add(const CartesianPlan& plan, const JointAngles& joints, const ToolSample& tool, bool through_wrist = false) {
    check_.add(plan, joints, tool, through_wrist);
    take();
  }
  [[nodiscard]] const PathCheck::Place& worst() const { return worst_; }
  PathCheck::Place finish(const CartesianPlan& plan) {
    check_.finish(plan);
    take();
    return worst_;
  }

 private:
  void take() {
    const PathCheck::Place place = check_.take_latest();
    if (place.stretch > worst_.stretch) worst_ = place;
  }

  PathCheck check_;
  PathCheck::Place worst_{};
};

// Feeds joint `axis` with positions, tick by tick.
PathCheck::Place check(const RobotModel& robot, const CartesianPlan& plan, std::size_t axis,
                       const std::vector<double>& rad) {
  Worst worst{robot};
  for (const double q : rad) {
    JointAngles joints{};
    joints[axis] = Radians{q};
    worst.add(plan, joints, {});
  }
  return worst.finish(plan);
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
  EXPECT_NEAR(speed.stretch, 4.0 / PathCheck::kCheckedShare, 1e-9);
  EXPECT_EQ(speed.axis, 3);
  EXPECT_EQ(speed.from_tick, 4.0);
  EXPECT_EQ(speed.to_tick, 5.0);
  const auto accel = check(robot_with(1e99, 2.0 * h / (kTs * kTs) / 9.0, 1e99), plan, 5, pulse);
  EXPECT_NEAR(accel.stretch, 3.0 / std::sqrt(PathCheck::kCheckedShare), 1e-9);
  EXPECT_EQ(accel.axis, 6);
  EXPECT_EQ(accel.from_tick, 4.0);
  EXPECT_EQ(accel.to_tick, 6.0);
  const auto jerk = check(robot_with(1e99, 1e99, 3.0 * h / (kTs * kTs * kTs) / 8.0), plan, 0, pulse);
  EXPECT_NEAR(jerk.stretch, std::sqrt(8.0 / PathCheck::kCheckedShare), 1e-9);
  EXPECT_EQ(jerk.axis, 1);
}

TEST(PathCheck, KeepsAMarginForSetPointsBetweenTicks) {
  const CartesianPlan plan = schedule({10});
  std::vector<double> ramp;
  for (int tick = 1; tick <= 10; ++tick) ramp.push_back(1e-4 * tick);
  EXPECT_EQ(check(robot_with(1e-4 / kTs * 1.03, 1e99, 1e99), plan, 0, ramp).stretch, 1.0);
  EXPECT_GT(check(robot_with(1e-4 / kTs * 1.005, 1e99, 1e99), plan, 0, ramp).stretch, 1.0);
}

TEST(PathCheck, TheRestBeforeAndAfterCounts) {
  const CartesianPlan plan = schedule({10});
  std::vector<double> ramp;
  for (int tick = 1; tick <= 10; ++tick) ramp.push_back(1e-4 * tick);
  const auto excess = check(robot_with(1e99, 1e-4 / (kTs * kTs) / 4.0, 1e99), plan, 0, ramp);
  EXPECT_NEAR(excess.stretch, 2.0 / std::sqrt(PathCheck::kCheckedShare), 1e-9);
  std::vector<double> late(9, 0.0);
  late.push_back(1e-4);  // at speed in the last tick
  const auto stop = check(robot_with(1e99, 1e-4 / (kTs * kTs) / 4.0, 1e99), plan, 0, late);
  EXPECT_GT(stop.stretch, 1.9);
}

TEST(PathCheck, JerkOfTrapezoidsAndOfAxesWithoutALimitIsFree) {
  std::vector<double> pulse(10, 0.0);
  pulse[4] = 1e-3;
  EXPECT_GT(check(robot_with(1e99, 1e99, 1.0), schedule({10}), 0, pulse).stretch, 1.0);
  EXPECT_EQ(check(robot_with(1e99, 1e99, 1.0), schedule({10}, ProfileKind::kTrapezoid), 0, pulse).stretch, 1.0);
  EXPECT_EQ(check(robot_with(1e99, 1e99, 0.0), schedule({10}), 0, pulse).stretch, 1.0);
}

TEST(PathCheck, AxesThatTheArmHasNotAreNotLookedAt) {
  RobotModel robot = robot_with(1.0, 1.0, 1.0);
  robot.axis_count = 5;
  robot.axes[5] = {};
  const auto excess = check(robot, schedule({10}), 0, std::vector<double>(10, 0.0));
  EXPECT_EQ(excess.stretch, 1.0);
}

TEST(PathCheck, NamesTheTicksThatAreTooFast) {
  const CartesianPlan plan = schedule({10, 0, 10, 10});
  for (const std::size_t tick : {3u, 14u, 28u}) {
    std::vector<double> step(30, 0.0);
    for (std::size_t k = tick; k < step.size(); ++k) step[k - 1] = 1e-3;
    const PathCheck::Place place = check(robot_with(1.0, 1e99, 1e99), plan, 0, step);
    EXPECT_GT(place.stretch, 1.0);
    EXPECT_EQ(place.from_tick, static_cast<double>(tick) - 1.0);
    EXPECT_EQ(place.to_tick, static_cast<double>(tick));
  }
}

TEST(PathCheck, TheToolIsCheckedAgainstTheLargerLimitsOfNeighbours) {
  const PathLimits wide{.speed_mm_s = 1e9,
                        .accel_mm_s2 = 1e15,
                        .jerk_mm_s3 = 1e20,
                        .turn_speed_rad_s = 1e9,
                        .turn_accel_rad_s2 = 1e15,
                        .turn_jerk_rad_s3 = 1e20};
  const auto run = [&](double PathLimits::*limit, double value, ProfileKind kind = ProfileKind::kSCurve) {
    CartesianPlan plan = schedule({10, 10}, kind);
    plan.segments[0].limits = plan.segments[1].limits = wide;
    plan.segments[0].limits.*limit = value;
    plan.segments[1].limits.*limit = 0.5 * value;
    Worst worst{robot_with(1e99, 1e99, 1e99)};
    for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
      ToolSample sample;  // jumps at the end of the first segment by 1 mm and by 1e-3 rad
      if (tick >= 11) {
        sample.tool.base_T_tool = test::turned_by(test::moved({}, 0.6, 0.8, 0), 1e-3, {1, 2, 3});
        sample.rotation = sample.tool.base_T_tool.rotation;
      }
      worst.add(plan, {}, sample);
    }
    return worst.finish(plan);
  };
  const double speed_tolerance = 1.0 + PathCheck::kSpeedTolerance;
  const double tolerance = 1.0 + PathCheck::kToolTolerance, jerk_tolerance = 1.0 + PathCheck::kJerkTolerance;
  const double kTs2 = kTs * kTs, kTs3 = kTs * kTs * kTs;
  EXPECT_EQ(run(&PathLimits::speed_mm_s, 1.01 / kTs).stretch, 1.0);
  EXPECT_NEAR(run(&PathLimits::speed_mm_s, 0.5 / kTs).stretch, 2.0 / speed_tolerance, 1e-9);
  EXPECT_EQ(run(&PathLimits::speed_mm_s, 0.5 / kTs).axis, 0);
  EXPECT_NEAR(run(&PathLimits::turn_speed_rad_s, 0.5e-3 / kTs).stretch, 2.0 / speed_tolerance, 1e-5);
  // Those behind the second tick belong to the second segment alone.
  EXPECT_NEAR(run(&PathLimits::accel_mm_s2, 0.25 / kTs2).stretch, std::sqrt(8.0 / tolerance), 1e-9);
  EXPECT_NEAR(run(&PathLimits::turn_accel_rad_s2, 0.25e-3 / kTs2).stretch, std::sqrt(8.0 / tolerance), 1e-5);
  EXPECT_NEAR(run(&PathLimits::jerk_mm_s3, 0.5 / kTs3).stretch, std::sqrt(4.0 / jerk_tolerance), 1e-9);
  EXPECT_NEAR(run(&PathLimits::turn_jerk_rad_s3, 0.5e-3 / kTs3).stretch, std::sqrt(4.0 / jerk_tolerance), 1e-5);
  EXPECT_EQ(run(&PathLimits::jerk_mm_s3, 0.5 / kTs3, ProfileKind::kTrapezoid).stretch, 1.0);
}

TEST(PathCheck, Joints4And6GetHalfOfTheirAccelerationAroundTheWristSingularity) {
  const CartesianPlan plan = schedule({30});
  const auto stretch = [&](std::size_t axis, int through) {
    Worst worst{robot_with(1e99, 1e-6 / (kTs * kTs) / 0.6, 0.0)};
    for (int tick = 1; tick <= 30; ++tick) {
      JointAngles joints{};  // second difference of 0.6 of the limit at tick 10; runs on, which ends at the end
      joints[axis] = Radians{tick < 10 ? 0.0 : 1e-6 * (tick - 9)};
      worst.add(plan, joints, {}, tick == through);
    }
    return worst.worst().stretch;
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
      Worst worst{robot_with(1e99, 1e-6 / (kTs * kTs) / 0.1, 1e-6 / (kTs * kTs * kTs) / 0.4)};
      for (int tick = 1; tick <= 30; ++tick) {
        JointAngles joints{};
        joints[axis] = Radians{tick < 10 ? 0.0 : 1e-6 * (tick - 9)};
        worst.add(plan, joints, {}, tick == through);
      }
      return worst.worst().stretch;
    };
    const double seen = kind == ProfileKind::kSCurve ? std::sqrt(0.4 / 0.3 / PathCheck::kCheckedShare) : 1.0;
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
