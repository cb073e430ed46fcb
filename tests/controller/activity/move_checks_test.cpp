#include "controller/activity/move_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::degrees;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNotNumbers[] = {std::nan(""), kInfinity, -kInfinity};

RobotModel arm_robot() {
  RobotModel robot = test::paper_robot();
  robot.arm.family = ArmFamily::kSixR;
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 100.0;
  return robot;
}

void expect(const std::optional<MoveRefused>& refusal, Refusal reason, int axis = 0) {
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, reason);
  EXPECT_EQ(refusal->axis, axis);
}

TEST(JointMoveChecks, AcceptTheLimitsThemselves) {
  const RobotModel robot = test::paper_robot();
  JointMove move;
  move.target[0] = Radians{robot.axes[0].max_rad};
  move.target[1] = Radians{robot.axes[1].min_rad};
  EXPECT_FALSE(find_refusal(robot, move));
}

TEST(JointMoveChecks, NameTheFirstAxisOutsideItsLimits) {
  const RobotModel robot = test::paper_robot();
  expect(find_refusal(robot, {.target = degrees({0, 0, 170.001, -171, 0, 0})}), Refusal::kOutsideLimits, 3);
  expect(find_refusal(robot, {.target = degrees({0, 0, 0, 0, 0, -170.001})}), Refusal::kOutsideLimits, 6);
  const PathProblem above = find_refusal(robot, {.target = degrees({0, 0, 170.001, 0, 0, 0})})->path;
  EXPECT_NEAR(above.angle_rad, 170.001 * test::kDeg, 1e-12);
  EXPECT_EQ(above.limit_rad, robot.axes[2].max_rad);
  const PathProblem below = find_refusal(robot, {.target = degrees({0, -200, 0, 0, 0, 0})})->path;
  EXPECT_NEAR(below.angle_rad, -200 * test::kDeg, 1e-12);
  EXPECT_EQ(below.limit_rad, robot.axes[1].min_rad);
}

TEST(JointMoveChecks, RefuseWhatIsNoNumber) {
  for (const double bad : kNotNumbers) {
    JointMove move;
    move.target[4] = Radians{bad};
    expect(find_refusal(test::paper_robot(), move), Refusal::kInvalidTarget, 5);
  }
}

TEST(JointMoveChecks, RefuseASpeedOutside0To1) {
  const RobotModel robot = test::paper_robot();
  for (const double speed : {0.0, -0.5, 1.0000001, std::nan("")}) {
    expect(find_refusal(robot, JointMove{.speed = speed}), Refusal::kInvalidTarget);
  }
  EXPECT_FALSE(find_refusal(robot, JointMove{.speed = 1.0}));
  EXPECT_FALSE(find_refusal(robot, JointMove{.speed = 1e-3}));
}

TEST(JointMoveChecks, AxesThatTheRobotHasNotHaveNoLimitsButMustStayAt0) {
  RobotModel robot = test::paper_robot();
  robot.axis_count = 5;
  robot.axes[5].min_rad = robot.axes[5].max_rad = 1.0;  // not looked at
  EXPECT_FALSE(find_refusal(robot, {.target = degrees({1, 2, 3, 4, 5, 0})}));
  expect(find_refusal(robot, {.target = degrees({1, 2, 3, 4, 5, 1e-9})}), Refusal::kInvalidTarget, 6);
}

TEST(JointMoveChecks, AnSCurveNeedsTheJerkLimitOfEveryAxisThatThereIs) {
  RobotModel robot = arm_robot();
  const JointMove move{.profile = ProfileKind::kSCurve};
  EXPECT_FALSE(find_refusal(robot, move));
  robot.axes[5].max_jerk_rad_s3 = 0.0;
  expect(find_refusal(robot, move), Refusal::kNoJerkLimit, 6);
  expect(find_refusal(robot, {}, PoseMove{.profile = ProfileKind::kSCurve}), Refusal::kNoJerkLimit, 6);
  robot.axis_count = 5;
  EXPECT_FALSE(find_refusal(robot, move));
}

