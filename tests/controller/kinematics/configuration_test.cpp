// The configuration of an arm, against geometry written apart from the kinematics: where elbow and wrist are in space.
#include "controller/kinematics/configuration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <set>
#include <tuple>

#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

constexpr std::uint64_t kConfigurationSeed = 20'261'122;

using Sides = std::tuple<ShoulderSide, ElbowSide, WristSide>;

Sides sides_of(const Configuration& c) {
  return {c.shoulder, c.elbow, c.wrist};
}

JointAngles random_joints(test::Random& random, double largest_rad = 3.1) {
  JointAngles joints;
  for (Radians& joint : joints) joint = Radians{random.real(-largest_rad, largest_rad)};
  return joints;
}

// The centre of the elbow (axis 3) in the base frame, by the first two links alone.
Eigen::Vector3d elbow_mm(const ArmGeometry& arm, double theta1, double theta2) {
  const double r = arm.a1_mm + arm.a2_mm * std::cos(theta2);
  return {r * std::cos(theta1), r * std::sin(theta1), arm.d1_mm + arm.a2_mm * std::sin(theta2)};
}

TEST(Configuration, NamesTheSidesThatTheLinksShowInSpace) {
  test::Random random{kConfigurationSeed};
  std::set<Sides> seen;
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const Arm arm{test::robot_with(geometry)};
    for (int i = 0; i < 1000; ++i) {
      const JointAngles joints = random_joints(random);
      const auto theta = [&](std::size_t axis) {
        return geometry.sign[axis] * joints[axis].value() + geometry.offset_rad[axis];
      };
      const Transform flange = arm.forward(joints);
      const Eigen::Vector3d wrist = flange.position_mm - geometry.d6_mm * flange.rotation.col(2);
      const Eigen::Vector3d ahead{std::cos(theta(0)), std::sin(theta(0)), 0.0};
      const double reach = ahead.dot(wrist);
      // The wrist between axes 1 and 2 is in front of one and behind the other: "above" has no meaning in space.
      if (std::fabs(reach) < 1.0 || (reach > 0.0 && reach < geometry.a1_mm + 1.0)) continue;
      const Eigen::Vector3d axis2 = geometry.a1_mm * ahead + Eigen::Vector3d{0, 0, geometry.d1_mm};
      const Eigen::Vector3d to_wrist = wrist - axis2, to_elbow = elbow_mm(geometry, theta(0), theta(1)) - axis2;
      // Height of the elbow over the line from joint 2 to the wrist, in the plane of the arm.
      const double share = ahead.dot(to_elbow) / ahead.dot(to_wrist);
      const double above = to_elbow.z() - share * to_wrist.z();
      // The hand bends down if it is below the forearm's axis when joint 4 is turned back to 0.
      JointAngles straight = joints;
      straight[3] = Radians{geometry.sign[3] * (0.0 - geometry.offset_rad[3])};
      const double up = arm.forward(straight).rotation.col(2).dot(
          Eigen::AngleAxisd{theta(0), Eigen::Vector3d::UnitZ()} *
          Eigen::Vector3d{std::cos(theta(1) + theta(2)), 0.0, std::sin(theta(1) + theta(2))});

      const Configuration found = arm.configuration(joints);
      ASSERT_EQ(found.shoulder, reach > 0.0 ? ShoulderSide::kFront : ShoulderSide::kBack) << i;
      ASSERT_EQ(found.elbow, above > 0.0 ? ElbowSide::kUp : ElbowSide::kDown) << i;
      ASSERT_EQ(found.wrist, up > 0.0 ? WristSide::kFlip : WristSide::kNoflip) << i;
      seen.insert(sides_of(found));
    }
  }
  EXPECT_EQ(seen.size(), 8u);
}

TEST(Configuration, OfABranchIsThatOfItsJoints) {
  test::Random random{kConfigurationSeed + 1};
  int branches = 0;
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const Arm arm{test::robot_with(geometry)};
    for (int i = 0; i < 500; ++i) {
      const IkSolutions solutions = arm.inverse(arm.forward(random_joints(random)), {});
      std::set<Sides> different;
      for (std::size_t b = 0; b < solutions.count; ++b, ++branches) {
        const IkBranch& branch = solutions.branches[b];
        ASSERT_EQ(sides_of(Arm::configuration(branch)), sides_of(arm.configuration(branch.joints)));
        different.insert(sides_of(Arm::configuration(branch)));
      }
      ASSERT_EQ(different.size(), solutions.count) << "each branch has a configuration of its own";
    }
  }
  EXPECT_GT(branches, 9000);
}

TEST(Configuration, SelectsTheSolutionThatWasAskedFor) {
  test::Random random{kConfigurationSeed + 2};
  const Arm arm{test::robot_with(test::lrmate200id())};
  for (int i = 0; i < 2000; ++i) {
    const JointAngles wanted_joints = random_joints(random, 6.9);
    const Configuration wanted = arm.configuration(wanted_joints);
    const Transform pose = arm.forward(wanted_joints);
    const IkSolutions solutions = arm.inverse(pose, random_joints(random), wanted);
    ASSERT_GE(solutions.selected, 0) << i;
    const JointAngles& found = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_NEAR(found[axis].value(), wanted_joints[axis].value(), 1e-6) << i << ", axis " << axis + 1;
    }
    ASSERT_EQ(solutions.count, 1u);
  }
}

