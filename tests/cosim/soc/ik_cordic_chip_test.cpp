// The inverse kinematics of the logic through the bus of the whole chip, on each engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "controller/base/words.hpp"
#include "controller/drivers/ik_cordic.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/fixed/fixed_point.hpp"
#include "controller/kinematics/six_r.hpp"
#include "controller/motion/cordic/cordic_words.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/engine/chip_bus.hpp"
#include "cosim/engine/make_soc.hpp"
#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/six_r_rig.hpp"
#include "tests/support/ik_jobs.hpp"

namespace armature::cosim {
namespace {

namespace ik = model::ik;

class IkCordicChip : public testing::TestWithParam<Engine> {
 protected:
  // Solves the pose in the chip. Every result has the bits of the model.
  ik::Solved solve_in_chip(const FixedArm& arm, const FixedPose& pose) {
    driver_.set_geometry(geometry_words(arm));
    for (std::size_t i = 0; i < pose.rotation.size(); ++i) driver_.set_rotation(i, pose.rotation[i]);
    for (std::size_t i = 0; i < pose.position.size(); ++i) driver_.set_position(i, pose.position[i]);
    driver_.set_previous({});
    driver_.start(arm.five_r);
    const Cycles started = soc_->now();
    while (!driver_.done() && soc_->now() - started < Cycles{3'000}) {
    }
    ik::Solved solved = solve(test::job_of(arm, pose));
    EXPECT_EQ(driver_.cycles(), static_cast<std::uint32_t>(solved.clocks));
    EXPECT_EQ(driver_.branches(), solved.valid);
    for (std::size_t branch = 0; branch < IkCordic::kBranches; ++branch) {
      for (std::size_t joint = 0; joint < IkCordic::kJoints; ++joint) {
        const std::int32_t theta = driver_.theta(branch, joint);
        EXPECT_EQ(theta, solved.theta[branch][joint]) << "branch " << branch << ", joint " << joint;
        solved.theta[branch][joint] = theta;
      }
    }
    return solved;
  }

  void TearDown() override { EXPECT_EQ(bus_.failures(), 0) << "accesses without an answer, or with an error"; }

  std::unique_ptr<Soc> soc_ = make_soc(Variant::kCounts, GetParam(), BusSpec{}, 1);
  ChipBus bus_{*soc_};
  IkCordic driver_{bus_};
};
INSTANTIATE_TEST_SUITE_P(Engines, IkCordicChip, testing::Values(Engine::kRtl, Engine::kModel, Engine::kLockstep),
                         [](const auto& suite) { return std::string{word_of(suite.param)}; });

// Compares each branch of software with that of the chip, where the README of the block states an error.
void expect_the_software(const ik::Solved& solved, const RawSolutions& software, bool five_r, int& compared) {
  for (std::size_t i = 0; i < software.count; ++i) {
    const RawBranch& branch = software.branches[i];
    const std::size_t index = test::branch_index(branch.shoulder, branch.elbow, five_r ? 1 : branch.flip);
    ASSERT_NE(solved.valid >> index & 1u, 0u) << index;
    const Theta theta = test::theta_of(solved, index);
    const double wrist = five_r ? 0.013 : 0.03 + 0.0075 / std::fabs(std::sin(branch.theta[4]));
    for (std::size_t joint = 0; joint < 6; ++joint) {
      const double allowed = joint == 3 || joint == 5 ? wrist : 0.013;
      EXPECT_LE(test::pulses_between(theta[joint], branch.theta[joint]), allowed) << index << ", joint " << joint;
      ++compared;
    }
  }
}

TEST_P(IkCordicChip, SolvesPosesOfSixAxes) {
  ASSERT_TRUE(driver_.identified());
  const ArmGeometry geometry = test::irb120_geometry();
  const SixR software{geometry};
  const FixedArm arm = fixed_arm(geometry).value();
  test::Random random{61};
  int compared = 0;
  for (int i = 0; i < 12; ++i) {
    Theta theta = test::random_angles(random);
    theta[2] = std::atan2(geometry.d4_mm, geometry.a3_mm) + (i % 2 == 0 ? 1 : -1) * random.real(0.3, 2.5);
    const Transform pose = software.forward(theta);
    const ik::Solved solved = solve_in_chip(arm, fixed_pose(pose, arm).value());
    expect_the_software(solved, software.inverse(pose, {}), false, compared);
  }
  EXPECT_GT(compared, 12 * 4 * 6 - 1);
}

TEST_P(IkCordicChip, SolvesPosesOfFiveAxes) {
  const ArmGeometry geometry = test::hu_arm(1.1);
  const FiveR software{geometry};
  const FixedArm arm = fixed_arm(geometry).value();
  test::Random random{62};
  int compared = 0;
  for (int i = 0; i < 12; ++i) {
    Theta theta = test::random_angles(random);
    theta[2] = (i % 2 == 0 ? 1 : -1) * random.real(0.3, 2.5);
    theta[5] = 0;
    const Transform pose = software.forward(theta);
    const ik::Solved solved = solve_in_chip(arm, fixed_pose(pose, arm).value());
    expect_the_software(solved, software.inverse(pose, {}), true, compared);
  }
  EXPECT_GT(compared, 12 * 2 * 6 - 1);
}

}  // namespace
}  // namespace armature::cosim
