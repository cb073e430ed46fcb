#include "controller/kinematics/arm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::kDeg;
constexpr std::uint64_t kArmSeed = 120;

// The robot of the reference: its limits and speeds.
RobotModel irb120_robot(const nlohmann::json& reference) {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    robot.axes[axis].min_rad = reference["lo_deg"][axis].get<double>() * kDeg;
    robot.axes[axis].max_rad = reference["hi_deg"][axis].get<double>() * kDeg;
    robot.axes[axis].max_speed_rad_s = reference["vmax_deg_s"][axis].get<double>() * kDeg;
  }
  return robot;
}

// The five-axis arm of Hu 2012 in mm, with turned signs and offsets.
RobotModel hu_robot() {
  ArmGeometry arm;
  arm.family = ArmFamily::kFiveR;
  arm.a1_mm = 11;
  arm.a2_mm = 100;
  arm.a3_mm = 95;
  arm.a4_mm = 32;
  arm.d5_mm = 145;
  arm.sign = {1, -1, 1, -1, 1, 1};
  arm.offset_rad = {0.0, -90 * kDeg, 0.0, -90 * kDeg, 10 * kDeg, 0.0};
  RobotModel robot = test::robot_with(arm);
  robot.axis_count = 5;
  robot.axes[5] = AxisModel{};
  return robot;
}

JointAngles angles_of(const Theta& rad) {
  return make_per_axis([&](std::size_t axis) { return Radians{rad[axis]}; });
}
JointAngles degrees_of(const nlohmann::json& deg) {
  return test::degrees(deg.get<PerAxis<double>>());
}
double difference(const JointAngles& a, const JointAngles& b) {
  double worst = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) worst = std::max(worst, std::fabs((a[axis] - b[axis]).value()));
  return worst;
}

TEST(Arm, ForwardTakesTheVendorsAngles) {
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  const Arm arm{irb120_robot(reference)};
  for (const nlohmann::json& entry : reference["poses"]) {
    const Transform expected = test::transform_of(entry["T"]);
    const Transform actual = arm.forward(degrees_of(entry["q_vendor_deg"]));
    ASSERT_LT(test::rotation_error(actual, expected), 4e-15);
    ASSERT_LT(test::position_error_mm(actual, expected), 3e-12);
  }
}

// What the makers draw: all joints at zero.
TEST(Arm, IsInTheVendorsZeroPoseWhenAllJointsAreZero) {
  const auto zero = [](const ArmGeometry& geometry) { return Arm{test::robot_with(geometry)}.forward({}); };
  // ABB and FANUC: upper arm up, forearm forward; KUKA: stretched forward.
  EXPECT_LT((zero(test::irb120_geometry()).position_mm - Eigen::Vector3d(302 + 72, 0, 290 + 270 + 70)).norm(), 1e-12);
  EXPECT_LT((zero(test::lrmate200id()).position_mm - Eigen::Vector3d(50 + 335 + 80, 0, 330 + 330 + 35)).norm(), 1e-12);
  EXPECT_LT((zero(test::kr6_r900()).position_mm - Eigen::Vector3d(25 + 455 + 420 + 80, 0, 400 + 35)).norm(), 1e-12);
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    EXPECT_LT((zero(geometry).rotation.col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-15);
  }
}

TEST(Arm, SelectsTheBranchOfTheReferenceWithItsTurns) {
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  const Arm arm{irb120_robot(reference)};
  int pose = 0;
  for (const nlohmann::json& entry : reference["poses"]) {
    SCOPED_TRACE("pose " + std::to_string(pose++));
    const IkSolutions solutions = arm.inverse(test::transform_of(entry["T"]), degrees_of(entry["prev_vendor_deg"]));
    ASSERT_EQ(solutions.count, entry["branches"].size());
    for (std::size_t i = 0; i < solutions.count; ++i) {
      const bool within = entry["branches"][i]["within_limits"].get<bool>();
      EXPECT_EQ(solutions.branches[i].within_limits, within) << "branch " << i;
      EXPECT_EQ(solutions.branches[i].outside_axis == 0, within) << "branch " << i;
    }
    const nlohmann::json& selected = entry["selected"];
    ASSERT_EQ(solutions.selected, selected["branch"].get<int>());
    EXPECT_EQ(solutions.status, IkStatus::kOk);
    const JointAngles& joints = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
    EXPECT_LT(difference(joints, degrees_of(selected["q_vendor_deg"])), 1e-11);
  }
}

