#include "controller/activity/jog/velocity_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"
#include "tests/controller/support/model_logic.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kDeg;

class FakeVelocityInput final : public VelocityInput {
 public:
  std::optional<VelocityCommand> latest() noexcept override { return std::exchange(next, std::nullopt); }
  void joints_deg_s(const PerAxis<double>& deg_s) {
    next = VelocityCommand{.joint_rad_s = make_per_axis([&](std::size_t axis) { return deg_s[axis] * kDeg; })};
  }
  void stop() { next = VelocityCommand{.kind = VelocityCommand::Kind::kStop}; }

  std::optional<VelocityCommand> next;
};

RobotModel robot_to_jog() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * kDeg;
  robot.axes[2].max_jerk_rad_s3 = 2'500.0 * kDeg;
  return robot;
}

class VelocitySourceTest : public testing::TestWithParam<ProfileKind> {
 protected:
  static constexpr Ticks kTimeOut{2'000};  // 100 ms

  VelocitySourceTest() { source.reset_to({}); }

  const SetPoint& tick() {
    const SetPoint& next = source.advance(Ticks{++ticks});
    points.push_back(next.position);
    return next;
  }
  void run(std::int64_t count) {
    for (; count > 0; --count) tick();
  }
  // Repeats the command every 100 ticks.
  void jog(const PerAxis<double>& deg_s, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      if (i % 100 == 0) input.joints_deg_s(deg_s);
      tick();
    }
  }
  double speed_deg_s(std::size_t axis) const {
    return (points.back()[axis] - points[points.size() - 2][axis]).value() / kTickSeconds / kDeg;
  }
  void expect_limits(bool with_jerk, std::size_t from = 3) const {
    double most_jerk = 0.0;
    for (std::size_t k = from; k < points.size(); ++k) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto q = [&](std::size_t back) { return points[k - back][axis].value(); };
        const AxisModel& model = robot.axes[axis];
        ASSERT_LE(std::fabs(q(0) - q(1)) / kTickSeconds, model.max_speed_rad_s * (1.0 + 1e-6)) << "tick " << k;
        ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)) / (kTickSeconds * kTickSeconds),
                  model.max_accel_rad_s2 * (1.0 + 1e-6) + 1e-6)
            << "tick " << k << " axis " << axis;
        ASSERT_LE(q(0), model.max_rad + 1e-12);
        ASSERT_GE(q(0), model.min_rad - 1e-12);
        const double jerk = std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3)) - 8e-15;
        most_jerk = std::max(most_jerk, jerk / (kTickSeconds * kTickSeconds * kTickSeconds) / model.max_jerk_rad_s3);
      }
    }
    if (with_jerk) {
      ASSERT_LE(most_jerk, 1.0 + 1e-3);
    }
  }

  RobotModel robot = robot_to_jog();
  Arm arm{robot};
  FakeVelocityInput input;
  VelocitySource source{robot, arm, input, {.manner = {.profile = GetParam()}, .time_out = kTimeOut}};
  std::vector<PerAxis<Radians>> points{3};
  std::int64_t ticks = 0;
};

