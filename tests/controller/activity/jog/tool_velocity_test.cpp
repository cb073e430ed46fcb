// The velocity source with commanded velocities of the tool.
#include "controller/activity/jog/tool_velocity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "controller/activity/jog/velocity_source.hpp"
#include "controller/base/timebase.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kDeg;

class FakeToolInput final : public VelocityInput {
 public:
  std::optional<VelocityCommand> latest() noexcept override { return std::exchange(next, std::nullopt); }
  void tool(const Eigen::Vector3d& move_mm_s, const Eigen::Vector3d& turn_deg_s = Eigen::Vector3d::Zero(),
            ToolTwist::Frame frame = ToolTwist::Frame::kBase) {
    next = VelocityCommand{.kind = VelocityCommand::Kind::kTool,
                           .tool = {.frame = frame, .move_mm_s = move_mm_s, .turn_rad_s = turn_deg_s * kDeg}};
  }

  std::optional<VelocityCommand> next;
};

RobotModel irb120_robot() {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  const PerAxis<double> min_deg{-165, -110, -110, -160, -120, -400}, max_deg{165, 110, 70, 160, 120, 400};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    robot.axes[axis].min_rad = min_deg[axis] * kDeg;
    robot.axes[axis].max_rad = max_deg[axis] * kDeg;
  }
  return robot;
}

class ToolVelocityTest : public testing::Test {
 protected:
  ToolVelocityTest() { begin(degrees({10, 20, 10, 30, 50, -20})); }