TEST(Configuration, ARequestForOneSideLeavesTheOthersNearest) {
  const Arm arm{test::robot_with(test::irb120_geometry())};
  const JointAngles here = test::degrees({10, 20, -20, 30, 40, 50});
  const Transform pose = arm.forward(here);
  const Configuration wanted{.elbow = ElbowSide::kUp, .wrist = WristSide::kFlip};
  const IkSolutions flipped = arm.inverse(pose, here, wanted);
  ASSERT_EQ(arm.configuration(here).wrist, WristSide::kNoflip);
  ASSERT_GE(flipped.selected, 0);
  EXPECT_EQ(flipped.count, 2u) << "in front and behind";
  const JointAngles& joints = flipped.branches[static_cast<std::size_t>(flipped.selected)].joints;
  for (const std::size_t axis : {0u, 1u, 2u}) EXPECT_NEAR(joints[axis].value(), here[axis].value(), 1e-12);
  EXPECT_NEAR(joints[4].value(), -here[4].value(), 1e-12);
}

TEST(Configuration, WithoutASolutionSaysWhichPartIsMissing) {
  const Arm arm{test::robot_with(test::kr6_r900())};
  // Far in front of the robot: the arm does not reach it backwards.
  const JointAngles joints = test::degrees({0, 0, 10, 0, 30, 0});
  const Transform pose = arm.forward(joints);
  ASSERT_EQ(arm.inverse(pose, joints).count, 4u) << "the premise";
  const IkSolutions back = arm.inverse(pose, joints, {.shoulder = ShoulderSide::kBack, .wrist = WristSide::kFlip});
  EXPECT_EQ(back.status, IkStatus::kConfiguration);
  EXPECT_EQ(back.configuration, kShoulderPart);
  EXPECT_EQ(back.selected, -1);
  EXPECT_FALSE(solved(back.status));
}

TEST(Configuration, TurnsBeyondTheLimitsAreOutsideThem) {
  const Arm arm{test::robot_with(test::irb120_geometry())};  // every joint up to 400 deg
  const JointAngles here = test::degrees({0, 0, 0, 0, 90, 50});
  Turns turns{};
  turns[5] = 1;
  Configuration wanted = arm.configuration(here);
  wanted.turns = turns;
  IkSolutions solutions = arm.inverse(arm.forward(here), here, wanted);
  EXPECT_EQ(solutions.status, IkStatus::kOutsideLimits);
  EXPECT_EQ(solutions.axis, 6) << "410 deg";
  EXPECT_NEAR(solutions.angle_rad, 410 * test::kDeg, 1e-9);
  turns[5] = -1;
  wanted.turns = turns;
  solutions = arm.inverse(arm.forward(here), here, wanted);
  ASSERT_GE(solutions.selected, 0);
  EXPECT_NEAR(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints[5].value(),
              (50 - 360) * test::kDeg, 1e-9);
  turns[5] = 2;
  wanted.turns = turns;
  solutions = arm.inverse(arm.forward(test::degrees({0, 0, 0, 0, 90, 40})), here, wanted);
  EXPECT_EQ(solutions.status, IkStatus::kOutsideLimits) << "40 deg is 400 deg, the limit, which has one turn";
  EXPECT_EQ(solutions.axis, 6);
  EXPECT_NEAR(solutions.angle_rad, (40 + 720) * test::kDeg, 1e-9);
}

TEST(Configuration, ASideIsUndeterminedAtItsSingularity) {
  const Arm arm{test::robot_with(test::irb120_geometry())};
  EXPECT_EQ(arm.configuration(test::degrees({0, 0, 0, 0, 0, 0})).wrist, WristSide::kNearest);
  const double stretched = std::atan2(70.0, 302.0) / test::kDeg - 90.0;
  const Configuration straight = arm.configuration(test::degrees({0, 60, stretched, 0, 40, 0}));
  EXPECT_EQ(straight.elbow, ElbowSide::kNearest);
  EXPECT_EQ(straight.shoulder, ShoulderSide::kFront);
  EXPECT_EQ(differing_sides({.elbow = ElbowSide::kUp}, straight), 0) << "an undetermined side fits any request";
}

TEST(Configuration, CountsTurnsFromTheBackOfEachJoint) {
  for (const auto& [deg, turns] : {std::pair{0, 0}, {179, 0}, {181, 1}, {539, 1}, {541, 2}, {-181, -1}, {-539, -1}}) {
    EXPECT_EQ(turns_of(deg * test::kDeg), turns) << deg;
    EXPECT_TRUE(has_turns(deg * test::kDeg, static_cast<std::int8_t>(turns))) << deg;
    EXPECT_FALSE(has_turns(deg * test::kDeg, static_cast<std::int8_t>(turns + 1))) << deg;
  }
  EXPECT_TRUE(has_turns(180 * test::kDeg, 0));
  EXPECT_TRUE(has_turns(180 * test::kDeg, 1));
}

}  // namespace
}  // namespace armature
