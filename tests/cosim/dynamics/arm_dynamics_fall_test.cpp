// Motions without torques: a double pendulum against its Lagrange equations, and the energy of a six-axis arm.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cosim/dynamics/arm_dynamics.hpp"

namespace armature::cosim {
namespace {

struct Motion {
  PerAxis<double> q{}, qd{};
};

// One step of Runge and Kutta's method of order 4 of q'' = accel(q, q').
template <class Accel>
Motion runge_kutta(const Motion& from, double h, Accel accel) {
  const auto moved = [&](const Motion& rate, double by) {
    Motion to = from;
    for (std::size_t i = 0; i < kAxes; ++i) {
      to.q[i] += by * rate.q[i];
      to.qd[i] += by * rate.qd[i];
    }
    return to;
  };
  const auto rate = [&](const Motion& at) { return Motion{at.qd, accel(at)}; };
  const Motion a = rate(from), b = rate(moved(a, h / 2)), c = rate(moved(b, h / 2)), d = rate(moved(c, h));
  Motion mean;
  for (std::size_t i = 0; i < kAxes; ++i) {
    mean.q[i] = (a.q[i] + 2 * b.q[i] + 2 * c.q[i] + d.q[i]) / 6;
    mean.qd[i] = (a.qd[i] + 2 * b.qd[i] + 2 * c.qd[i] + d.qd[i]) / 6;
  }
  return moved(mean, h);
}

// M(q) qdd = -bias(q, qd).
// No heap, which this build forbids to Eigen.
using BoundedMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kAxes, kAxes>;
using BoundedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kAxes, 1>;

PerAxis<double> free_accel(ArmDynamics& arm, const Motion& at) {
  const auto joints = static_cast<Eigen::Index>(arm.joints());
  arm.set_posture(at.q);
  const JointMatrix elements = arm.mass_matrix();
  const PerAxis<double> bias = arm.bias(at.qd);
  BoundedMatrix matrix(joints, joints);
  BoundedVector torques(joints);
  for (Eigen::Index i = 0; i < joints; ++i) {
    torques(i) = -bias[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < joints; ++j) {
      matrix(i, j) = elements[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
  }
  const BoundedVector solved = matrix.ldlt().solve(torques);
  PerAxis<double> accel{};
  for (Eigen::Index i = 0; i < joints; ++i) accel[static_cast<std::size_t>(i)] = solved(i);
  return accel;
}

struct Pendulum {
  double m1 = 2.0, m2 = 1.5, l1 = 0.4, c1 = 0.25, c2 = 0.2, i1 = 0.03, i2 = 0.02, g = 9.81;
};

// The Lagrange equations of a double pendulum in a vertical plane, y up: absolute angle q1 and relative angle q2, from
// the x axis.
PerAxis<double> lagrange(const Pendulum& p, const Motion& at) {
  const double q1 = at.q[0], q2 = at.q[1], w1 = at.qd[0], w2 = at.qd[1];
  const double coupling = p.m2 * p.l1 * p.c2;
  const double a = p.m1 * p.c1 * p.c1 + p.i1 + p.m2 * (p.l1 * p.l1 + p.c2 * p.c2) + p.i2 + 2 * coupling * std::cos(q2);
  const double b = p.m2 * p.c2 * p.c2 + p.i2 + coupling * std::cos(q2);
  const double d = p.m2 * p.c2 * p.c2 + p.i2;
  const double swing2 = p.m2 * p.g * p.c2 * std::cos(q1 + q2);
  const double t1 =
      coupling * std::sin(q2) * (2 * w1 * w2 + w2 * w2) - (p.m1 * p.c1 + p.m2 * p.l1) * p.g * std::cos(q1) - swing2;
  const double t2 = -coupling * std::sin(q2) * w1 * w1 - swing2;
  const double determinant = a * d - b * b;
  return {(d * t1 - b * t2) / determinant, (a * t2 - b * t1) / determinant};
}

TEST(FreeFall, OfATwoLinkArmFollowsTheLagrangeEquations) {
  const Pendulum p;
  ArmModel model{.joints = 2, .links = {}, .gravity_m_s2 = {0, -p.g, 0}};
  // Frame i is at the far end of link i.
  model.links[0] = {.a_m = p.l1, .body = {p.m1, {p.c1 - p.l1, 0, 0}, {.zz = p.i1}}};
  model.links[1] = {.a_m = 0.35, .body = {p.m2, {p.c2 - 0.35, 0, 0}, {.zz = p.i2}}};
  ArmDynamics arm{model};
  Motion ours, wanted;
  ours.q = wanted.q = {0.3, -0.2};
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    ours = runge_kutta(ours, 1e-3, [&](const Motion& at) { return free_accel(arm, at); });
    for (int k = 0; k < 5; ++k) {
      wanted = runge_kutta(wanted, 0.2e-3, [&](const Motion& at) { return lagrange(p, at); });
    }
    worst = std::max({worst, std::fabs(ours.q[0] - wanted.q[0]), std::fabs(ours.q[1] - wanted.q[1])});
  }
  EXPECT_GT(std::fabs(wanted.q[0] - 0.3) + std::fabs(wanted.q[1] + 0.2), 0.5);  // it has fallen
  EXPECT_LT(worst, 1e-6);                                                       // rad; swings are some rad
}

TEST(FreeFall, KeepsTheEnergyForTenSeconds) {
  ArmModel model{.joints = 6, .links = {}, .gravity_m_s2 = {0, 0, -9.81}};
  const double a[] = {0.05, 0.28, 0.035, 0, 0, 0}, d[] = {0.33, 0, 0, 0.3, 0, 0.08};
  const double sine[] = {1, 0, 1, -1, 1, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    model.links[i] = {.a_m = a[i],
                      .d_m = d[i],
                      .sin_alpha = sine[i],
                      .cos_alpha = sine[i] == 0 ? 1.0 : 0.0,
                      .body = {8.0 - static_cast<double>(i), {-0.05, 0.02, 0.03}, {0.05, 0.06, 0.04, 0.001, 0, 0}}};
  }
  ArmDynamics arm{model};
  Motion motion;
  motion.q = {0.2, 1.2, -0.4, 0.5, 0.8, 0};
  motion.qd = {0.5, 0, 0, 1, 0, 2};
  const auto energy = [&] {
    arm.set_posture(motion.q);
    return arm.energy(motion.qd);
  };
  const double before = energy();
  constexpr double kJoule = 0.01;
  double fastest = 0, worst = 0;
  for (int i = 0; i < 10'000; ++i) {
    motion = runge_kutta(motion, 1e-3, [&](const Motion& at) { return free_accel(arm, at); });
    for (const double speed : motion.qd) fastest = std::max(fastest, std::fabs(speed));
    worst = std::max(worst, std::fabs(energy() - before));
  }
  EXPECT_GT(fastest, 5);     // rad/s: it swings
  EXPECT_LT(worst, kJoule);  // of some 100 J that go to and fro
}

}  // namespace
}  // namespace armature::cosim