TEST_P(VelocitySourceTest, ReachesTheVelocityAndKeepsIt) {
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(tick().state, MotionState::kIdle);
  jog({10, -20, 30, 0, 50, -60}, 8'000);
  EXPECT_EQ(source.last().state, MotionState::kMoving);
  EXPECT_EQ(source.last().rate, 1.0);
  EXPECT_FALSE(source.at_rest());
  const PerAxis<double> wanted{10, -20, 30, 0, 50, -60};
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_NEAR(speed_deg_s(axis), wanted[axis], 1e-8) << axis;
  expect_limits(GetParam() == ProfileKind::kSCurve);
}

TEST_P(VelocitySourceTest, LimitsACommandToTheSpeedOfTheAxis) {
  jog({1'000, -1'000, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()}, 8'000);
  EXPECT_NEAR(speed_deg_s(0), 120.0, 1e-8);
  EXPECT_NEAR(speed_deg_s(1), -120.0, 1e-8);
  EXPECT_EQ(speed_deg_s(5), 0.0);
}

TEST_P(VelocitySourceTest, StopsExactlyAtTheLimitWithItsBrakingDistance) {
  jog({120, -120, 35, -7, 120, -120}, 40'000);
  for (const std::size_t axis : {0u, 4u}) EXPECT_EQ(points.back()[axis], Radians{robot.axes[axis].max_rad});
  for (const std::size_t axis : {1u, 5u}) EXPECT_EQ(points.back()[axis], Radians{robot.axes[axis].min_rad});
  EXPECT_NEAR(speed_deg_s(2), 35.0, 1e-8);
  expect_limits(GetParam() == ProfileKind::kSCurve);
  // It cruises until it must brake: 170 deg at 120 deg/s, and what two ramps take.
  const auto arrived = std::find_if(points.begin(), points.end(),
                                    [&](const auto& point) { return point[0] == Radians{robot.axes[0].max_rad}; });
  const double ramp_s = GetParam() == ProfileKind::kSCurve ? 0.3 : 0.2;
  EXPECT_NEAR(static_cast<double>(arrived - points.begin() - 3) * kTickSeconds, 170.0 / 120.0 + ramp_s,
              3 * kTickSeconds);
  // Away from the limit it moves again.
  jog({-50, 0, 0, 0, 0, 0}, 4'000);
  EXPECT_NEAR(speed_deg_s(0), -50.0, 1e-8);
}

TEST_P(VelocitySourceTest, ComesToRestWhenCommandsStopComing) {
  jog({60, 60, -60, 0, 0, 0}, 4'000);
  const std::int64_t last_command = ticks - 99;
  while (ticks < last_command + kTimeOut.value() - 1) tick();
  EXPECT_NEAR(speed_deg_s(0), 60.0, 1e-8);
  EXPECT_EQ(source.time_outs(), 0u);
  run(2);
  EXPECT_EQ(source.time_outs(), 1u);
  EXPECT_LT(speed_deg_s(0), 60.0 - 1e-6);
  int wakes = 0;
  for (int i = 0; i < 8'000; ++i) wakes += tick().wake ? 1 : 0;
  EXPECT_EQ(wakes, 1);
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(source.last().state, MotionState::kIdle);
  EXPECT_EQ(source.last().rate, 0.0);
  EXPECT_EQ(source.time_outs(), 1u);
  expect_limits(GetParam() == ProfileKind::kSCurve);
}

TEST_P(VelocitySourceTest, RandomCommandsKeepAllLimits) {
  test::Random random{31};
  for (int command = 0; command < 1'000; ++command) {
    PerAxis<double> deg_s;
    for (double& v : deg_s) v = random.integer(0, 3) == 0 ? 0.0 : random.real(-150.0, 150.0);
    input.joints_deg_s(deg_s);
    run(random.integer(1, random.integer(0, 2) == 0 ? 3'000 : 60));
  }
  EXPECT_EQ(ticks, static_cast<std::int64_t>(points.size()) - 3);
  expect_limits(GetParam() == ProfileKind::kSCurve);
}

TEST_P(VelocitySourceTest, AStopUsesTheFullAccelerationAndIsAnswered) {
  jog({60, -120, 0, 0, 0, 0}, 6'000);
  input.stop();
  int stopping = 0;
  while (!tick().stopped) {
    EXPECT_EQ(source.last().state, MotionState::kStopping);
    input.joints_deg_s({10, 10, 10, 10, 10, 10});  // too early
    ASSERT_LT(++stopping, 10'000);
  }
  EXPECT_NEAR(stopping * kTickSeconds, 120.0 / 600.0, 3 * kTickSeconds);
  EXPECT_TRUE(source.at_rest());
  expect_limits(false);
  input.next.reset();
  EXPECT_EQ(tick().state, MotionState::kIdle);
  EXPECT_FALSE(source.last().stopped);
  input.stop();
  EXPECT_TRUE(tick().stopped) << "a stop at rest is answered too";
  jog({10, 0, 0, 0, 0, 0}, 4'000);
  EXPECT_NEAR(speed_deg_s(0), 10.0, 1e-8);
}

TEST_P(VelocitySourceTest, TakesOverAnArmInMotion) {
  jog({60, -60, 30, 0, 90, 0}, 3'000);
  VelocitySource other{
      robot, arm, input, {.manner = {.profile = GetParam(), .accel_share = 0.5}, .time_out = kTimeOut}};
  other.begin_from(source.state());
  EXPECT_FALSE(other.at_rest());
  input.joints_deg_s({60, 60, 0, 0, 0, 10});
  for (int i = 0; i < 12'000; ++i) {
    if (i == 1'000) input.joints_deg_s({60, 60, 0, 0, 0, 10});
    points.push_back(other.advance(Ticks{++ticks}).position);
  }
  expect_limits(GetParam() == ProfileKind::kSCurve);
  EXPECT_TRUE(other.at_rest());
}

TEST_P(VelocitySourceTest, AFaultEndsAllMotion) {
  jog({60, 0, 0, 0, 0, 0}, 3'000);
  source.cut_short(Ticks{ticks});
  source.cancel(Ticks{ticks});
  EXPECT_TRUE(source.at_rest());
  const PerAxis<Radians> place = degrees({1, 2, 3, 4, 5, 6});
  source.reset_to(place);
  EXPECT_EQ(source.last().position, place);
  EXPECT_EQ(tick().position, place);
  EXPECT_EQ(source.last().state, MotionState::kIdle);
}

TEST_P(VelocitySourceTest, AStopTakesTheTimeOfTheFullAcceleration) {
  constexpr double kFastest_deg_s = 90.0;
  jog({60, -60, 30, 0, kFastest_deg_s, 0}, 6'000);
  input.stop();
  std::int64_t taken = 0;
  while (!tick().stopped) ++taken;
  const double most_s = kFastest_deg_s * kDeg / robot.axes[4].max_accel_rad_s2;
  EXPECT_LE(static_cast<double>(taken), most_s / kTickSeconds + 1.0);
}

TEST_P(VelocitySourceTest, AnAxisWithoutADriveStaysWhereItIs) {
  RobotModel five = robot;
  five.axis_count = 5;
  five.axes[5] = {};
  const Arm five_arm{five};
  VelocitySource other{five, five_arm, input, {.manner = {.profile = GetParam()}, .time_out = kTimeOut}};
  other.reset_to({});
  input.joints_deg_s({10, 10, 10, 10, 10, 10});
  for (int i = 1; i < 1'000; ++i) ASSERT_EQ(other.advance(Ticks{i}).position[5], Radians{0.0});
  EXPECT_GT(other.last().position[4], Radians{0.0});
}

INSTANTIATE_TEST_SUITE_P(Kinds, VelocitySourceTest, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& kind) {
                           return std::string{kind.param == ProfileKind::kSCurve ? "Scurve" : "Trapezoid"};
                         });

class SilentObserver final : public ControllerObserver {
 public:
  void on_tick(const Telemetry& telemetry) noexcept override { last = telemetry; }
  void on_event(const Event&) noexcept override {}
  Telemetry last{};
};

TEST(VelocitySource, TheMotionLoopFollowsIt) {
  const RobotModel robot = robot_to_jog();
  test::ModelLogic logic;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& from = robot.axes[axis];
    logic.drives[axis].counts_per_pulse = static_cast<double>(from.counts_per_rev) / from.pulses_per_rev;
  }
  const Arm arm{robot};
  FakeVelocityInput input;
  input.joints_deg_s({30, 0, 0, 0, 0, 0});
  VelocitySource source{robot, arm, input, {.time_out = Ticks{400}}};
  LoopChannel channel;
  SilentObserver observer;
  logic.triggers_to_run = 2'000;
  CountLogicPort port{logic};
  MotionLoop{robot, false, port, logic, channel, source, observer}.run();
  // 20 ms of acceleration to 12 deg/s, then as much braking.
  EXPECT_EQ(observer.last.state, MotionState::kIdle);
  EXPECT_NEAR(observer.last.reference[0].value() / kDeg, 0.24, 0.005);
}

}  // namespace
}  // namespace armature
