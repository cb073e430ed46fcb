// Inverse dynamics, gravity and mass matrix against Orocos KDL, which computes them with its own link frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <numbers>
#include <vector>

#include "cosim/dynamics/arm_dynamics.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::cosim {
namespace {

using armature::test::Random;

constexpr std::uint64_t kDynamicsSeed = 35;
constexpr int kQuarters[2][6] = {{1, 0, 1, -1, 1, 0}, {-1, 0, 0, -1, 0, 0}};  // alpha of six_r and of five_r, in 90 deg

Vector3 random_vector(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

// A body of four point masses around its centre has a possible inertia.
Body random_body(Random& random) {
  Body body;
  for (int i = 0; i < 4; ++i) {
    body = together(body, Body{random.real(0.1, 5), random_vector(random, 0.4), {}});
  }
  return body;
}

struct Arm {
  ArmModel model;
  KDL::Chain chain;
};

KDL::RigidBodyInertia kdl_body(const Body& body) {
  const Symmetric3& i = body.inertia_kg_m2;
  return KDL::RigidBodyInertia{body.mass_kg, KDL::Vector{body.centre_m.x, body.centre_m.y, body.centre_m.z},
                               KDL::RotationalInertia{i.xx, i.yy, i.zz, i.xy, i.xz, i.yz}};
}

Arm random_arm(Random& random) {
  Arm arm;
  const auto family = static_cast<std::size_t>(random.integer(0, 1));
  arm.model.joints = family == 0 ? 6 : 5;
  arm.model.gravity_m_s2 = random_vector(random, 10);
  for (std::size_t i = 0; i < arm.model.joints; ++i) {
    const int quarters = kQuarters[family][i];
    ArmLink& link = arm.model.links[i];
    link = {.a_m = random.real(-0.5, 0.5),
            .d_m = random.real(-0.5, 0.5),
            .sin_alpha = static_cast<double>(quarters),
            .cos_alpha = quarters == 0 ? 1.0 : 0.0,
            .sign = random.integer(0, 1) == 0 ? 1.0 : -1.0,
            .offset_rad = random.real(-3, 3),
            .body = random_body(random)};
    KDL::RigidBodyInertia inertia = kdl_body(link.body);
    if (i + 1 == arm.model.joints) {
      // Tool and payload: bodies beside the last link for KDL, one body for us.
      const Body tool = random_body(random), payload = random_body(random);
      link.body = together(together(link.body, tool), payload);
      inertia = inertia + kdl_body(tool) + kdl_body(payload);
    }
    const double alpha = quarters * (std::numbers::pi / 2);
    arm.chain.addSegment(KDL::Segment{KDL::Joint{KDL::Joint::RotZ, link.sign},
                                      KDL::Frame::DH(link.a_m, alpha, link.d_m, link.offset_rad), inertia});
  }
  return arm;
}

double largest(const KDL::JntArray& values) {
  return values.data.cwiseAbs().maxCoeff();
}

TEST(ArmDynamicsKdl, AgreesOnTorquesGravityAndMassMatrixAtTenThousandStates) {
  constexpr double kRelative = 1e-12;
  Random random{kDynamicsSeed};
  double worst_torque = 0, worst_gravity = 0, worst_mass = 0;
  for (int a = 0; a < 100; ++a) {
    const Arm arm = random_arm(random);
    const auto joints = static_cast<unsigned>(arm.model.joints);
    const Vector3& g = arm.model.gravity_m_s2;
    KDL::ChainIdSolver_RNE inverse{arm.chain, KDL::Vector{g.x, g.y, g.z}};
    KDL::ChainDynParam parameters{arm.chain, KDL::Vector{g.x, g.y, g.z}};
    const KDL::Wrenches no_wrenches(joints);
    ArmDynamics ours{arm.model};
    for (int i = 0; i < 100; ++i) {
      PerAxis<double> q{}, qd{}, qdd{};
      KDL::JntArray kq{joints}, kqd{joints}, kqdd{joints}, torques{joints}, gravity{joints};
      for (unsigned j = 0; j < joints; ++j) {
        kq(j) = q[j] = random.real(-7, 7);
        kqd(j) = qd[j] = random.real(-5, 5);
        kqdd(j) = qdd[j] = random.real(-50, 50);
      }
      ours.set_posture(q);
      ASSERT_EQ(inverse.CartToJnt(kq, kqd, kqdd, no_wrenches, torques), 0);
      ASSERT_EQ(parameters.JntToGravity(kq, gravity), 0);
      KDL::JntSpaceInertiaMatrix mass{static_cast<int>(joints)};
      ASSERT_EQ(parameters.JntToMass(kq, mass), 0);
      const PerAxis<double> our_torques = ours.torques(qd, qdd), our_gravity = ours.gravity();
      const JointMatrix our_mass = ours.mass_matrix();
      const double largest_mass = mass.data.cwiseAbs().maxCoeff();
      for (unsigned j = 0; j < joints; ++j) {
        worst_torque = std::max(worst_torque, std::fabs(our_torques[j] - torques(j)) / largest(torques));
        worst_gravity = std::max(worst_gravity, std::fabs(our_gravity[j] - gravity(j)) / largest(gravity));
        for (unsigned k = 0; k < joints; ++k) {
          worst_mass = std::max(worst_mass, std::fabs(our_mass[j][k] - mass(j, k)) / largest_mass);
        }
      }
    }
  }
  EXPECT_LT(worst_torque, kRelative) << "seed " << kDynamicsSeed;
  EXPECT_LT(worst_gravity, kRelative) << "seed " << kDynamicsSeed;
  EXPECT_LT(worst_mass, kRelative) << "seed " << kDynamicsSeed;
}

TEST(Bodies, TogetherHaveTheInertiaOfTheirPointMasses) {
  // Two masses at the ends of a rod of 0.6 m: reduced mass 2 x 1 / 3 kg.
  const Body rod = together({2, {0.2, 0, 0}, {}}, {1, {0.2, 0.6, 0}, {}});
  EXPECT_DOUBLE_EQ(rod.mass_kg, 3);
  EXPECT_DOUBLE_EQ(rod.centre_m.x, 0.2);
  EXPECT_DOUBLE_EQ(rod.centre_m.y, 0.2);
  EXPECT_DOUBLE_EQ(rod.inertia_kg_m2.xx, 2.0 / 3 * 0.36);
  EXPECT_DOUBLE_EQ(rod.inertia_kg_m2.yy, 0);
  EXPECT_DOUBLE_EQ(rod.inertia_kg_m2.zz, 2.0 / 3 * 0.36);
  EXPECT_EQ(together({}, {}).mass_kg, 0);
}

}  // namespace
}  // namespace armature::cosim
