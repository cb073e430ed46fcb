// The choice of a branch, without the branches that cannot win: compared with the choice from all of them, and both
// with a search of all turns of all branches that shares no code with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::kDeg;
using test::kPi;
constexpr std::uint64_t kSoonestSeed = 2024;
constexpr int kPosesOfARobot = 25'000;

std::uint64_t bits(double v) {
  return std::bit_cast<std::uint64_t>(v);
}

RobotModel robot_within(const ArmGeometry& geometry, const PerAxis<double>& low_deg, const PerAxis<double>& high_deg) {
  RobotModel robot = test::robot_with(geometry);
  constexpr PerAxis<double> kSpeed_deg_s{250, 250, 250, 320, 320, 420};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    robot.axes[axis].min_rad = low_deg[axis] * kDeg;
    robot.axes[axis].max_rad = high_deg[axis] * kDeg;
    robot.axes[axis].max_speed_rad_s = kSpeed_deg_s[axis] * kDeg;
    robot.axes[axis].pulses_per_rev = 1000;
  }
  return robot;
}

// Limits of a maker; of less than a turn, far from zero; of several turns; equal speeds with wide limits, where many
// moves take equally long.
std::array<RobotModel, 5> robots() {
  RobotModel even = test::robot_with(test::irb120_geometry());
  return {robot_within(test::irb120_geometry(), {-165, -110, -110, -160, -120, -400}, {165, 110, 70, 160, 120, 400}),
          robot_within(test::lrmate200id(), {-170, -100, -140, -190, -125, -360}, {170, 145, 280, 190, 125, 360}),
          robot_within(test::kr6_r900(), {-30, -190, -120, 20, -10, -1000}, {60, 45, 156, 300, 100, -300}),
          robot_within(test::kr6_r900(), {-900, -900, -900, -900, -900, -900}, {900, 900, 900, 900, 900, 900}), even};
}

class Draw {
 public:
  explicit Draw(const RobotModel& robot) : robot_{robot}, arm_{robot} {}

  // Kinds: anywhere, right angles, at limits, near the wrist singularity, near the stretched elbow, wrist centre at
  // axis 1, beyond the reach.
  Transform pose(test::Random& random, int kind, PerAxis<double>& joints) const {
    const ArmGeometry& arm = robot_.arm;
    const auto set = [&](std::size_t axis, double theta) {
      joints[axis] = arm.sign[axis] * (theta - arm.offset_rad[axis]);
    };
    joints = within_limits(random);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = robot_.axes[axis];
      if (kind == 1) joints[axis] = 0.5 * kPi * static_cast<double>(random.integer(-3, 3));
      if (kind == 2 && random.integer(0, 1) == 0) joints[axis] = random.integer(0, 1) ? model.min_rad : model.max_rad;
    }
    const double away = random.integer(0, 1) ? 0.0 : std::pow(10.0, random.real(-12, -3));
    if (kind == 3) set(4, away);
    if (kind == 4) set(2, std::atan2(arm.d4_mm, arm.a3_mm) + away);
    Transform pose = arm_.forward(vendor(joints));
    if (kind == 5) {
      const Eigen::Vector3d to_wrist = arm.d6_mm * pose.rotation.col(2);
      pose.position_mm.x() = to_wrist.x() + away;
      pose.position_mm.y() = to_wrist.y();
    }
    if (kind == 6) pose.position_mm *= random.real(0.3, 1.8);
    return pose;
  }

  // Kinds: there, a step away, near, anywhere, half turns away (equal times), far outside the limits.
  JointAngles previous(test::Random& random, int kind, const PerAxis<double>& joints) const {
    PerAxis<double> rad = kind == 3 ? within_limits(random) : joints;
    for (double& angle : rad) {
      if (kind == 1) angle += random.real(-0.05, 0.05);
      if (kind == 2) angle += random.real(-0.5, 0.5);
      if (kind == 4) angle += 0.5 * kPi * static_cast<double>(random.integer(-4, 4));
      if (kind == 5) angle = random.real(-30.0, 30.0);
    }
    return vendor(rad);
  }

  static JointAngles vendor(const PerAxis<double>& rad) {
    return make_per_axis([&](std::size_t axis) { return Radians{rad[axis]}; });
  }

 private:
  PerAxis<double> within_limits(test::Random& random) const {
    PerAxis<double> joints;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      joints[axis] = random.real(robot_.axes[axis].min_rad, robot_.axes[axis].max_rad);
    }
    return joints;
  }

  const RobotModel& robot_;
  Arm arm_;
};
constexpr int kPoseKinds = 7, kPreviousKinds = 6;

// Of one branch: the least time with any turns inside the limits; infinite without one. Rounding of 2e-9 counts as
// inside, so it can differ from the program where a joint is at a limit: see `borderline`.
struct Move {
  double time_s = 0.0;
  bool borderline = false;
};
Move least_move(const RobotModel& robot, const IkBranch& branch, const JointAngles& previous) {
  Move move;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& model = robot.axes[axis];
    double least = std::numeric_limits<double>::infinity();
    for (int turns = -8; turns <= 8; ++turns) {
      const double joint = branch.joints[axis].value() + turns * 2.0 * kPi;
      const double excess = std::max(joint - model.max_rad, model.min_rad - joint);
      move.borderline = move.borderline || (excess > 1e-10 && excess < 1e-8);
      if (excess <= 2e-9) least = std::min(least, std::fabs(joint - previous[axis].value()));
    }
    move.time_s = std::max(move.time_s, least / model.max_speed_rad_s);
  }
  return move;
}

