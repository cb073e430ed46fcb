#include "controller/kinematics/six_r.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::kPi;
constexpr std::uint64_t kSixRSeed = 2021;

// The reference's branches and ours, one to one and in order.
void expect_six_r_branches(const RawSolutions& actual, const nlohmann::json& expected, double tolerance_rad) {
  ASSERT_EQ(actual.count, expected.size());
  for (std::size_t i = 0; i < actual.count; ++i) {
    const RawBranch& branch = actual.branches[i];
    EXPECT_EQ(branch.shoulder, expected[i]["shoulder"].get<int>()) << "branch " << i;
    EXPECT_EQ(branch.elbow, expected[i]["elbow"].get<int>()) << "branch " << i;
    EXPECT_EQ(branch.flip, expected[i]["flip"].get<int>()) << "branch " << i;
    EXPECT_EQ(branch.singular, expected[i]["sing"].get<int>()) << "branch " << i;
    EXPECT_LT(test::angle_error(branch.theta, expected[i]["theta"].get<Theta>()), tolerance_rad) << "branch " << i;
    for (const double angle : branch.theta) EXPECT_LE(std::fabs(angle), kPi) << "branch " << i;
  }
}

TEST(SixR, ForwardGivesTheReferencePoses) {
  const SixR arm{test::irb120_geometry()};
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  ASSERT_EQ(reference["poses"].size(), 200u);
  for (const nlohmann::json& entry : reference["poses"]) {
    const Transform expected = test::transform_of(entry["T"]), actual = arm.forward(entry["theta"].get<Theta>());
    ASSERT_LT(test::rotation_error(actual, expected), 2e-15);
    ASSERT_LT(test::position_error_mm(actual, expected), 1e-12 * 700);
  }
}

TEST(SixR, InverseFindsExactlyTheBranchesOfTheReference) {
  const SixR arm{test::irb120_geometry()};
  int pose = 0;
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  for (const nlohmann::json& entry : reference["poses"]) {
    SCOPED_TRACE("pose " + std::to_string(pose++));
    const RawSolutions solutions = arm.inverse(test::transform_of(entry["T"]), Theta{});
    EXPECT_EQ(solutions.status, IkStatus::kOk);
    EXPECT_EQ(solutions.margin_mm, 0.0);
    expect_six_r_branches(solutions, entry["branches"], 1e-11);
  }
  EXPECT_EQ(pose, 200);
}

TEST(SixR, InverseHandlesTheSingularAndExtremePosesOfTheReference) {
  const SixR arm{test::irb120_geometry()};
  std::map<std::string, int> kinds;
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  for (const nlohmann::json& entry : reference["edges"]) {
    const std::string kind = entry["kind"].get<std::string>();
    SCOPED_TRACE(kind + " " + std::to_string(kinds[kind]++));
    const RawSolutions solutions = arm.inverse(test::transform_of(entry["T"]), entry["prev_theta"].get<Theta>());
    expect_six_r_branches(solutions, entry["branches"], entry["tol_theta"].get<double>());
    EXPECT_EQ(solutions.status, kind == "unreachable" ? IkStatus::kUnreachable : IkStatus::kOk);
    EXPECT_EQ(solutions.margin_mm > 0.0, kind == "unreachable");
    for (std::size_t i = 0; i < solutions.count; ++i) {
      // A stretched arm may be on either side of its limit by rounding.
      const bool at_limit = (solutions.branches[i].singular & kElbowSingular) != 0;
      EXPECT_TRUE(at_limit || !solutions.branches[i].clamped) << "branch " << i;
      EXPECT_TRUE(solutions.branches[i].clamped || kind != "overshoot_clamped") << "branch " << i;
    }
  }
  EXPECT_EQ(kinds.size(), 8u);
}