// 219.7 deg/s: with 131072 pulses a revolution the pulse generators are slower than the axis.
TEST(Arm, CountsThePulseRateIntoTheTimeOfAMove) {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  for (AxisModel& axis : robot.axes) axis.max_speed_rad_s = 250 * kDeg;
  // Two flips: (q4, q5, q6) and (q4 + 180, -q5, q6 + 180), near the middle between both.
  const Transform pose = Arm{robot}.forward(test::degrees({10, 20, 30, 0, 20, 0}));
  const JointAngles previous = test::degrees({10, 20, 30, 85, 0, 85});
  const IkSolutions even = Arm{robot}.inverse(pose, previous);
  ASSERT_GE(even.selected, 0);
  EXPECT_NEAR(even.branches[static_cast<std::size_t>(even.selected)].joints[3].value(), 0.0, 1e-12);

  // Axis 4 fast in the catalogue is no faster with slow pulses. The other flip is 95 deg away on axis 6, 85 on axis 4.
  robot.axes[3].max_speed_rad_s = 1000 * kDeg;
  const JointAngles uneven = test::degrees({10, 20, 30, 95, 0, 86});
  const auto theta4_of_choice = [&] {
    const IkSolutions solutions = Arm{robot}.inverse(pose, uneven);
    return std::fabs(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints[3].value()) / kDeg;
  };
  EXPECT_NEAR(theta4_of_choice(), 0.0, 1e-9) << "axis 4 is fast: only axis 6 counts, 86 < 94";
  robot.axes[3].pulses_per_rev = 131'072;
  EXPECT_NEAR(theta4_of_choice(), 180.0, 1e-9) << "axis 4 is slow: 95 > 85 counts";
}

TEST(Arm, NamesTheJointThatNoBranchCanBring) {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  robot.axes[0].min_rad = -10 * kDeg;
  robot.axes[0].max_rad = 10 * kDeg;
  const Arm arm{robot};
  const Transform pose =
      Arm{test::robot_with(test::irb120_geometry())}.forward(test::degrees({40, 10, 10, 20, 30, 40}));
  const IkSolutions solutions = arm.inverse(pose, {});
  EXPECT_EQ(solutions.status, IkStatus::kOutsideLimits);
  EXPECT_EQ(solutions.axis, 1);
  EXPECT_EQ(solutions.selected, -1);
  EXPECT_EQ(solutions.count, 8u);
}

TEST(Arm, TrackingKeepsTheTurnsAndReportsTheLimitInsteadOfUnwinding) {
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  const Arm arm{irb120_robot(reference)};
  const JointAngles there = test::degrees({20, 10, 10, 20, 30, 399.9});
  const IkTracking inside = arm.track(arm.forward(there), test::degrees({20, 10, 10, 20, 30, 399.8}));
  EXPECT_EQ(inside.status, IkStatus::kOk);
  EXPECT_LT(difference(inside.joints, there), 1e-12);
  const IkTracking outside =
      arm.track(arm.forward(test::degrees({20, 10, 10, 20, 30, 400.1})), test::degrees({20, 10, 10, 20, 30, 399.9}));
  EXPECT_EQ(outside.status, IkStatus::kOutsideLimits);
  EXPECT_EQ(outside.axis, 6);
  // To and fro along the same path, a joint at its limit stays solvable.
  const JointAngles at_limit = test::degrees({165, -110, 70, 160, -120, -400});
  const IkTracking still = arm.track(arm.forward(at_limit), at_limit);
  EXPECT_EQ(still.status, IkStatus::kOk);
  EXPECT_LT(difference(still.joints, at_limit), 1e-11);
  const IkSolutions again = arm.inverse(arm.forward(at_limit), at_limit);
  ASSERT_GE(again.selected, 0);
  EXPECT_LT(difference(again.branches[static_cast<std::size_t>(again.selected)].joints, at_limit), 1e-11);
}

TEST(Arm, TrackingPassesOnWhyThereIsNoAnswer) {
  const Arm arm{test::robot_with(test::irb120_geometry())};
  Transform pose = arm.forward({});
  pose.position_mm.x() = 2000;
  const IkTracking far = arm.track(pose, {});
  EXPECT_EQ(far.status, IkStatus::kUnreachable);
  EXPECT_GT(far.margin_mm, 1000);
  EXPECT_EQ(arm.inverse(pose, {}).margin_mm, far.margin_mm);
  pose.position_mm.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(arm.track(pose, {}).status, IkStatus::kInvalidInput);
  EXPECT_EQ(arm.inverse(pose, {}).status, IkStatus::kInvalidInput);
  EXPECT_EQ(arm.inverse(pose, {}).selected, -1);
}

