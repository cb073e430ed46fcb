#include "controller/kinematics/jacobian.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

constexpr std::uint64_t kJacobianSeed = 66;

TEST(GeometricJacobian, OfOneJointIsItsLeverAndItsAxis) {
  PerAxis<JointAxis> axes;
  axes[0] = {Eigen::Vector3d::UnitY(), Eigen::Vector3d{0, 77, 100}};
  const Jacobian jacobian = geometric_jacobian(axes, 1, {30, 0, 100});
  Eigen::Matrix<double, 6, 1> column;
  column << 0, 0, -30, 0, 1, 0;
  EXPECT_LT((jacobian.col(0) - column).norm(), 1e-15);
  EXPECT_EQ(jacobian.rightCols<5>().norm(), 0.0);
}

TEST(SixRJacobian, IsThatOfTheReference) {
  const SixR arm{test::irb120_geometry()};
  int checked = 0;
  const nlohmann::json reference = test::read_reference("ik6r_abb_irb120.json");
  for (const nlohmann::json& entry : reference["poses"]) {
    if (!entry.contains("J")) continue;
    ++checked;
    const Theta theta = entry["theta"].get<Theta>();
    const Jacobian jacobian = arm.jacobian(theta);
    for (Eigen::Index row = 0; row < 6; ++row) {
      for (Eigen::Index column = 0; column < 6; ++column) {
        const double expected =
            entry["J"][static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].get<double>();
        ASSERT_NEAR(jacobian(row, column), expected, row < 3 ? 1e-12 * 700 : 2e-15) << row << " " << column;
      }
    }
    const double determinant = entry["detJ"].get<double>();
    EXPECT_NEAR(jacobian.determinant(), determinant, 1e-12 * std::fabs(determinant) + 1e-6);
  }
  EXPECT_EQ(checked, 25);
}

// det J = -a2 (d4 c3 - a3 s3) r s5, and its size is the product of the three distances from singularity.
TEST(SixRJacobian, HasTheDeterminantOfTheFormulaAndOfTheManipulability) {
  test::Random random{kJacobianSeed};
  for (const ArmGeometry& g : test::vendor_arms()) {
    const SixR arm{g};
    const double reach = test::reach_mm(g), forearm = test::forearm_mm(g);
    for (int i = 0; i < 300; ++i) {
      const Theta theta = test::random_angles(random, 6.0);
      const double theta23 = theta[1] + theta[2];
      const double r =
          g.a1_mm + g.a2_mm * std::cos(theta[1]) + g.a3_mm * std::cos(theta23) + g.d4_mm * std::sin(theta23);
      const double formula =
          -g.a2_mm * (g.d4_mm * std::cos(theta[2]) - g.a3_mm * std::sin(theta[2])) * r * std::sin(theta[4]);
      const double size = g.a2_mm * forearm * reach;
      ASSERT_NEAR(arm.jacobian(theta).determinant(), formula, 1e-13 * size) << "seed " << kJacobianSeed << " " << i;
      const Manipulability away = arm.manipulability(theta);
      ASSERT_NEAR(size * away.elbow * away.shoulder * away.wrist, std::fabs(formula), 1e-13 * size)
          << "seed " << kJacobianSeed << " " << i;
      ASSERT_NEAR(away.shoulder, std::fabs(r) / reach, 1e-15);
      ASSERT_NEAR(away.wrist, std::fabs(std::sin(theta[4])), 1e-15);
    }
  }
}

TEST(SixRRates, AreTheInverseOfTheJacobian) {
  test::Random random{kJacobianSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    for (int i = 0; i < 300; ++i) {
      const Theta theta = test::random_angles(random, 6.0);
      const Manipulability away = arm.manipulability(theta);
      const double least = std::min({away.elbow, away.shoulder, away.wrist});
      if (least < 1e-3) continue;
      Eigen::Matrix<double, 6, 1> velocity;
      for (Eigen::Index k = 0; k < 6; ++k) velocity(k) = random.real(-1, 1) * (k < 3 ? 500.0 : 2.0);
      const Theta rates = arm.rates(theta, velocity.head<3>(), velocity.tail<3>());
      const Eigen::Map<const Eigen::Matrix<double, 6, 1>> joints{rates.data()};
      const Eigen::Matrix<double, 6, 1> error = arm.jacobian(theta) * joints - velocity;
      ASSERT_LT(error.head<3>().norm(), 1e-11 / least) << "seed " << kJacobianSeed << " " << i;
      ASSERT_LT(error.tail<3>().norm(), 1e-13 / least) << "seed " << kJacobianSeed << " " << i;
    }
  }
}

TEST(SixRManipulability, IsZeroAtEachSingularityAlone) {
  for (const ArmGeometry& g : test::vendor_arms()) {
    const SixR arm{g};
    const double phi = std::atan2(g.d4_mm, g.a3_mm);
    const Manipulability wrist = arm.manipulability({0.1, 0.7, 0.2, 0.3, 0.0, 0.5});
    EXPECT_EQ(wrist.wrist, 0.0);
    EXPECT_GT(wrist.shoulder * wrist.elbow, 0.1);
    const Manipulability elbow = arm.manipulability({0.1, 0.7, phi, 0.3, 0.4, 0.5});
    EXPECT_LT(elbow.elbow, 1e-15);
    EXPECT_GT(elbow.shoulder * elbow.wrist, 0.1);
    // The wrist centre above axis 1, the forearm rising at 60 deg.
    const double rise = std::numbers::pi / 3;
    const double theta2 = std::acos(-(g.a1_mm + test::forearm_mm(g) * std::cos(rise)) / g.a2_mm);
    const Manipulability shoulder = arm.manipulability({0.1, theta2, phi + rise - theta2, 0.3, 0.4, 0.5});
    EXPECT_LT(shoulder.shoulder, 1e-15);
    EXPECT_GT(shoulder.elbow * shoulder.wrist, 0.1);
  }
}

}  // namespace
}  // namespace armature
