// The integers of ik_cordic against the kinematics of the controller in double arithmetic, and the widths of its words
// for any contents of its registers.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/six_r_rig.hpp"
#include "tests/support/ik_jobs.hpp"
#include "tests/support/random_ik_jobs.hpp"

namespace armature::test {
namespace {

// Largest errors of a branch, in units of what is allowed.
struct Worst {
  double angle = 0.0, rotation = 0.0, position = 0.0;

  void add(double angle_now, double rotation_now, double position_now) {
    angle = std::max(angle, angle_now);
    rotation = std::max(rotation, rotation_now);
    position = std::max(position, position_now);
  }
  void expect_at_most_1() const {
    EXPECT_LE(angle, 1.0);
    EXPECT_LE(rotation, 1.0);
    EXPECT_LE(position, 1.0);
  }
};

// The reach in units, and so the resolution, differs between arms by up to a factor of 2.
TEST(IkCordicRandom, SixRHasTheBranchesOfTheController) {
  Random random{20121};
  for (const ArmGeometry& arm : vendor_arms()) {
    const SixR six_r{arm};
    const FixedArm fixed = fixed_arm(arm).value();
    const double phi = std::atan2(arm.d4_mm, arm.a3_mm), unit_mm = std::ldexp(1.0, fixed.unit_exponent);
    Worst worst;
    int at_the_limit = 0;
    const int poses = 4000;
    for (int i = 0; i < poses; ++i) {
      const Theta truth = random_angles(random), previous = random_angles(random);
      const Transform pose = six_r.forward(truth);
      const RawSolutions exact = six_r.inverse(pose, previous);
      const ik::Solved solved = solve(job_of(fixed, fixed_pose(pose, fixed).value(), previous));
      ASSERT_FALSE(solved.exceeded);
      const RawSides sides = six_r.sides(truth);
      if (std::fabs(sides.flip) < 1e-5 || std::fabs(sides.elbow) < 1e-3 || std::fabs(sides.shoulder) < 1e-4) continue;
      if (std::popcount(solved.valid) != static_cast<int>(exact.count)) {
        ++at_the_limit;  // the other shoulder just reaches, or its wrist is singular
        continue;
      }
      for (std::size_t n = 0; n < exact.count; ++n) {
        const RawBranch& branch = exact.branches[n];
        const std::size_t index = branch_index(branch.shoulder, branch.elbow, branch.flip);
        ASSERT_EQ(solved.valid >> index & 1, 1);
        const Theta theta = theta_of(solved, index);
        const double bent = std::fabs(std::sin(branch.theta[2] - phi)), turned = std::fabs(std::sin(branch.theta[4]));
        const double elbow = 0.03 * std::max(1.0, 0.1 / bent) / std::min(1.0, 20 * std::fabs(sides.shoulder));
        double angle = 0.0;
        for (std::size_t joint = 0; joint < 6; ++joint) {
          const double wrist = joint == 3 || joint == 5 ? std::max(1.0, 1.0 / turned) : 1.0;
          angle = std::max(angle, pulses_between(theta[joint], branch.theta[joint]) / (elbow * wrist));
        }
        const Transform reached = six_r.forward(theta);
        worst.add(angle, rotation_error(reached, pose) / 1.5e-7, position_error_mm(reached, pose) / (unit_mm * 3e-6));
      }
    }
    worst.expect_at_most_1();
    EXPECT_LE(at_the_limit, poses / 500);
  }
}

TEST(IkCordicRandom, FiveRHasTheBranchesOfTheController) {
  Random random{20122};
  const ArmGeometry arm = hu_arm();
  const FiveR five_r{arm};
  const FixedArm fixed = fixed_arm(arm).value();
  Worst worst;
  int at_the_limit = 0;
  const int poses = 8000;
  for (int i = 0; i < poses; ++i) {
    const Theta truth = random_theta(random), previous = random_theta(random);
    const Transform pose = five_r.forward(truth);
    const RawSolutions exact = five_r.inverse(pose, previous);
    const ik::Solved solved = solve(job_of(fixed, fixed_pose(pose, fixed).value(), previous));
    ASSERT_FALSE(solved.exceeded);
    if (std::popcount(solved.valid) != static_cast<int>(exact.count)) {
      ++at_the_limit;
      continue;
    }
    for (std::size_t n = 0; n < exact.count; ++n) {
      const RawBranch& branch = exact.branches[n];
      const std::size_t index = branch_index(branch.shoulder, branch.elbow, +1);
      ASSERT_EQ(solved.valid >> index & 1, 1);
      const Theta theta = theta_of(solved, index);
      double angle = 0.0;
      for (std::size_t joint = 0; joint < 5; ++joint) {
        angle = std::max(angle, pulses_between(theta[joint], branch.theta[joint]));
      }
      // The heading is known to the resolution of a length, seen from the tool point.
      const double bent = std::max(1.0, 0.05 / std::fabs(std::sin(branch.theta[2])));
      const Transform reached = five_r.forward(theta);
      worst.add(angle / (0.06 * bent), rotation_difference(reached, pose) / 5e-7,
                position_difference_mm(reached, pose) / 3e-6);
    }
  }
  worst.expect_at_most_1();
  EXPECT_LE(at_the_limit, poses / 500);
}

TEST(IkCordicRandom, NoContentsOfTheRegistersExceedAWord) {
  RandomIkJobs jobs{20123};
  int with_branches = 0, with_far = 0;
  for (int i = 0; i < 50'000; ++i) {
    const ik::Job job = jobs.next();
    const ik::Solved solved = solve(job);
    ASSERT_FALSE(solved.exceeded) << i;
    (solved.valid != 0 ? with_branches : with_far) += 1;
  }
  EXPECT_GT(with_branches, 5000);
  EXPECT_GT(with_far, 5000);
}

}  // namespace
}  // namespace armature::test