  void begin(const PerAxis<Radians>& at) {
    source.reset_to(at);
    points.assign(3, at);
  }
  const SetPoint& tick() {
    const SetPoint& next = source.advance(Ticks{++ticks});
    points.push_back(next.position);
    return next;
  }
  // Repeats the command every 100 ticks.
  template <class Command>
  void repeat(std::int64_t count, Command command) {
    for (std::int64_t i = 0; i < count; ++i) {
      if (i % 100 == 0) command();
      tick();
    }
  }
  Transform tool(const PerAxis<Radians>& joints) const { return arm.forward(joints) * flange_T_tool; }
  Eigen::Vector3d velocity_mm_s() const {
    return (tool(points.back()).position_mm - tool(points[points.size() - 2]).position_mm) / kTickSeconds;
  }
  void expect_limits() const {
    for (std::size_t k = 2; k < points.size(); ++k) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto q = [&](std::size_t back) { return points[k - back][axis].value(); };
        const AxisModel& model = robot.axes[axis];
        ASSERT_LE(std::fabs(q(0) - q(1)) / kTickSeconds, model.max_speed_rad_s * (1.0 + 1e-5)) << "tick " << k;
        ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)) / (kTickSeconds * kTickSeconds),
                  model.max_accel_rad_s2 * (1.0 + 1e-5))
            << "tick " << k << " axis " << axis;
        ASSERT_LE(q(0), model.max_rad + 1e-7);
        ASSERT_GE(q(0), model.min_rad - 1e-7);
      }
    }
  }
  // The largest distance of all set-points from the straight line from the first one along `direction`.
  double off_line_mm(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d start = tool(points.front()).position_mm;
    double worst = 0.0;
    for (const auto& point : points) {
      worst = std::max(worst, (tool(point).position_mm - start).cross(direction.normalized()).norm());
    }
    return worst;
  }

  const RobotModel robot = irb120_robot();
  const Arm arm{robot};
  const Transform flange_T_tool{.position_mm = {0, 0, 100}};
  FakeToolInput input;
  VelocitySource source{robot, arm, input, {.time_out = Ticks{2'000}, .flange_T_tool = flange_T_tool}};
  std::vector<PerAxis<Radians>> points;
  std::int64_t ticks = 0;
};

TEST_F(ToolVelocityTest, TheToolMovesOnAStraightLineInTheBaseFrame) {
  const Eigen::Vector3d wanted{30, 60, -20};
  const Transform start = tool(points.front());
  repeat(8'000, [&] { input.tool(wanted); });
  EXPECT_EQ(source.last().state, MotionState::kMoving);
  EXPECT_EQ(source.last().inverses, 1);
  EXPECT_LT((velocity_mm_s() - wanted).norm(), 1e-6);
  EXPECT_LT(off_line_mm(wanted), 1e-9);
  EXPECT_LT(test::rotation_error(tool(points.back()), start), 1e-12);
  repeat(6'000, [&] { input.tool(Eigen::Vector3d::Zero()); });
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(source.last().state, MotionState::kIdle);
  EXPECT_LT(off_line_mm(wanted), 1e-9);
  EXPECT_EQ(source.departures(), 0u);
  expect_limits();
}

TEST_F(ToolVelocityTest, TheFrameOfTheToolTurnsWithIt) {
  const Eigen::Vector3d move{0, 0, 40}, turn{0, 0, 30};
  const Transform start = tool(points.front());
  repeat(8'000, [&] { input.tool(move, turn, ToolTwist::Frame::kTool); });
  // Along and about its own z the tool moves on a line.
  EXPECT_LT(off_line_mm(start.rotation.col(2)), 1e-8);
  EXPECT_LT((tool(points.back()).rotation.col(2) - start.rotation.col(2)).norm(), 1e-11);
  EXPECT_LT((velocity_mm_s() - 40.0 * start.rotation.col(2)).norm(), 1e-6);
  EXPECT_EQ(source.departures(), 0u);
  expect_limits();
}

TEST_F(ToolVelocityTest, ARotationKeepsTheToolCentrePoint) {
  const Transform start = tool(points.front());
  repeat(6'000, [&] { input.tool(Eigen::Vector3d::Zero(), {10, -20, 15}); });
  for (const auto& point : points) {
    ASSERT_LT((tool(point).position_mm - start.position_mm).norm(), 1e-9);
  }
  const Eigen::AngleAxisd turned{Eigen::Matrix3d{tool(points.back()).rotation * start.rotation.transpose()}};
  EXPECT_GT(turned.angle(), 3.0 * kDeg);
  EXPECT_LT(turned.axis().cross(Eigen::Vector3d{10, -20, 15}.normalized()).norm(), 1e-9);
  expect_limits();
}

TEST_F(ToolVelocityTest, KeepsItsAccelerationsWhenTheCommandChanges) {
  test::Random random{41};
  for (int change = 0; change < 60; ++change) {
    const Eigen::Vector3d move{random.real(-150, 150), random.real(-150, 150), random.real(-80, 80)};
    const bool turns = random.integer(0, 1) == 0;
    const Eigen::Vector3d turn = turns
                                     ? Eigen::Vector3d{random.real(-30, 30), random.real(-30, 30), random.real(-60, 60)}
                                     : Eigen::Vector3d::Zero();
    const auto frame = random.integer(0, 1) == 0 ? ToolTwist::Frame::kBase : ToolTwist::Frame::kTool;
    repeat(random.integer(1, 2'000), [&] { input.tool(move, turn, frame); });
    if (source.departures() > 0) break;
  }
  EXPECT_GT(points.size(), 10'000u);
  expect_limits();
}

TEST_F(ToolVelocityTest, ComesToRestOnTheLineWhenAJointReachesItsLimit) {
  begin(degrees({10, 20, 10, 30, 50, 380}));
  const Eigen::Vector3d along = tool(points.front()).rotation.col(2);
  const auto command = [&](double sign) {
    input.tool({0, 0, 20.0 * sign}, {0, 0, 60.0 * sign}, ToolTwist::Frame::kTool);
  };
  repeat(6'000, [&] { command(1.0); });
  EXPECT_FALSE(source.at_rest());
  repeat(6'000, [&] { command(1.0); });
  EXPECT_TRUE(source.at_rest());
  EXPECT_NEAR(points.back()[5].value(), robot.axes[5].max_rad, 1e-8);
  EXPECT_LT(off_line_mm(along), 1e-8);
  repeat(3'000, [&] { command(-1.0); });
  EXPECT_FALSE(source.at_rest());
  EXPECT_LT(points.back()[5].value(), robot.axes[5].max_rad - 0.01);
  EXPECT_LT(off_line_mm(along), 1e-8);
  EXPECT_EQ(source.departures(), 0u);
  expect_limits();
}

TEST_F(ToolVelocityTest, StopsAtTheEndOfTheReachAndCanBeMovedBack) {
  repeat(60'000, [&] { input.tool({100, 20, 0}); });
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(source.departures(), 1u);
  expect_limits();
  const Eigen::Vector3d there = tool(points.back()).position_mm;
  repeat(4'000, [&] { input.tool({-50, -10, 0}); });
  EXPECT_LT((tool(points.back()).position_mm - there).dot(Eigen::Vector3d{50, 10, 0}.normalized()), -1.0);
  expect_limits();
}

TEST_F(ToolVelocityTest, ChangesOfTheCommandKeepTheLimitsOfTheTool) {
  const ToolVelocityLimits limits{
      .accel_mm_s2 = 400.0, .turn_accel_rad_s2 = 5.0, .jerk_mm_s3 = 3'000.0, .turn_jerk_rad_s3 = 50.0};
  VelocitySource smooth{
      robot, arm, input, {.manner = {.tool = limits}, .time_out = Ticks{100'000}, .flange_T_tool = flange_T_tool}};
  smooth.reset_to(points.back());
  const auto run = [&](const Eigen::Vector3d& move_mm_s, int count) {
    input.tool(move_mm_s);
    for (; count > 0; --count) points.push_back(smooth.advance(Ticks{++ticks}).position);
  };
  run({60, 0, 0}, 9'000);
  run({0, 60, -30}, 9'000);
  run({0, 0, 0}, 9'000);
  EXPECT_TRUE(smooth.at_rest());
  EXPECT_EQ(smooth.departures(), 0u);
  std::vector<Eigen::Vector3d> path;
  for (const auto& point : points) path.push_back(tool(point).position_mm);
  double accel = 0.0, jerk = 0.0;
  for (std::size_t k = 3; k < path.size(); ++k) {
    const Eigen::Vector3d second = path[k] - 2.0 * path[k - 1] + path[k - 2];
    const Eigen::Vector3d third = second - (path[k - 1] - 2.0 * path[k - 2] + path[k - 3]);
    accel = std::max(accel, second.norm() / (kTickSeconds * kTickSeconds));
    jerk = std::max(jerk, (third.norm() - 3e-12) / (kTickSeconds * kTickSeconds * kTickSeconds));
  }
  EXPECT_LE(accel, 400.0 * 1.001);
  EXPECT_GT(accel, 300.0);
  EXPECT_LE(jerk, 3'000.0 * 1.01);
  expect_limits();
}

TEST_F(ToolVelocityTest, ComesToRestWhenCommandsStopComing) {
  input.tool({50, 0, 0});
  while (ticks < 2'000) tick();
  EXPECT_EQ(source.time_outs(), 0u);
  EXPECT_GT(velocity_mm_s().norm(), 20.0);
  while (ticks < 8'000) tick();
  EXPECT_EQ(source.time_outs(), 1u);
  EXPECT_TRUE(source.at_rest());
  EXPECT_LT(off_line_mm({50, 0, 0}), 1e-9);
  expect_limits();
}

TEST_F(ToolVelocityTest, AStopStaysOnTheLineAndIsAnswered) {
  const Eigen::Vector3d wanted{0, 100, 0};
  repeat(6'000, [&] { input.tool(wanted); });
  input.next = VelocityCommand{.kind = VelocityCommand::Kind::kStop};
  int stopping = 0;
  while (!tick().stopped) {
    EXPECT_EQ(source.last().state, MotionState::kStopping);
    ASSERT_LT(++stopping, 5'000);
  }
  EXPECT_TRUE(source.at_rest());
  EXPECT_LT(off_line_mm(wanted), 1e-9);
  EXPECT_EQ(source.departures(), 0u);
  expect_limits();
}

TEST_F(ToolVelocityTest, JointAndToolVelocitiesFollowEachOther) {
  const auto joints = [&] { input.next = VelocityCommand{.joint_rad_s = {0.3, -0.2, 0.1, 0.0, 0.4, 0.0}}; };
  repeat(3'000, joints);
  repeat(5'000, [&] { input.tool({0, 0, 40}); });
  EXPECT_LT((velocity_mm_s() - Eigen::Vector3d{0, 0, 40}).norm(), 1e-6);
  repeat(4'000, joints);
  EXPECT_NEAR((points.back()[0] - points[points.size() - 2][0]).value() / kTickSeconds, 0.3, 1e-9);
  EXPECT_EQ(source.departures(), 0u);
  expect_limits();
}

TEST_F(ToolVelocityTest, AtTheWristSingularityItStaysWhereItIs) {
  const auto singular = degrees({10, 20, 10, 30, 0, -20});
  begin(singular);
  repeat(500, [&] { input.tool({0, 50, 0}); });
  EXPECT_EQ(points.back(), singular);
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(source.departures(), 1u);
}

TEST_F(ToolVelocityTest, RandomMotionsNeverLeaveTheLimits) {
  test::Random random{42};
  for (int draw = 0; draw < 60; ++draw) {
    begin(degrees({random.real(-120, 120), random.real(-60, 60), random.real(-60, 40), random.real(-120, 120),
                   random.real(-100, 100), random.real(-180, 180)}));
    const Eigen::Vector3d move{random.real(-300, 300), random.real(-300, 300), random.real(-300, 300)};
    const Eigen::Vector3d turn{random.real(-60, 60), random.real(-60, 60), random.real(-60, 60)};
    repeat(random.integer(1'000, 12'000),
           [&] { input.tool(move, random.integer(0, 1) == 0 ? turn : Eigen::Vector3d::Zero()); });
    while (!source.at_rest()) tick();
    expect_limits();
    if (HasFatalFailure()) FAIL() << "seed 42 draw " << draw;
  }
  // Most of these fast motions end at a limit along their path.
  EXPECT_LT(source.departures(), 20u);
}

}  // namespace
}  // namespace armature
