#include "controller/language/job/state/rconf.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

using test::degrees;
using test::kDeg;

// An arm whose wrist turns by more than half a turn, so that all bits matter.
RobotModel turning_arm() {
  RobotModel robot = test::irb120();
  for (const std::size_t axis : {0U, 3U, 5U}) {
    robot.axes[axis].min_rad = -350.0 * kDeg;
    robot.axes[axis].max_rad = 350.0 * kDeg;
  }
  return robot;
}

struct DrawnJoints {
  JointAngles joints{}, previous{};
};

DrawnJoints draw_joints(test::Random& random, const RobotModel& robot) {
  DrawnJoints drawn;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& limits = robot.axes[axis];
    drawn.joints[axis] = Radians{random.real(limits.min_rad, limits.max_rad)};
    drawn.previous[axis] = Radians{random.real(limits.min_rad, limits.max_rad)};
  }
  return drawn;
}

bool near_singularity(const Arm& arm, const JointAngles& joints) {
  const Manipulability away = arm.manipulability(joints);
  return std::min({away.shoulder, away.elbow, away.wrist}) < 0.02;
}

TEST(Rconf, GivesBackTheJointsOfAPoseInTheirPosture) {
  const RobotModel robot = turning_arm();
  const Arm arm{robot};
  test::Random random{1510};
  int compared = 0;
  for (int draw = 0; draw < test::draws(20'000); ++draw) {
    const auto [joints, previous] = draw_joints(random, robot);
    if (near_singularity(arm, joints)) continue;
    ++compared;
    const auto found = joints_of(robot, arm, arm.forward(joints), rconf_of(arm, joints), previous);
    ASSERT_TRUE(found) << "seed 1510, draw " << draw;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_NEAR(found->joints[axis].value(), joints[axis].value(), 1e-9)
          << "seed 1510, draw " << draw << ", axis " << axis;
    }
  }
  EXPECT_GT(compared, test::draws(20'000) / 2);
}

TEST(Rconf, NamesTheSidesAndTurns) {
  const RobotModel robot = turning_arm();
  const Arm arm{robot};
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, 0, 60, 0})), 0b000000);
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, 120, 60, 0})), 0b000001);
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, -100, 60, 0})), 0b000001);
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, 200, 60, 0})), 0b001001);
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, 300, 60, 0})), 0b001000);
  EXPECT_EQ(rconf_of(arm, degrees({0, 10, 20, 0, 60, -190})), 0b010000);
  EXPECT_EQ(rconf_of(arm, degrees({190, 10, 20, 0, 60, 0})), 0b100000);
  EXPECT_EQ(rconf_of(arm, degrees({0, -100, 20, 0, 60, 0})) & 0b100, 0b100);
}

// The joints of a posture that differ from these by whole turns, and are within the limits.
int others_of(const RobotModel& robot, const Arm& arm, const JointAngles& joints) {
  int others = 0;
  const auto inside = [&robot](const JointAngles& turned) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double angle = turned[axis].value();
      if (angle < robot.axes[axis].min_rad || angle > robot.axes[axis].max_rad) return false;
    }
    return true;
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int turns : {-2, -1, 1, 2}) {
      JointAngles turned = joints;
      turned[axis] = Radians{joints[axis].value() + 2.0 * std::numbers::pi * turns};
      if (inside(turned) && rconf_of(arm, turned) == rconf_of(arm, joints)) ++others;
    }
  }
  return others;
}

TEST(Rconf, SaysWhetherThePreviousJointsDecide) {
  RobotModel robot = turning_arm();
  robot.axes[5].min_rad = -400.0 * kDeg;
  robot.axes[5].max_rad = 400.0 * kDeg;
  robot.axes[2].min_rad = -250.0 * kDeg;  // the posture says nothing about its turns
  robot.axes[2].max_rad = 200.0 * kDeg;
  const Arm arm{robot};
  test::Random random{1511};
  int only = 0, several = 0;
  for (int draw = 0; draw < test::draws(20'000); ++draw) {
    const auto [joints, previous] = draw_joints(random, robot);
    if (near_singularity(arm, joints)) continue;
    const auto found = joints_of(robot, arm, arm.forward(joints), rconf_of(arm, joints), previous);
    ASSERT_TRUE(found) << "seed 1511, draw " << draw;
    EXPECT_FALSE(found->free_angle) << "seed 1511, draw " << draw;
    EXPECT_EQ(found->several_turns, others_of(robot, arm, joints) > 0) << "seed 1511, draw " << draw;
    ++(found->several_turns ? several : only);
  }
  EXPECT_GT(only, test::draws(20'000) / 10);
  EXPECT_GT(several, test::draws(20'000) / 10);
  // At the wrist singularity axis 4 is where it was.
  const auto stretched =
      joints_of(robot, arm, arm.forward(degrees({0, 10, 20, 0, 0, 0})), 0, degrees({0, 0, 0, 30, 0, 0}));
  ASSERT_TRUE(stretched);
  EXPECT_TRUE(stretched->free_angle);
  EXPECT_NEAR(stretched->joints[3].value(), 30 * kDeg, 1e-12);
}

TEST(Rconf, FindsNothingOutOfReachOrInAPostureOutsideTheLimits) {
  const RobotModel robot = test::irb120();
  const Arm arm{robot};
  const JointAngles joints = degrees({0, 10, 20, 0, 60, 0});
  const Transform pose = arm.forward(joints);
  EXPECT_TRUE(joints_of(robot, arm, pose, 0, joints));
  EXPECT_FALSE(joints_of(robot, arm, pose, 0b100000, joints));  // axis 1 has no second turn
  Transform far = pose;
  far.position_mm.x() += 2'000;
  EXPECT_FALSE(joints_of(robot, arm, far, 0, joints));
}

}  // namespace
}  // namespace armature::job