TEST(PoseChecks, NeedAKnownGeometry) {
  const RobotModel robot = test::paper_robot();
  expect(find_refusal(robot, {}, PoseMove{}), Refusal::kNoKinematics);
  expect(find_refusal(robot, {}, CartesianMove{}), Refusal::kNoKinematics);
}

CartesianMove good_arc() {
  return {.kind = SegmentRequest::Kind::kArc,
          .limits = {.speed_mm_s = 100,
                     .accel_mm_s2 = 1000,
                     .jerk_mm_s3 = 1e4,
                     .turn_speed_rad_s = 1,
                     .turn_accel_rad_s2 = 10,
                     .turn_jerk_rad_s3 = 100},
          .profile = ProfileKind::kSCurve,
          .blend_mm = 1.0};
}

TEST(CartesianMoveChecks, AcceptWhatIsWhole) {
  EXPECT_FALSE(find_refusal(arm_robot(), {}, good_arc()));
  CartesianMove trapezoid = good_arc();
  trapezoid.profile = ProfileKind::kTrapezoid;
  trapezoid.limits.jerk_mm_s3 = trapezoid.limits.turn_jerk_rad_s3 = 0.0;  // not needed
  trapezoid.blend_mm = 0.0;
  trapezoid.target.rotation = Eigen::Matrix3d::Identity();
  EXPECT_FALSE(find_refusal(arm_robot(), {}, trapezoid));
  CartesianMove line = good_arc();
  line.kind = SegmentRequest::Kind::kLine;
  line.via_mm.x() = std::nan("");  // not looked at
  EXPECT_FALSE(find_refusal(arm_robot(), {}, line));
}

TEST(CartesianMoveChecks, RefuseEveryNumberThatIsOutOfItsRange) {
  const std::function<double&(CartesianMove&)> positive[] = {
      [](CartesianMove& m) -> double& { return m.limits.speed_mm_s; },
      [](CartesianMove& m) -> double& { return m.limits.accel_mm_s2; },
      [](CartesianMove& m) -> double& { return m.limits.jerk_mm_s3; },
      [](CartesianMove& m) -> double& { return m.limits.turn_speed_rad_s; },
      [](CartesianMove& m) -> double& { return m.limits.turn_accel_rad_s2; },
      [](CartesianMove& m) -> double& { return m.limits.turn_jerk_rad_s3; },
  };
  const std::function<double&(CartesianMove&)> finite[] = {
      [](CartesianMove& m) -> double& { return m.target.position_mm.x(); },
      [](CartesianMove& m) -> double& { return m.target.position_mm.z(); },
      [](CartesianMove& m) -> double& { return m.via_mm.y(); },
  };
  const auto expect_refused = [](const std::function<double&(CartesianMove&)>& field, double value) {
    CartesianMove move = good_arc();
    field(move) = value;
    expect(find_refusal(arm_robot(), {}, move), Refusal::kInvalidTarget);
  };
  for (const auto& field : positive) {
    for (const double bad : {0.0, -1.0, kInfinity, std::nan("")}) expect_refused(field, bad);
  }
  for (const auto& field : finite) {
    for (const double bad : kNotNumbers) expect_refused(field, bad);
  }
  for (const double bad : {-1e-9, kInfinity, std::nan("")}) {
    expect_refused([](CartesianMove& m) -> double& { return m.blend_mm; }, bad);
  }
}

TEST(CartesianMoveChecks, RefuseABlendBeforeAnExactStop) {
  CartesianMove move = good_arc();
  move.exact_stop = true;
  expect(find_refusal(arm_robot(), {}, move), Refusal::kInvalidTarget);
  move.blend_mm = 0.0;
  EXPECT_FALSE(find_refusal(arm_robot(), {}, move));
}

TEST(CartesianMoveChecks, RefuseWhatIsNoRotation) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d stretched = identity, mirrored = identity, not_a_number = identity;
  stretched(0, 0) = 1.00001;
  mirrored(2, 2) = -1.0;
  not_a_number(1, 2) = std::nan("");
  for (const Eigen::Matrix3d& bad : {stretched, mirrored, not_a_number, Eigen::Matrix3d{Eigen::Matrix3d::Zero()}}) {
    CartesianMove move = good_arc();
    move.target.rotation = bad;
    expect(find_refusal(arm_robot(), {}, move), Refusal::kInvalidTarget);
    expect(find_refusal(arm_robot(), {}, PoseMove{.target = move.target}), Refusal::kInvalidTarget);
  }
}

