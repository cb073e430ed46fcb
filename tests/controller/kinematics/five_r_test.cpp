// The closed form of the five-axis arm against 50-digit reference vectors and against products of link matrices.
#include "controller/kinematics/five_r.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/controller/support/five_r_rig.hpp"
#include "tests/controller/support/reference_data.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;
using Json = nlohmann::json;

Transform pose_of(const Json& rows) {
  Transform pose;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Json& values = rows.at(static_cast<std::size_t>(row));
    for (Eigen::Index column = 0; column < 3; ++column) {
      pose.rotation(row, column) = values.at(static_cast<std::size_t>(column)).get<double>();
    }
    pose.position_mm[row] = values.at(3).get<double>();
  }
  return pose;
}

Theta theta_of(const Json& angles) {
  Theta theta{};
  for (std::size_t joint = 0; joint < 5; ++joint) theta[joint] = angles.at(joint).get<double>();
  return theta;
}

void expect_five_r_branches(const RawSolutions& solutions, const Json& branches, double tolerance) {
  ASSERT_EQ(solutions.count, branches.size());
  for (std::size_t i = 0; i < solutions.count; ++i) {
    const RawBranch& branch = solutions.branches[i];
    EXPECT_EQ(branch.shoulder, branches[i]["shoulder"].get<int>()) << "branch " << i;
    EXPECT_EQ(branch.elbow, branches[i]["elbow"].get<int>()) << "branch " << i;
    EXPECT_EQ(branch.flip, 0);
    EXPECT_LE(test::angle_distance(branch.theta, theta_of(branches[i]["theta"])), tolerance) << "branch " << i;
    for (const double angle : branch.theta) EXPECT_LE(std::fabs(angle), kPi);
  }
}

TEST(FiveR, ForwardGivesTheReferencePoses) {
  const FiveR arm{hu_arm()};
  const auto reference = test::read_reference("ik5r.json");
  ASSERT_EQ(reference["poses"].size(), 100u);
  for (const auto& expected : reference["poses"]) {
    const Transform pose = arm.forward(theta_of(expected["theta"]));
    ASSERT_LT(test::rotation_difference(pose, pose_of(expected["T"])), 1e-14) << expected["theta_deg"];
    ASSERT_LT(test::position_difference_mm(pose, pose_of(expected["T"])), 4e-14) << expected["theta_deg"];
  }
}

TEST(FiveR, InverseFindsTheBranchesOfTheReferenceOneToOne) {
  const FiveR arm{hu_arm()};
  const auto reference = test::read_reference("ik5r.json");
  std::array<int, 5> poses_with{};
  for (const auto& expected : reference["poses"]) {
    SCOPED_TRACE(expected["theta_deg"].dump());
    const RawSolutions solutions = arm.inverse(pose_of(expected["T"]), Theta{});
    EXPECT_EQ(solutions.status, IkStatus::kOk);
    EXPECT_LT(solutions.residual_rad, 2e-15);
    expect_five_r_branches(solutions, expected["branches"], 1e-11);
    for (std::size_t i = 0; i < solutions.count; ++i) {
      EXPECT_EQ(solutions.branches[i].singular, kNotSingular);
      EXPECT_FALSE(solutions.branches[i].clamped);
    }
    ++poses_with.at(solutions.count);
  }
  EXPECT_GT(poses_with[4], 60);
  EXPECT_GT(poses_with[2], 20);
  EXPECT_EQ(poses_with[4] + poses_with[2], 100);
}

