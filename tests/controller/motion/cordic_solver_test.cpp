// The set-points that ik_cordic solves, on the model of the logic.
#include "controller/motion/cordic/cordic_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "controller/kinematics/arm.hpp"
#include "controller/regs/ik_cordic_regs.hpp"
#include "tests/controller/support/cartesian_moves.hpp"
#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

namespace reg = regs::ik_cordic;

constexpr RegAddr kBlock{regs::soc::kIkCordicBase};
constexpr double kPulse_rad = 2.0 * std::numbers::pi / 500'000.0;

RawTracking track(CordicSolver& solver, const Transform& pose, const Theta& near) {
  return solver.track(pose, near, SixR::kTrackingWristZone, false);
}

class CordicSolverTest : public testing::Test {
 protected:
  explicit CordicSolverTest(const ArmGeometry& arm = test::irb120_geometry()) : robot{test::robot_with(arm)} {
    solver.start();
  }

  RobotModel robot;
  test::ModelLogic logic;
  CordicSolver solver{logic, robot};
  SixR software{robot.arm};
  // Every branch: shoulder, elbow and flip of both signs.
  static constexpr Theta kFront{0.4, 1.2, 0.7, 0.5, 0.9, -0.3};
};

TEST_F(CordicSolverTest, TakesTheBranchOfTheSoftwareAndTheAnglesOfTheBlock) {
  test::Random random{64};
  std::uint32_t solved = 0;
  int different_bits = 0;
  for (int i = 0; i < 200; ++i) {
    const Theta theta = test::random_angles(random);
    const Manipulability is = software.manipulability(theta);
    const RawTracking found = track(solver, software.forward(theta), theta);
    ASSERT_TRUE(found.found);
    const bool regular = std::min({is.shoulder, is.elbow, is.wrist}) >= CordicSolver::kLeastSine;
    solved += regular ? 1 : 0;
    for (std::size_t joint = 0; joint < kAxes; ++joint) {
      ASSERT_NEAR(found.theta[joint], theta[joint], regular ? 0.2 * kPulse_rad : 1e-6) << i << ", joint " << joint;
    }
    different_bits += found.theta != software.track(software.forward(theta), theta).theta ? 1 : 0;
  }
  EXPECT_EQ(solver.check().solved, solved);
  EXPECT_GT(solved, 100u);
  EXPECT_EQ(different_bits, static_cast<int>(solved)) << "the block has fewer digits";
  EXPECT_FALSE(solver.check().differs);
  EXPECT_GT(solver.check().difference_pulses, 0.001);
}

TEST_F(CordicSolverTest, KeepsTheTurnsOfThePreviousAngles) {
  Theta turned = kFront;
  turned[0] += 2 * std::numbers::pi;
  turned[5] -= 4 * std::numbers::pi;
  const RawTracking found = track(solver, software.forward(turned), turned);
  for (std::size_t joint = 0; joint < kAxes; ++joint) EXPECT_NEAR(found.theta[joint], turned[joint], 0.1 * kPulse_rad);
}

TEST_F(CordicSolverTest, LeavesSingularPosesToTheSoftware) {
  Theta wrist = kFront, elbow = kFront;
  wrist[4] = 0.04;
  elbow[2] = std::atan2(robot.arm.d4_mm, robot.arm.a3_mm) + 0.04;
  for (const Theta& theta : {wrist, elbow}) {
    const Transform pose = software.forward(theta);
    EXPECT_EQ(track(solver, pose, theta).theta, software.track(pose, theta).theta);
  }
  const Transform pose = software.forward(kFront);
  EXPECT_EQ(solver.track(pose, kFront, SixR::kKeepTheta4, false).theta,
            software.track(pose, kFront, SixR::kKeepTheta4).theta);
  EXPECT_EQ(solver.check().solved, 0u);
}

