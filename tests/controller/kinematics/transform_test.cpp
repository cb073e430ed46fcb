#include "controller/kinematics/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::kPi;
constexpr std::uint64_t kTransformSeed = 24;

Transform random_pose(test::Random& random) {
  return {rotation_from_rpy(random.real(-kPi, kPi), random.real(-kPi / 2, kPi / 2), random.real(-kPi, kPi)),
          {random.real(-900, 900), random.real(-900, 900), random.real(-900, 900)}};
}

double difference(const Transform& a, const Transform& b) {
  return std::fmax((a.rotation - b.rotation).cwiseAbs().maxCoeff(),
                   (a.position_mm - b.position_mm).cwiseAbs().maxCoeff());
}

TEST(Transform, ProductsChainFromLeftToRight) {
  // The tool 10 mm ahead of a flange that looks along y of the base.
  Transform base_T_flange{rotation_from_rpy(0, 0, kPi / 2), {100, 0, 0}};
  Transform flange_T_tool{Eigen::Matrix3d::Identity(), {10, 0, 0}};
  const Transform base_T_tool = base_T_flange * flange_T_tool;
  EXPECT_LT((base_T_tool.position_mm - Eigen::Vector3d(100, 10, 0)).norm(), 1e-13);
  EXPECT_LT((base_T_flange * Eigen::Vector3d(0, 5, 0) - Eigen::Vector3d(95, 0, 0)).norm(), 1e-13);
}

TEST(Transform, InverseUndoesTheProduct) {
  test::Random random{kTransformSeed};
  for (int i = 0; i < 200; ++i) {
    const Transform a = random_pose(random), b = random_pose(random);
    ASSERT_LT(difference(inverse(a) * (a * b), b), 2e-12) << "seed " << kTransformSeed << " " << i;
    ASSERT_LT(difference(inverse(a * b), inverse(b) * inverse(a)), 2e-12) << "seed " << kTransformSeed << " " << i;
  }
}

TEST(Transform, RollPitchYawTurnAboutFixedXThenYThenZ) {
  // Roll first: z goes to -y; then yaw by 90 deg: -y goes to +x.
  const Eigen::Matrix3d rotation = rotation_from_rpy(kPi / 2, 0, kPi / 2);
  EXPECT_LT((rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-15);
  EXPECT_LT((rotation_from_rpy(0, kPi / 2, 0) * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(Transform, RollPitchYawComeBack) {
  test::Random random{kTransformSeed};
  for (int i = 0; i < 1000; ++i) {
    const double roll = random.real(-kPi, kPi), pitch = random.real(-1.5, 1.5), yaw = random.real(-kPi, kPi);
    const RollPitchYaw back = rpy_from_rotation(rotation_from_rpy(roll, pitch, yaw));
    ASSERT_NEAR(back.roll_rad, roll, 1e-14) << "seed " << kTransformSeed << " " << i;
    ASSERT_NEAR(back.pitch_rad, pitch, 1e-14) << "seed " << kTransformSeed << " " << i;
    ASSERT_NEAR(back.yaw_rad, yaw, 1e-14) << "seed " << kTransformSeed << " " << i;
  }
}

TEST(Transform, RollPitchYawGiveTheRotationBackInAndNearGimbalLock) {
  test::Random random{kTransformSeed};
  for (int i = 0; i < 1000; ++i) {
    const double from_lock = i % 10 == 0 ? 0.0 : std::pow(10.0, random.real(-16, -1));
    const double pitch = (i % 2 == 0 ? 1 : -1) * (kPi / 2 - from_lock);
    const Eigen::Matrix3d rotation = rotation_from_rpy(random.real(-kPi, kPi), pitch, random.real(-kPi, kPi));
    const RollPitchYaw back = rpy_from_rotation(rotation);
    const Eigen::Matrix3d again = rotation_from_rpy(back.roll_rad, back.pitch_rad, back.yaw_rad);
    const double tolerance = from_lock < 1.1e-9 ? 3e-9 : 2e-15;
    ASSERT_LT((again - rotation).cwiseAbs().maxCoeff(), tolerance)
        << "seed " << kTransformSeed << " " << i << " " << from_lock;
    ASSERT_LE(std::fabs(back.pitch_rad), kPi / 2);
    if (from_lock < 0.9e-9) {
      ASSERT_EQ(back.roll_rad, 0.0) << "seed " << kTransformSeed << " " << i;
    }
  }
}

TEST(Transform, IsRigidUpToSixDecimals) {
  test::Random random{kTransformSeed};
  for (int i = 0; i < 200; ++i) {
    Transform pose = random_pose(random);
    ASSERT_TRUE(is_rigid(pose));
    for (Eigen::Index k = 0; k < 9; ++k) pose.rotation(k / 3, k % 3) += random.real(-2e-7, 2e-7);
    ASSERT_TRUE(is_rigid(pose)) << "seed " << kTransformSeed << " " << i;
  }
}

TEST(Transform, IsNotRigidWhenAnyEntryIsOffOrNotANumber) {
  test::Random random{kTransformSeed};
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        3e9,
                        -3e9,
                        1e300};
  const Transform pose = random_pose(random);
  for (const double value : bad) {
    for (Eigen::Index k = 0; k < 12; ++k) {
      Transform broken = pose;
      if (k < 9) {
        broken.rotation(k / 3, k % 3) = value;
      } else {
        broken.position_mm(k - 9) = value;
      }
      EXPECT_FALSE(is_rigid(broken)) << value << " in " << k;
    }
  }
  for (Eigen::Index k = 0; k < 9; ++k) {
    Transform broken = pose;
    broken.rotation(k / 3, k % 3) += 1e-3;
    EXPECT_FALSE(is_rigid(broken)) << k;
  }
  EXPECT_FALSE(is_rigid({Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()}));
  EXPECT_FALSE(is_rigid({-pose.rotation, pose.position_mm})) << "mirrored";
  EXPECT_FALSE(is_rigid({1.001 * pose.rotation, pose.position_mm})) << "scaled";
  Eigen::Matrix3d sheared;
  sheared << 1.0, 0.6, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 0.8;  // unit x and y, z their product
  EXPECT_FALSE(is_rigid({sheared, pose.position_mm})) << "sheared";
}

}  // namespace
}  // namespace armature
