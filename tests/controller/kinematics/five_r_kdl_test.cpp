// Forward kinematics and Jacobian against Orocos KDL, which builds them from link frames.
#include <gtest/gtest.h>

#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

KDL::Chain five_r_chain(const ArmGeometry& arm) {
  const double quarter = test::kPi / 2;
  KDL::Chain chain;
  const auto add = [&chain](double a, double alpha, double d) {
    chain.addSegment(KDL::Segment{KDL::Joint{KDL::Joint::RotZ}, KDL::Frame::DH(a, alpha, d, 0.0)});
  };
  add(arm.a1_mm, -quarter, 0.0);
  add(arm.a2_mm, 0.0, 0.0);
  add(arm.a3_mm, 0.0, 0.0);
  add(arm.a4_mm, -quarter, 0.0);
  add(0.0, 0.0, arm.d5_mm);
  return chain;
}

TEST(FiveRKdl, AgreesOnForwardKinematicsAndJacobian) {
  constexpr std::uint64_t kSeed = 50;
  test::Random random{kSeed};
  for (int i = 0; i < 2000; ++i) {
    ArmGeometry geometry = test::hu_arm();
    if (i % 2 == 1) {  // another arm of the family
      geometry.a1_mm = random.real(-50.0, 100.0);
      geometry.a2_mm = random.real(50.0, 400.0);
      geometry.a3_mm = random.real(50.0, 400.0);
      geometry.a4_mm = random.real(-40.0, 40.0);
      geometry.d5_mm = random.real(0.0, 200.0);
    }
    const FiveR arm{geometry};
    const KDL::Chain chain = five_r_chain(geometry);
    KDL::ChainFkSolverPos_recursive forward{chain};
    KDL::ChainJntToJacSolver jacobian{chain};
    const Theta theta = test::random_theta(random);
    KDL::JntArray joints{5};
    for (unsigned joint = 0; joint < 5; ++joint) joints(joint) = theta[joint];

    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(joints, frame), 0);
    const Transform pose = arm.forward(theta);
    for (unsigned row = 0; row < 3; ++row) {
      const auto r = static_cast<Eigen::Index>(row);
      ASSERT_NEAR(pose.position_mm[r], frame.p(static_cast<int>(row)), 2e-12) << "seed " << kSeed << " " << i;
      for (unsigned column = 0; column < 3; ++column) {
        ASSERT_NEAR(pose.rotation(r, static_cast<Eigen::Index>(column)),
                    frame.M(static_cast<int>(row), static_cast<int>(column)), 4e-15)
            << "seed " << kSeed << " " << i;
      }
    }

    KDL::Jacobian expected{5};
    ASSERT_GE(jacobian.JntToJac(joints, expected), 0);
    const Jacobian actual = arm.jacobian(theta);
    ASSERT_LT((actual.leftCols<5>() - expected.data).cwiseAbs().maxCoeff(), 2e-12) << "seed " << kSeed << " " << i;
  }
}

}  // namespace
}  // namespace armature