TEST(CartesianMoveChecks, RefuseAFrameThatIsNotDefined) {
  UserFrames frames{};
  frames[1] = Transform{};
  CartesianMove move = good_arc();
  for (const int index : {1, 3, 17, 200}) {
    move.target.frame = FrameId{static_cast<std::uint8_t>(index)};
    expect(find_refusal(arm_robot(), frames, move), Refusal::kInvalidTarget);
    expect(find_refusal(arm_robot(), frames, PoseMove{.target = move.target}), Refusal::kInvalidTarget);
  }
  move.target.frame = FrameId{2};
  EXPECT_FALSE(find_refusal(arm_robot(), frames, move));
}

TEST(OverrideChecks, AcceptOneToAHundredPercent) {
  for (const double share : {0.01, 0.5, 1.0}) EXPECT_FALSE(find_refusal(SetOverride{share}));
  for (const double share : {0.0, 0.009999, 1.0000001, -0.5, std::nan("")}) {
    expect(find_refusal(SetOverride{share}), Refusal::kInvalidTarget);
  }
}

TEST(PinChecks, AcceptSixteenPinsAndUpToADay) {
  for (const std::uint8_t pin : {std::uint8_t{1}, std::uint8_t{16}}) {
    EXPECT_FALSE(find_refusal(SetOutput{.pin = pin}));
    EXPECT_FALSE(find_refusal(WaitInput{.pin = pin}));
  }
  for (const std::uint8_t pin : {std::uint8_t{0}, std::uint8_t{17}}) {
    expect(find_refusal(SetOutput{.pin = pin}), Refusal::kInvalidTarget);
    expect(find_refusal(WaitInput{.pin = pin}), Refusal::kInvalidTarget);
  }
  constexpr Ticks kDay{86'400 * 20'000ll};
  EXPECT_FALSE(find_refusal(WaitInput{.pin = 1, .timeout = kDay}));
  expect(find_refusal(WaitInput{.pin = 1, .timeout = kDay + Ticks{1}}), Refusal::kInvalidTarget);
  expect(find_refusal(WaitInput{.pin = 1, .timeout = Ticks{-1}}), Refusal::kInvalidTarget);
}

TEST(PathRefusals, EachProblemHasItsReasonAndKeepsWhereItIs) {
  using Kind = PathProblem::Kind;
  const RobotModel robot = test::paper_robot();
  const std::pair<PathProblem, Refusal> cases[] = {
      {{.kind = Kind::kNoCircle}, Refusal::kNoCircle},
      {{.kind = Kind::kUnreachable, .margin_mm = 3.0}, Refusal::kUnreachable},
      {{.kind = Kind::kOutsideLimits, .axis = 4, .angle_rad = -4.0}, Refusal::kOutsideLimits},
      {{.kind = Kind::kOrientation, .residual_rad = 0.5}, Refusal::kOrientation},
      {{.kind = Kind::kTooFast, .axis = 5, .stretch = 40.0}, Refusal::kTooFast},
      {{.kind = Kind::kTooFast, .axis = 4, .singular = kWristSingular, .stretch = 40.0}, Refusal::kSingular},
      {{.kind = Kind::kTooLong}, Refusal::kInvalidTarget},
  };
  for (auto [problem, reason] : cases) {
    problem.at = 0.25;
    const MoveRefused refusal = refusal_of(robot, problem);
    if (reason == Refusal::kOutsideLimits) {
      EXPECT_EQ(refusal.path.angle_rad, problem.angle_rad);
      EXPECT_EQ(refusal.path.limit_rad, robot.axes[3].min_rad);
    }
    EXPECT_EQ(refusal.reason, reason);
    EXPECT_EQ(refusal.axis, problem.axis);
    EXPECT_EQ(refusal.path.kind, problem.kind);
    EXPECT_EQ(refusal.path.at, 0.25);
    EXPECT_EQ(refusal.path.margin_mm, problem.margin_mm);
  }
}

}  // namespace
}  // namespace armature
