// The integers of ik_cordic against the reference vectors with 50 digits: every branch of every pose, in pulses.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>

#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/six_r_rig.hpp"
#include "tests/support/ik_jobs.hpp"

namespace armature::test {
namespace {

using nlohmann::json;

// What the widths promise where the elbow is bent by sin >= 0.05.
constexpr PerAxis<double> kFiveRPulses{0.02, 0.03, 0.04, 0.05, 0.03, 0.0};
constexpr PerAxis<double> kSixRPulses{0.02, 0.03, 0.04, 0.03, 0.03, 0.03};
constexpr double kWristPulses = 0.0075;  // of theta_4 and theta_6, over sin(theta_5)
constexpr double kBent = 0.05;

void expect_flags_of(const json& expected, const ik::Solved& solved, std::size_t branch) {
  const int singular = expected["sing"], shoulder = branch < 4 ? 0 : 1;
  EXPECT_EQ(solved.valid >> branch & 1, 1);
  EXPECT_EQ(solved.elbow_singular >> shoulder & 1, (singular & kElbowSingular) != 0 ? 1 : 0);
  EXPECT_EQ(solved.wrist_singular >> branch / 2 & 1, (singular & kWristSingular) != 0 ? 1 : 0);
  EXPECT_EQ(solved.folded, 0);
}

TEST(IkCordicReference, SixRIsWithinAFractionOfAPulse) {
  const json reference = read_reference("ik6r_abb_irb120.json");
  const FixedArm arm = fixed_arm(irb120_geometry()).value();
  int compared = 0;
  for (const json& pose : reference["poses"]) {
    SCOPED_TRACE(pose["q_vendor_deg"].dump());
    const ik::Solved solved = solve(job_of(arm, fixed_pose(transform_of(pose["T"]), arm).value()));
    EXPECT_FALSE(solved.exceeded);
    EXPECT_FALSE(solved.shoulder_singular);
    ASSERT_EQ(std::popcount(solved.valid), static_cast<int>(pose["branches"].size()));
    for (const json& expected : pose["branches"]) {
      const std::size_t branch = branch_index(expected["shoulder"], expected["elbow"], expected["flip"]);
      expect_flags_of(expected, solved, branch);
      if (pose["cond"]["elbow"].get<double>() < kBent) continue;
      const Theta theta = theta_of(solved, branch), exact = expected["theta"].get<Theta>();
      for (std::size_t joint = 0; joint < 6; ++joint) {
        const double wrist = joint == 3 || joint == 5 ? kWristPulses / std::fabs(std::sin(exact[4])) : 0.0;
        EXPECT_LE(pulses_between(theta[joint], exact[joint]), kSixRPulses[joint] + wrist) << "theta_" << joint + 1;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 9000);
}

TEST(IkCordicReference, FiveRIsWithinAFractionOfAPulse) {
  const json reference = read_reference("ik5r.json");
  const FixedArm arm = fixed_arm(hu_arm()).value();
  const auto check = [&](const json& rows, const json& branches) {
    const ik::Solved solved = solve(job_of(arm, fixed_pose(transform_of(rows), arm).value()));
    EXPECT_FALSE(solved.exceeded);
    EXPECT_EQ(std::popcount(solved.valid), static_cast<int>(branches.size()));
    for (const json& expected : branches) {
      const std::size_t branch = branch_index(expected["shoulder"], expected["elbow"], +1);
      expect_flags_of(expected, solved, branch);
      const Theta theta = theta_of(solved, branch);
      const double bent = std::fabs(std::sin(expected["theta"][2].get<double>()));
      for (std::size_t joint = 0; joint < 5; ++joint) {
        EXPECT_LE(pulses_between(theta[joint], expected["theta"][joint]),
                  kFiveRPulses[joint] * std::max(1.0, kBent / bent))
            << "theta_" << joint + 1;
      }
    }
  };
  for (const json& pose : reference["poses"]) {
    SCOPED_TRACE(pose["theta_deg"].dump());
    check(pose["T"], pose["branches"]);
  }
  for (const json& pose : reference["projection"]) {
    SCOPED_TRACE(pose["T_in"].dump());
    check(pose["T_projected"], pose["branches"]);
  }
}

// The values that Figure 2 of Hu 2012 prints contain no solution; the pose has one double root, (0, -90, 0, -90, 0)
// deg.
TEST(IkCordicReference, EdgesOfTheFiveRHaveTheirBranches) {
  const json reference = read_reference("ik5r.json");
  for (const json& edge : reference["edges"]) {
    SCOPED_TRACE(edge["kind"].get<std::string>());
    const FixedArm arm = fixed_arm(hu_arm(edge["a1"])).value();
    const bool is_free = edge["kind"] == "axis1_and_vertical";
    const Theta previous{0.3, 0.0, 0.0, 0.0, 0.0, 0.0};
    const ik::Solved solved = solve(job_of(arm, fixed_pose(transform_of(edge["T"]), arm).value(), previous));
    EXPECT_EQ(solved.shoulder_singular, is_free);
    ASSERT_EQ(std::popcount(solved.valid), edge["n"].get<int>());
    for (const json& expected : edge["branches"]) {
      const std::size_t branch = branch_index(expected["shoulder"], expected["elbow"], +1);
      ASSERT_EQ(solved.valid >> branch & 1, 1);
      const Theta theta = theta_of(solved, branch);
      for (std::size_t joint = 0; joint < 5; ++joint) {
        EXPECT_LE(pulses_between(theta[joint], expected["theta"][joint]), 0.02) << "theta_" << joint + 1;
      }
    }
  }
}

// Near the singularities angles are ill-conditioned, so the pose is compared. A zone of the block is wider than that of
// the software (1e-9): inside it theta_4 is the previous one, and such a branch stands for both flips.
TEST(IkCordicReference, EdgesOfTheSixRHaveTheirBranches) {
  const json reference = read_reference("ik6r_abb_irb120.json");
  const SixR six_r{irb120_geometry()};
  int held = 0;
  for (const json& edge : reference["edges"]) {
    const std::string kind = edge["kind"];
    SCOPED_TRACE(kind + edge["T"].dump());
    const Transform pose = transform_of(edge["T"]);
    const Theta previous = edge["prev_theta"].get<Theta>();
    const ik::Solved solved = solve(job_of(irb120_geometry(), pose, previous));
    EXPECT_FALSE(solved.exceeded);
    EXPECT_EQ(solved.shoulder_singular, kind == "shoulder_singular");
    if (edge["n"] == 0) EXPECT_EQ(solved.valid, 0);
    for (const json& expected : edge["branches"]) {
      const std::size_t branch = branch_index(expected["shoulder"], expected["elbow"], expected["flip"]);
      const int singular = expected["sing"];
      EXPECT_EQ(solved.elbow_singular >> branch / 4 & 1, (singular & kElbowSingular) != 0 ? 1 : 0);
      const bool holds_theta4 = (solved.wrist_singular >> branch / 2 & 1) != 0;
      if ((singular & kWristSingular) != 0) EXPECT_TRUE(holds_theta4);
      if (holds_theta4) {
        EXPECT_LT(std::fabs(std::sin(expected["theta"][4].get<double>())), 7.1e-7);
        EXPECT_LT(pulses_between(theta_of(solved, branch & ~std::size_t{1})[3], previous[3]), 1e-3);
        if ((singular & kWristSingular) == 0) ++held;
      }
      const std::size_t present = holds_theta4 ? branch & ~std::size_t{1} : branch;
      ASSERT_EQ(solved.valid >> present & 1, 1);
      const Transform reached = six_r.forward(theta_of(solved, present));
      EXPECT_LT(rotation_error(reached, pose), 1e-6);
      EXPECT_LT(position_error_mm(reached, pose), 1e-4);
    }
  }
  EXPECT_EQ(held, 6);
}

}  // namespace
}  // namespace armature::test