TEST(FiveR, ProjectsToTheNearestReachableOrientationOfTheReference) {
  const FiveR arm{hu_arm(1.1, kPi / 2)};
  const auto reference = test::read_reference("ik5r.json");
  ASSERT_EQ(reference["projection"].size(), 30u);
  int unreachable = 0;
  for (const auto& expected : reference["projection"]) {
    const RawSolutions solutions = arm.inverse(pose_of(expected["T_in"]), Theta{});
    EXPECT_NEAR(solutions.residual_rad, expected["residual_rad"].get<double>(), 4e-15);
    expect_five_r_branches(solutions, expected["branches"], 1e-11);
    if (expected["branches"].empty()) {
      EXPECT_EQ(solutions.status, IkStatus::kUnreachable);
      EXPECT_GT(solutions.margin_mm, 0.0);
      ++unreachable;
    }
    for (std::size_t i = 0; i < solutions.count; ++i) {
      const Transform solved_pose = test::product_of_links(hu_arm(), solutions.branches[i].theta);
      EXPECT_LT(test::rotation_difference(solved_pose, pose_of(expected["T_projected"])), 1e-13);
      EXPECT_LT(test::position_difference_mm(solved_pose, pose_of(expected["T_in"])), 2e-12);
    }
  }
  EXPECT_LT(unreachable, 10);
}

TEST(FiveR, TreatsTheEdgesAsTheReferenceSays) {
  const auto reference = test::read_reference("ik5r.json");
  ASSERT_EQ(reference["edges"].size(), 7u);
  for (const auto& edge : reference["edges"]) {
    SCOPED_TRACE(edge["kind"].get<std::string>());
    const FiveR arm{hu_arm(edge["a1"].get<double>())};
    const Theta previous{0.3, 0.0, 0.0, 0.0, 0.0, 0.0};
    const RawSolutions solutions = arm.inverse(pose_of(edge["T"]), previous);
    expect_five_r_branches(solutions, edge["branches"], edge["tol_theta"].get<double>());
    EXPECT_EQ(solutions.status, edge["n"].get<int>() > 0 ? IkStatus::kOk : IkStatus::kUnreachable);
    EXPECT_EQ(solutions.margin_mm > 0.0, edge["n"].get<int>() == 0);
    for (std::size_t i = 0; i < solutions.count; ++i) {
      // The reference marks everything on axis 1 as 1 and a vertical approach there as 3: only that is singular.
      const int marks = edge["branches"][i]["sing"].get<int>();
      const int expected = (marks & kElbowSingular) | (marks == 3 ? kShoulderSingular : kNotSingular);
      EXPECT_EQ(solutions.branches[i].singular, expected);
    }
  }
}