void expect_same(const IkTracking& one, const IkSolutions& all) {
  ASSERT_EQ(one.found, all.selected >= 0);
  ASSERT_EQ(one.status, all.status);
  ASSERT_EQ(one.singular, all.singular);
  ASSERT_EQ(one.axis, all.axis);
  ASSERT_EQ(one.configuration, all.configuration);
  ASSERT_EQ(bits(one.margin_mm), bits(all.margin_mm));
  ASSERT_EQ(bits(one.residual_rad), bits(all.residual_rad));
  if (!one.found) return;
  const JointAngles& selected = all.branches[static_cast<std::size_t>(all.selected)].joints;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    ASSERT_EQ(bits(one.joints[axis].value()), bits(selected[axis].value()));
}

TEST(ArmSoonest, IsTheSelectedBranchOfAllBitForBit) {
  test::Random random{kSoonestSeed};
  int found = 0, singular = 0, outside = 0, unreachable = 0, last_ones = 0;
  for (const RobotModel& robot : robots()) {
    const Draw draw{robot};
    const Arm arm{robot};
    for (int i = 0; i < kPosesOfARobot; ++i) {
      SCOPED_TRACE("seed " + std::to_string(kSoonestSeed) + " pose " + std::to_string(i));
      PerAxis<double> joints;
      const Transform pose = draw.pose(random, i % kPoseKinds, joints);
      const JointAngles previous = draw.previous(random, i / kPoseKinds % kPreviousKinds, joints);
      const IkSolutions all = arm.inverse(pose, previous);
      ASSERT_NO_FATAL_FAILURE(expect_same(arm.soonest(pose, previous), all));
      found += all.selected >= 0;
      singular += all.singular != 0;
      outside += all.status == IkStatus::kOutsideLimits;
      unreachable += all.status == IkStatus::kUnreachable;
      last_ones += all.selected >= 4;
    }
  }
  EXPECT_GT(found, 80'000);
  EXPECT_GT(singular, 10'000);
  EXPECT_GT(outside, 3'000);
  EXPECT_GT(unreachable, 1'000);
  EXPECT_GT(last_ones, 10'000) << "branches of the other shoulder win, too";
}

TEST(ArmSoonest, TakesNoLongerThanAnyTurnsOfAnyBranch) {
  test::Random random{kSoonestSeed + 1};
  int compared = 0;
  for (const RobotModel& robot : robots()) {
    const Draw draw{robot};
    const Arm arm{robot};
    for (int i = 0; i < kPosesOfARobot / 5; ++i) {
      SCOPED_TRACE("seed " + std::to_string(kSoonestSeed + 1) + " pose " + std::to_string(i));
      PerAxis<double> joints;
      const Transform pose = draw.pose(random, i % kPoseKinds, joints);
      const JointAngles previous = draw.previous(random, i / kPoseKinds % (kPreviousKinds - 1), joints);
      const IkSolutions all = arm.inverse(pose, previous);
      double least_s = std::numeric_limits<double>::infinity();
      bool borderline = false;
      for (std::size_t branch = 0; branch < all.count; ++branch) {
        const Move move = least_move(robot, all.branches[branch], previous);
        least_s = std::min(least_s, move.time_s);
        borderline = borderline || move.borderline;
      }
      if (borderline) continue;
      const IkTracking one = arm.soonest(pose, previous);
      ASSERT_EQ(one.found, std::isfinite(least_s));
      if (!one.found) continue;
      ++compared;
      double time_s = 0.0;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const AxisModel& model = robot.axes[axis];
        ASSERT_GE(one.joints[axis].value(), model.min_rad);
        ASSERT_LE(one.joints[axis].value(), model.max_rad);
        time_s = std::max(time_s, std::fabs((one.joints[axis] - previous[axis]).value()) / model.max_speed_rad_s);
      }
      ASSERT_NEAR(time_s, least_s, 1e-8);
      EXPECT_LT(test::position_error_mm(arm.forward(one.joints), pose), 1e-5);
    }
  }
  EXPECT_GT(compared, 15'000);
}

TEST(ArmSoonest, IsThatOfARequestedConfiguration) {
  test::Random random{kSoonestSeed + 2};
  const RobotModel robot = robots()[0];
  const Draw draw{robot};
  const Arm arm{robot};
  for (int i = 0; i < 3'000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSoonestSeed + 2) + " pose " + std::to_string(i));
    PerAxis<double> joints;
    const Transform pose = draw.pose(random, i % kPoseKinds, joints);
    const JointAngles previous = draw.previous(random, i % kPreviousKinds, joints);
    Configuration wanted{.shoulder = static_cast<ShoulderSide>(random.integer(0, 2)),
                         .elbow = static_cast<ElbowSide>(random.integer(0, 2)),
                         .wrist = static_cast<WristSide>(random.integer(0, 2))};
    if (i % 3 == 0) wanted.turns = Turns{0, 0, 0, 0, 0, 1};
    ASSERT_NO_FATAL_FAILURE(expect_same(arm.soonest(pose, previous, wanted), arm.inverse(pose, previous, wanted)));
  }
}

TEST(ArmSoonest, PassesOnWhyThereIsNoAnswer) {
  const Arm arm{robots()[0]};
  Transform pose = arm.forward({});
  JointAngles nowhere{};
  nowhere[3] = Radians{std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(arm.soonest(pose, nowhere).status, IkStatus::kInvalidInput);
  pose.rotation(0, 0) += 0.1;
  EXPECT_EQ(arm.soonest(pose, {}).status, IkStatus::kInvalidInput);
  EXPECT_EQ(Arm{test::paper_robot()}.soonest({}, {}).status, IkStatus::kInvalidInput);
}

}  // namespace
}  // namespace armature
