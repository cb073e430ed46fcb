// Forward kinematics and Jacobian against Orocos KDL, which builds them from link frames.
#include <gtest/gtest.h>

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

// Denavit-Hartenberg frames with the vendor's joint: theta = sign * q + offset.
KDL::Chain six_r_chain(const ArmGeometry& arm) {
  const double quarter = std::numbers::pi / 2;
  const double a[] = {arm.a1_mm, arm.a2_mm, arm.a3_mm, 0, 0, 0}, d[] = {arm.d1_mm, 0, 0, arm.d4_mm, 0, arm.d6_mm};
  const double alpha[] = {quarter, 0, quarter, -quarter, quarter, 0};
  KDL::Chain chain;
  for (unsigned i = 0; i < 6; ++i) {
    // KDL takes the frame at joint 0, so the offset belongs to the frame and not to its Joint.
    const KDL::Joint joint{KDL::Joint::RotZ, arm.sign[i]};
    chain.addSegment(KDL::Segment{joint, KDL::Frame::DH(a[i], alpha[i], d[i], arm.offset_rad[i])});
  }
  return chain;
}

TEST(SixRKdl, AgreesOnForwardKinematicsAndJacobianOfTheVendorsArms) {
  constexpr std::uint64_t kSeed = 7;
  test::Random random{kSeed};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const Arm arm{test::robot_with(geometry)};
    const KDL::Chain chain = six_r_chain(geometry);
    KDL::ChainFkSolverPos_recursive forward{chain};
    KDL::ChainJntToJacSolver to_jacobian{chain};
    for (int i = 0; i < 700; ++i) {
      const Theta q = test::random_angles(random, 6.0);
      const JointAngles joints = make_per_axis([&](std::size_t axis) { return Radians{q[axis]}; });
      KDL::JntArray kdl_joints{6};
      for (unsigned axis = 0; axis < 6; ++axis) kdl_joints(axis) = q[axis];

      KDL::Frame frame;
      ASSERT_GE(forward.JntToCart(kdl_joints, frame), 0);
      const Transform pose = arm.forward(joints);
      for (int row = 0; row < 3; ++row) {
        ASSERT_NEAR(pose.position_mm(row), frame.p(row), 3e-12) << "seed " << kSeed << " " << i;
        for (int column = 0; column < 3; ++column) {
          ASSERT_NEAR(pose.rotation(row, column), frame.M(row, column), 4e-15) << "seed " << kSeed << " " << i;
        }
      }

      KDL::Jacobian expected{6};
      ASSERT_GE(to_jacobian.JntToJac(kdl_joints, expected), 0);
      const Jacobian actual = arm.jacobian(joints);
      ASSERT_LT((actual - expected.data).topRows<3>().cwiseAbs().maxCoeff(), 3e-12) << "seed " << kSeed << " " << i;
      ASSERT_LT((actual - expected.data).bottomRows<3>().cwiseAbs().maxCoeff(), 4e-15) << "seed " << kSeed << " " << i;
    }
  }
}

}  // namespace
}  // namespace armature