// The distance from the wrist singularity in powers of ten, on both sides of 0 and of pi.
TEST(SixR, EveryBranchGivesThePoseBackAtAnyDistanceFromTheWristSingularity) {
  test::Random random{kSixRSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    for (int power = 0; power <= 8; ++power) {
      for (int i = 0; i < 80; ++i) {
        Theta theta = test::random_angles(random);
        const double away = std::pow(10.0, -power) * (i % 2 == 0 ? 1.0 : -1.0);
        theta[4] = i % 4 < 2 ? away : kPi - away;
        const Transform pose = arm.forward(theta);
        const RawSolutions solutions = arm.inverse(pose, Theta{});
        ASSERT_GE(solutions.count, 4u);
        double nearest = 10.0;
        for (std::size_t k = 0; k < solutions.count; ++k) {
          const Transform again = arm.forward(solutions.branches[k].theta);
          ASSERT_LT(test::rotation_error(again, pose), 4e-15) << "seed " << kSixRSeed << " power " << power << " " << i;
          ASSERT_LT(test::position_error_mm(again, pose), 1e-12 * test::reach_mm(geometry))
              << "seed " << kSixRSeed << " power " << power << " " << i;
          ASSERT_EQ(solutions.branches[k].singular, 0);
          nearest = std::min(nearest, test::angle_error(solutions.branches[k].theta, theta));
        }
        // theta_4 and theta_6 carry the rounding of the pose, divided by sin(theta_5).
        ASSERT_LT(nearest, 1e-10 * std::pow(10.0, power)) << "seed " << kSixRSeed << " power " << power << " " << i;
      }
    }
  }
}

TEST(SixR, OneBranchOfAnyPoseIsTheConfigurationThatMadeIt) {
  test::Random random{kSixRSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    std::map<std::size_t, int> counts;
    for (int i = 0; i < 500; ++i) {
      const Theta theta = test::random_angles(random);
      const RawSolutions solutions = arm.inverse(arm.forward(theta), Theta{});
      int matches = 0;
      for (std::size_t k = 0; k < solutions.count; ++k) {
        const RawBranch& branch = solutions.branches[k];
        if (test::angle_error(branch.theta, theta) > 1e-8) continue;
        ++matches;
        // The flags are what their algebra says.
        const double r = geometry.a1_mm + geometry.a2_mm * std::cos(theta[1]) +
                         geometry.a3_mm * std::cos(theta[1] + theta[2]) +
                         geometry.d4_mm * std::sin(theta[1] + theta[2]);
        const double phi = std::atan2(geometry.d4_mm, geometry.a3_mm);
        EXPECT_EQ(branch.shoulder, r > 0 ? 1 : -1) << "seed " << kSixRSeed << " " << i;
        EXPECT_EQ(branch.elbow, std::sin(theta[2] - phi) < 0 ? 1 : -1) << "seed " << kSixRSeed << " " << i;
        EXPECT_EQ(branch.flip, std::sin(theta[4]) > 0 ? 1 : -1) << "seed " << kSixRSeed << " " << i;
      }
      ASSERT_EQ(matches, 1) << "seed " << kSixRSeed << " " << i;
      ++counts[solutions.count];
    }
    // A shoulder on axis 1 reaches forwards what it reaches backwards.
    EXPECT_GT(counts[8], 350);
    EXPECT_EQ(counts[8] + counts[4], 500);
    EXPECT_EQ(counts[4] == 0, geometry.a1_mm == 0.0);
  }
}

// A pose whose wrist centre is `distance_mm` from axis 2, straight ahead.
Transform wrist_at(const ArmGeometry& geometry, double distance_mm) {
  Transform pose{rotation_from_rpy(0.1, kPi / 2 - 0.2, 0.3), {}};
  pose.position_mm = Eigen::Vector3d{geometry.a1_mm + 0.8 * distance_mm, 0.0, geometry.d1_mm + 0.6 * distance_mm} +
                     geometry.d6_mm * pose.rotation.col(2);
  return pose;
}