// Central differences of forward().
void expect_jacobian_of_forward(const Arm& arm, const JointAngles& joints, std::size_t count) {
  const Jacobian jacobian = arm.jacobian(joints);
  const double step = 1e-5;
  const Transform here = arm.forward(joints);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    JointAngles plus = joints, minus = joints;
    plus[axis] += Radians{step};
    minus[axis] -= Radians{step};
    const Transform after = arm.forward(plus), before = arm.forward(minus);
    const Eigen::Vector3d v = (after.position_mm - before.position_mm) / (2.0 * step);
    const Eigen::Matrix3d spin = (after.rotation - before.rotation) / (2.0 * step) * here.rotation.transpose();
    const auto column = static_cast<Eigen::Index>(axis);
    const double present = axis < count ? 1.0 : 0.0;
    EXPECT_LT((jacobian.col(column).head<3>() - present * v).norm(), 1e-6) << axis;
    EXPECT_LT((jacobian.col(column).tail<3>() - Eigen::Vector3d(spin(2, 1), spin(0, 2), spin(1, 0))).norm(), 1e-8)
        << axis;
  }
}

TEST(Arm, JacobianAndRatesAreInTheVendorsConvention) {
  test::Random random{kArmSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const Arm arm{test::robot_with(geometry)};
    for (int i = 0; i < 30; ++i) {
      const JointAngles joints = angles_of(test::random_angles(random));
      expect_jacobian_of_forward(arm, joints, 6);
      const Manipulability away = arm.manipulability(joints);
      const double least = std::min({away.elbow, away.shoulder, away.wrist});
      if (least < 1e-2) continue;
      const Eigen::Vector3d v{random.real(-99, 99), random.real(-99, 99), random.real(-99, 99)};
      const Eigen::Vector3d w{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
      const PerAxis<double> rates = arm.joint_rates(joints, v, w);
      const Eigen::Matrix<double, 6, 1> back =
          arm.jacobian(joints) * Eigen::Map<const Eigen::Matrix<double, 6, 1>>{rates.data()};
      EXPECT_LT((back.head<3>() - v).norm(), 1e-9) << "seed " << kArmSeed << " " << i;
      EXPECT_LT((back.tail<3>() - w).norm(), 1e-11) << "seed " << kArmSeed << " " << i;
    }
  }
}

TEST(Arm, SolvesTheFiveAxisArmThroughTheSameDoor) {
  const Arm arm{hu_robot()};
  test::Random random{kArmSeed};
  for (int i = 0; i < 200; ++i) {
    Theta q = test::random_angles(random, 2.5);
    q[5] = 0.0;
    const JointAngles joints = angles_of(q);
    const Transform pose = arm.forward(joints);
    const IkSolutions solutions = arm.inverse(pose, joints);
    ASSERT_TRUE(solved(solutions.status)) << "seed " << kArmSeed << " " << i;
    ASSERT_LE(solutions.count, 4u);
    ASSERT_GE(solutions.selected, 0);
    EXPECT_LT(difference(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints, joints), 1e-8);
    EXPECT_LT(solutions.residual_rad, 1e-12);
    const IkTracking tracking = arm.track(pose, joints);
    ASSERT_TRUE(solved(tracking.status));
    EXPECT_LT(difference(tracking.joints, joints), 1e-8) << "seed " << kArmSeed << " " << i;
    EXPECT_EQ(tracking.joints[5].value(), 0.0);
    if (i < 20) expect_jacobian_of_forward(arm, joints, 5);
  }
  EXPECT_EQ(arm.manipulability({}).wrist, 1.0);
}

TEST(Arm, WithoutGeometryKnowsNothing) {
  const Arm arm{test::paper_robot()};
  EXPECT_FALSE(arm.known());
  EXPECT_EQ(arm.inverse({}, {}).status, IkStatus::kInvalidInput);
  EXPECT_EQ(arm.inverse({}, {}).count, 0u);
  EXPECT_EQ(arm.track({}, {}).status, IkStatus::kInvalidInput);
  EXPECT_EQ(arm.jacobian({}).norm(), 0.0);
  EXPECT_TRUE(Arm{test::robot_with(test::irb120_geometry())}.known());
}

}  // namespace
}  // namespace armature