TEST_F(CordicSolverTest, SaysWhichAxisDiffersByMoreThanTheStatedError) {
  const Transform pose = software.forward(kFront);
  ASSERT_FALSE(solver.check().differs);
  const std::int32_t right = binary_angle(track(solver, pose, kFront).theta[1]);
  constexpr std::int32_t kStated = 112;  // 0.013 pulses of 8590 steps
  const RegAddr theta_2 = kBlock + (reg::kThetaOffset + 4);
  logic.planted.plant(theta_2, static_cast<std::uint32_t>(right + kStated / 2));
  EXPECT_FALSE((static_cast<void>(track(solver, pose, kFront)), solver.check().differs));
  logic.planted.plant(theta_2, static_cast<std::uint32_t>(right + 3 * kStated));
  EXPECT_EQ(track(solver, pose, kFront).theta, software.track(pose, kFront).theta);
  EXPECT_TRUE(solver.check().differs);
  EXPECT_EQ(solver.check().differing_axis, 2);
  EXPECT_EQ(solver.check().solved, 2u);
}

TEST_F(CordicSolverTest, SaysThatTheBlockDoesNotAnswer) {
  logic.planted.plant(kBlock + reg::kStatusOffset, reg::kStatusBusyMask);
  const Transform pose = software.forward(kFront);
  EXPECT_EQ(track(solver, pose, kFront).theta, software.track(pose, kFront).theta);
  EXPECT_TRUE(solver.check().differs);
  EXPECT_EQ(solver.check().differing_axis, 0);
}

class FiveAxisCordicSolver : public CordicSolverTest {
 protected:
  FiveAxisCordicSolver() : CordicSolverTest{test::hu_arm(1.1)} {}
};

TEST_F(FiveAxisCordicSolver, SolvesThePoseThatTheArmCanReach) {
  const FiveR five_r{robot.arm};
  const Theta theta{0.3, -0.8, 1.1, 0.4, 0.6, 0.0};
  for (const double elbow : {1.1, -1.1}) {
    Theta near = theta;
    near[2] = elbow;
    const RawTracking found = track(solver, five_r.forward(near), near);
    ASSERT_TRUE(found.found);
    for (std::size_t joint = 0; joint < 5; ++joint) EXPECT_NEAR(found.theta[joint], near[joint], 0.05 * kPulse_rad);
  }
  EXPECT_EQ(solver.check().solved, 2u);
}

class CordicController : public test::CartesianMovesTest {
 protected:
  static ControllerConfig with_cordic() {
    ControllerConfig config = CartesianMovesTest::config();
    config.cordic = true;
    return config;
  }
  test::ControllerRig cordic{test::irb120(), with_cordic()};
};

TEST_F(CordicController, EachSetPointOfALineIsSolvedByTheBlock) {
  cordic.move_at(0, test::kPostureDeg);
  cordic.submit_at(test::kThere, shift(30, 0, 0));
  cordic.run(test::kThere + 12'000);
  EXPECT_EQ(cordic.moves_finished(), 2);
  EXPECT_TRUE(cordic.faults.empty());
  EXPECT_EQ(cordic.rows.back().solved_poses, static_cast<std::uint32_t>(cordic.moves[1].duration.value() - 1));
  EXPECT_LT(cordic.rows.back().solver_difference_pulses, 0.1);
}

TEST_F(CordicController, ADifferenceStopsTheArm) {
  const RegAddr theta_3 = kBlock + (reg::kThetaOffset + 8);
  cordic.move_at(0, test::kPostureDeg);
  cordic.submit_at(test::kThere, shift(30, 0, 0));
  for (std::uint32_t branch = 0; branch < 8; ++branch) cordic.logic.planted.plant(theta_3 + 24 * branch, 12'345);
  cordic.run(test::kThere + 4'000);
  ASSERT_EQ(cordic.faults.size(), 1u);
  EXPECT_EQ(cordic.faults[0].cause, FaultCause::kInverseKinematics);
  EXPECT_EQ(cordic.faults[0].axis, 3);
  EXPECT_EQ(cordic.rows.back().solved_poses, 0u);
}

TEST_F(CordicController, RefusesALogicWithoutTheBlock) {
  cordic.logic.planted.plant(kBlock, 0xBADA'CCE5);
  cordic.run(100);
  ASSERT_EQ(cordic.faults.size(), 1u);
  EXPECT_EQ(cordic.faults[0].cause, FaultCause::kHardwareId);
}

}  // namespace
}  // namespace armature