TEST(SixR, ReachIsExceededByAsMuchAsTheMarginSays) {
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    const double longest = test::reach_mm(geometry);
    const double shortest = std::fabs(geometry.a2_mm - test::forearm_mm(geometry));
    for (const double beyond : {1e-5, 0.1, 1.0, 250.0, 1e6}) {
      const RawSolutions far = arm.inverse(wrist_at(geometry, longest + beyond), Theta{});
      EXPECT_EQ(far.status, IkStatus::kUnreachable);
      EXPECT_EQ(far.count, 0u);
      EXPECT_NEAR(far.margin_mm, beyond, 1e-9 * beyond + 1e-9);
    }
    const RawSolutions close = arm.inverse(wrist_at(geometry, 0.25 * shortest), Theta{});
    if (geometry.a1_mm == 0.0) {
      EXPECT_EQ(close.status, IkStatus::kUnreachable);
      EXPECT_NEAR(close.margin_mm, 0.75 * shortest, 1e-9);
    }
  }
}

TEST(SixR, OvershootByRoundingIsTakenAsTheLimitAndSaidSo) {
  const ArmGeometry geometry = test::irb120_geometry();
  const SixR arm{geometry};
  const double longest = test::reach_mm(geometry);
  const double shortest = std::fabs(geometry.a2_mm - test::forearm_mm(geometry));
  for (const bool outer : {true, false}) {
    const auto solve = [&](double relative) {
      return arm.inverse(wrist_at(geometry, outer ? longest + relative * longest : shortest - relative * longest), {});
    };
    for (const double relative : {1e-13, 1e-11, 0.9e-9}) {
      const RawSolutions solutions = solve(relative);
      ASSERT_EQ(solutions.status, IkStatus::kOk) << relative;
      ASSERT_EQ(solutions.count, 8u);
      for (const RawBranch& branch : solutions.branches) {
        if (relative > 1e-12) {
          EXPECT_TRUE(branch.clamped) << relative;
        }
        EXPECT_TRUE(branch.singular & kElbowSingular);
        const Transform again = arm.forward(branch.theta);
        const Transform pose = wrist_at(geometry, outer ? longest + relative * longest : shortest - relative * longest);
        EXPECT_LT(test::rotation_error(again, pose), 4e-15);
        EXPECT_LT(test::position_error_mm(again, pose), relative * longest + 1e-12 * longest);
      }
    }
    EXPECT_EQ(solve(1.1e-9).status, IkStatus::kUnreachable);
    EXPECT_FALSE(solve(-0.9e-9).branches[0].clamped);
    EXPECT_TRUE(solve(-0.9e-9).branches[0].singular & kElbowSingular);
    EXPECT_EQ(solve(-1.1e-9).branches[0].singular, 0);
  }
}

TEST(SixR, FoldedOntoAxis2KeepsTheta2) {
  // Upper arm and forearm of one length, 300.
  const ArmGeometry geometry = test::six_r_geometry(40, 300, 180, 200, 240, 50);
  const SixR arm{geometry};
  for (const double from_axis : {0.0, 1e-10, 1e-8}) {
    const Transform pose = wrist_at(geometry, from_axis);
    const Theta previous{0.0, 0.7, -2.0, 0.1, 0.2, 0.3};
    const RawSolutions solutions = arm.inverse(pose, previous);
    ASSERT_EQ(solutions.status, IkStatus::kOk);
    ASSERT_GE(solutions.count, 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(solutions.branches[i].theta[1], 0.7);
      EXPECT_EQ(solutions.branches[i].singular, kElbowSingular | kFoldedSingular);
      EXPECT_EQ(status_of(solutions.branches[i]), IkStatus::kSingular);
      const Transform again = arm.forward(solutions.branches[i].theta);
      EXPECT_LT(test::rotation_error(again, pose), 4e-15);
      EXPECT_LT(test::position_error_mm(again, pose), 2 * from_axis + 1e-12 * 600);
    }
  }
}