TEST(FiveR, EveryBranchOfARandomPoseGivesThePoseAndOneIsTheOneItCameFrom) {
  constexpr std::uint64_t kSeed = 20;
  RecordProperty("seed", static_cast<int>(kSeed));
  test::Random random{kSeed};
  const FiveR arm{hu_arm()};
  std::array<int, 5> poses_with{};
  for (int i = 0; i < 20'000; ++i) {
    const Theta theta = test::random_theta(random);
    const Transform pose = test::product_of_links(hu_arm(), theta);
    const RawSolutions solutions = arm.inverse(pose, Theta{});
    ASSERT_EQ(solutions.status, IkStatus::kOk) << "seed " << kSeed << " pose " << i;
    double nearest = kPi;
    for (std::size_t b = 0; b < solutions.count; ++b) {
      const Transform solved_pose = arm.forward(solutions.branches[b].theta);
      ASSERT_LT(test::rotation_difference(solved_pose, pose), 1e-11) << "seed " << kSeed << " pose " << i;
      ASSERT_LT(test::position_difference_mm(solved_pose, pose), 2e-12) << "seed " << kSeed << " pose " << i;
      nearest = std::min(nearest, test::angle_distance(solutions.branches[b].theta, theta));
    }
    const Manipulability far = arm.manipulability(theta);
    ASSERT_LT(nearest, 1e-13 / (far.elbow * far.elbow * far.shoulder * far.shoulder)) << "seed " << kSeed << " " << i;
    ++poses_with.at(solutions.count);
  }
  RecordProperty("four", poses_with[4]);
  RecordProperty("two", poses_with[2]);
  EXPECT_EQ(poses_with[4] + poses_with[2], 20'000);
  EXPECT_NEAR(poses_with[4] / 20'000.0, 0.768, 0.01);
}

TEST(FiveR, AReachablePoseHasNoResidualHoweverNearItsToolPointIsToAxis1) {
  constexpr std::uint64_t kSeed = 21;
  test::Random random{kSeed};
  const FiveR arm{hu_arm()};
  for (int exponent = 0; exponent <= 15; ++exponent) {
    for (int i = 0; i < 50; ++i) {
      const double pitch = random.real(-3.0, 3.0);
      const double heading = random.real(-kPi, kPi);
      const double rho = 15.0 * std::pow(10.0, -exponent);
      // The tool point is rounded as it is at the end of a chain of products.
      Transform pose = arm.to_transform({.x_mm = rho * std::cos(heading),
                                         .y_mm = rho * std::sin(heading),
                                         .z_mm = -20.0,
                                         .pitch_rad = pitch,
                                         .roll_rad = random.real(-3.0, 3.0),
                                         .heading_rad = heading});
      pose.position_mm.x() += random.real(-4e-15, 4e-15);
      pose.position_mm.y() += random.real(-4e-15, 4e-15);
      const RawSolutions solutions = arm.inverse(pose, Theta{});
      ASSERT_LT(solutions.residual_rad, 3e-15) << "seed " << kSeed << " rho " << rho << " pitch " << pitch;
      for (std::size_t b = 0; b < solutions.count; ++b) {
        const Transform solved_pose = arm.forward(solutions.branches[b].theta);
        ASSERT_LT(test::rotation_difference(solved_pose, pose), 1e-13) << "rho " << rho << " pitch " << pitch;
        ASSERT_LT(test::position_difference_mm(solved_pose, pose), rho < 2e-8 ? 2e-8 : 4e-12) << "rho " << rho;
      }
    }
  }
}

TEST(FiveR, NoReachableOrientationIsNearerThanTheProjection) {
  constexpr std::uint64_t kSeed = 22;
  test::Random random{kSeed};
  const FiveR arm{hu_arm(1.1, kPi / 2)};
  for (int i = 0; i < 200; ++i) {
    Transform pose = arm.forward(test::random_theta(random));
    pose.rotation = test::turn_about(test::random_direction(random), random.real(-kPi, kPi));
    const NearestPose5 nearest = arm.from_transform(pose);
    const Transform projected = arm.to_transform(nearest.pose);
    ASSERT_NEAR(test::angle_between(pose.rotation, projected.rotation), nearest.residual_rad, 1e-14);
    for (int j = 0; j < 200; ++j) {
      Pose5 other = nearest.pose;
      const double size = std::pow(10.0, random.real(-4.0, 0.5));
      other.pitch_rad += random.real(-size, size);
      other.roll_rad += random.real(-size, size);
      ASSERT_GE(test::angle_between(pose.rotation, arm.to_transform(other).rotation), nearest.residual_rad - 1e-14)
          << "seed " << kSeed << " pose " << i;
    }
  }
}

TEST(FiveR, ManipulabilityIsTheFactoredVolumeOfTheJacobian) {
  constexpr std::uint64_t kSeed = 23;
  test::Random random{kSeed};
  const ArmGeometry geometry = hu_arm();
  const FiveR arm{geometry};
  for (int i = 0; i < 1000; ++i) {
    const Theta theta = test::random_theta(random);
    const Transform flange = test::product_of_links(geometry, theta);
    // The same volume with lengths measured in a2 + a3 for the column of axis 1, where r appears.
    const double reach = geometry.a2_mm + geometry.a3_mm;
    Eigen::Matrix<double, 6, 5> jacobian = arm.jacobian(theta).leftCols<5>();
    jacobian.topRows<3>() /= reach;
    const double squared_volume = (jacobian.transpose() * jacobian).determinant();
    const Manipulability factors = arm.manipulability(theta);
    const double expected = geometry.a2_mm * geometry.a3_mm * factors.elbow * factors.shoulder / (reach * reach);
    ASSERT_NEAR(squared_volume, expected * expected, 1e-14) << "seed " << kSeed << " " << i;
    ASSERT_NEAR(factors.shoulder,
                std::hypot(flange.position_mm.head<2>().norm() / reach, flange.rotation.col(2).head<2>().norm()),
                1e-14);
    ASSERT_EQ(factors.wrist, 1.0);
    ASSERT_EQ(arm.jacobian(theta).col(5), (Eigen::Matrix<double, 6, 1>::Zero()));
  }
}

}  // namespace
}  // namespace armature