TEST(SixR, WhatIsNoPoseOrNoAngleIsRefused) {
  const SixR arm{test::irb120_geometry()};
  const Theta good{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const Transform pose = arm.forward(good);
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 2e9}) {
    for (Eigen::Index k = 0; k < 12; ++k) {
      Transform broken = pose;
      (k < 9 ? broken.rotation(k / 3, k % 3) : broken.position_mm(k - 9)) = value;
      EXPECT_EQ(arm.inverse(broken, good).status, IkStatus::kInvalidInput);
      EXPECT_EQ(arm.inverse(broken, good).count, 0u);
      EXPECT_EQ(arm.track(broken, good).status, IkStatus::kInvalidInput);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      Theta previous = good;
      previous[k] = -value;
      EXPECT_EQ(arm.inverse(pose, previous).status, IkStatus::kInvalidInput);
      EXPECT_EQ(arm.track(pose, previous).status, IkStatus::kInvalidInput);
    }
  }
}

// Poses of all sizes, on the axes, axis-parallel and degenerate: an answer is finite and right, or a refusal.
TEST(SixR, NeverAnswersWithANaN) {
  test::Random random{kSixRSeed};
  std::array<ArmGeometry, 5> arms{test::irb120_geometry(), test::kr6_r900(), test::lrmate200id(),
                                  test::six_r_geometry(0, 300, 0, 0, 300, 0),
                                  test::six_r_geometry(-30, 100, -240, -50, -180, -10)};
  for (int i = 0; i < 10'000; ++i) {
    const ArmGeometry& geometry = arms[static_cast<std::size_t>(i) % arms.size()];
    const SixR arm{geometry};
    Transform pose;
    const auto angle = [&] {
      return i % 3 == 0 ? static_cast<double>(random.integer(-2, 2)) * kPi / 2 : random.real(-kPi, kPi);
    };
    pose.rotation = rotation_from_rpy(angle(), angle(), angle());
    if (i % 6 == 0) pose.rotation = pose.rotation.array().round().matrix();  // exact zeros and ones
    const double scale = std::pow(10.0, random.real(-12, 9));
    for (double& coordinate : pose.position_mm) coordinate = i % 4 == 1 ? 0.0 : random.real(-scale, scale);
    if (i % 2 == 0) pose.position_mm += geometry.d6_mm * pose.rotation.col(2);
    if (i % 7 == 0) pose.position_mm(2) += geometry.d1_mm;
    if (!is_rigid(pose)) continue;
    const Theta previous = test::random_angles(random, i % 5 == 0 ? 1e5 : 6.0);

    const RawSolutions solutions = arm.inverse(pose, previous);
    ASSERT_TRUE(solutions.status == IkStatus::kOk || solutions.status == IkStatus::kUnreachable);
    ASSERT_EQ(solutions.count > 0, solutions.status == IkStatus::kOk);
    ASSERT_EQ(solutions.margin_mm > 0.0, solutions.status == IkStatus::kUnreachable);
    ASSERT_TRUE(std::isfinite(solutions.margin_mm));
    const double tolerance_mm = 3e-9 * test::reach_mm(geometry);
    for (std::size_t k = 0; k < solutions.count; ++k) {
      for (const double value : solutions.branches[k].theta) ASSERT_LE(std::fabs(value), kPi) << i;
      const Transform again = arm.forward(solutions.branches[k].theta);
      ASSERT_LT(test::rotation_error(again, pose), 3e-9) << "seed " << kSixRSeed << " " << i;
      ASSERT_LT(test::position_error_mm(again, pose), tolerance_mm) << "seed " << kSixRSeed << " " << i;
    }
    const RawTracking tracking = arm.track(pose, previous);
    ASSERT_TRUE(solved(tracking.status) || tracking.status == IkStatus::kUnreachable);
    if (!solved(tracking.status)) continue;
    const Transform again = arm.forward(tracking.theta);
    ASSERT_LT(test::rotation_error(again, pose), 3e-7) << "seed " << kSixRSeed << " " << i;
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_LE(std::fabs(tracking.theta[k] - previous[k]), kPi + 1e-9) << "seed " << kSixRSeed << " " << i;
    }
  }
}

}  // namespace
}  // namespace armature
