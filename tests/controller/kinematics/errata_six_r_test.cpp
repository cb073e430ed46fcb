// Why six_r.cpp differs from the print of Vo 2021: eq. (24)-(45) are carried out here as the paper does, with each
// equation corrected or as printed. Corrected they are right; each misprint alone makes them wrong.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::kPi;
constexpr std::uint64_t kErrataSeed = 1034;
using Row = Eigen::RowVector4d;

enum class Misprint { kNone, k30, k31, k32, k33 };

// The rows V_ij of eq. (29)-(33), with d6 removed: column 4 of V_0 is the wrist centre. `shoulder`, `elbow` and `flip`
// add the branches that the paper leaves out.
Theta solve_as_the_paper(const ArmGeometry& g, const Transform& pose, int shoulder, int elbow, int flip,
                         Misprint misprint) {
  const Row m{0, 0, 0, 1};
  Row v0[3];
  const Eigen::Vector3d p = pose.position_mm - g.d6_mm * pose.rotation.col(2);
  for (Eigen::Index row = 0; row < 3; ++row) v0[row] << pose.rotation.row(row), p(row);

  const double theta1 = std::atan2(shoulder * p.y(), shoulder * p.x());  // (39)
  const double c1 = std::cos(theta1), s1 = std::sin(theta1);
  const Row v1[3] = {c1 * v0[0] + s1 * v0[1] - g.a1_mm * m, v0[2] - g.d1_mm * m, s1 * v0[0] - c1 * v0[1]};  // (29)

  const double x = v1[0](3), y = v1[1](3), distance = std::hypot(x, y);
  const double n = (g.a2_mm * g.a2_mm - g.d4_mm * g.d4_mm - g.a3_mm * g.a3_mm + distance * distance) /
                   (2 * g.a2_mm * distance);                      // (41)
  const double theta2 = std::atan2(y, x) + elbow * std::acos(n);  // (40), which prints (45) instead
  const double c2 = std::cos(theta2), s2 = std::sin(theta2);
  const double sign30 = misprint == Misprint::k30 ? +1 : -1;
  const Row v2[2] = {c2 * v1[0] + s2 * v1[1] - g.a2_mm * m, sign30 * s2 * v1[0] + c2 * v1[1]};  // (30)

  const double theta3 = std::atan2(v2[0](3), -v2[1](3)) - std::atan2(g.a3_mm, g.d4_mm);  // (42)
  const double c3 = std::cos(theta3), s3 = std::sin(theta3);
  const double c23 = std::cos(theta2 + theta3), s23 = std::sin(theta2 + theta3);
  const double s31 = misprint == Misprint::k31 ? s2 : s23;
  const Row v3[3] = {c23 * v1[0] + s31 * v1[1] - (g.a2_mm * c3 + g.a3_mm) * m, v1[2],
                     s23 * v1[0] - c23 * v1[1] - g.a2_mm * s3 * m};  // (31)

  const double theta4 = std::atan2(flip * v3[1](2), flip * v3[0](2));  // (43), with the quadrant
  const double c4 = std::cos(theta4), s4 = std::sin(theta4);
  const double theta5 = std::atan2(c4 * v3[0](2) + s4 * v3[1](2), v3[2](2));  // (44)
  const double c5 = std::cos(theta5), s5 = std::sin(theta5);
  const double sign32 = misprint == Misprint::k32 ? +1 : -1;
  const Row v4[3] = {c4 * v3[0] + s4 * v3[1], -v3[2] + g.d4_mm * m, sign32 * s4 * v3[0] + c4 * v3[1]};  // (32)

  const double sign33 = misprint == Misprint::k33 ? -1 : +1;
  const Row v5[2] = {c5 * v4[0] + s5 * v4[1], sign33 * v4[2]};                      // (33)
  return {theta1, theta2, theta3, theta4, theta5, std::atan2(v5[1](0), v5[0](0))};  // (45)
}

// How many of the branches of random poses come out right.
struct Score {
  int right = 0, branches = 0;
};
Score score_of(Misprint misprint) {
  test::Random random{kErrataSeed};
  Score score;
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const SixR arm{geometry};
    for (int i = 0; i < 200; ++i) {
      const Transform pose = arm.forward(test::random_angles(random));
      const RawSolutions truth = arm.inverse(pose, Theta{});
      for (std::size_t k = 0; k < truth.count; ++k) {
        const RawBranch& branch = truth.branches[k];
        const Theta theta = solve_as_the_paper(geometry, pose, branch.shoulder, branch.elbow, branch.flip, misprint);
        ++score.branches;
        if (test::angle_error(theta, branch.theta) < 1e-6 && test::rotation_error(arm.forward(theta), pose) < 1e-6) {
          ++score.right;
        }
      }
    }
  }
  return score;
}

TEST(VoErrata, CorrectedEquationsSolveEveryBranch) {
  const Score score = score_of(Misprint::kNone);
  EXPECT_GT(score.branches, 4000);
  EXPECT_EQ(score.right, score.branches);
}
TEST(VoErrata, Eq30AsPrintedSolvesNothing) {
  EXPECT_EQ(score_of(Misprint::k30).right, 0);
}
TEST(VoErrata, Eq31AsPrintedSolvesNothing) {
  EXPECT_EQ(score_of(Misprint::k31).right, 0);
}
TEST(VoErrata, Eq32AsPrintedSolvesNothing) {
  EXPECT_EQ(score_of(Misprint::k32).right, 0);
}
TEST(VoErrata, Eq33AsPrintedSolvesNothing) {
  EXPECT_EQ(score_of(Misprint::k33).right, 0);
}

// One shoulder (39) and one wrist (43) are a quarter of the configurations; the elbow is chosen rightly here.
TEST(VoErrata, Eq39And43AloneFindTheArmInAQuarterOfThePoses) {
  test::Random random{kErrataSeed};
  const ArmGeometry geometry = test::kr6_r900();
  const SixR arm{geometry};
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Theta truth = test::random_angles(random);
    const Transform pose = arm.forward(truth);
    bool hit = false;
    for (const int elbow : {+1, -1}) {
      Theta theta = solve_as_the_paper(geometry, pose, +1, elbow, +1, Misprint::kNone);
      hit = hit || test::angle_error(theta, truth) < 1e-6;
    }
    found += hit ? 1 : 0;
  }
  EXPECT_GT(found, 200);
  EXPECT_LT(found, 300);
}

// (41) at the reach limit: rounding puts the cosine beyond 1, where acos is a NaN.
TEST(VoErrata, Eq41ExceedsOneByRoundingWhereTheArmIsStretched) {
  test::Random random{kErrataSeed};
  const ArmGeometry geometry = test::irb120_geometry();
  const SixR arm{geometry};
  const double phi = std::atan2(geometry.d4_mm, geometry.a3_mm);
  int not_a_number = 0;
  for (int i = 0; i < 300; ++i) {
    Theta stretched = test::random_angles(random);
    stretched[2] = phi;
    const Transform pose = arm.forward(stretched);
    if (std::isnan(solve_as_the_paper(geometry, pose, +1, +1, +1, Misprint::kNone)[1])) ++not_a_number;
    const RawSolutions solutions = arm.inverse(pose, Theta{});
    ASSERT_EQ(solutions.count, 8u) << "seed " << kErrataSeed << " " << i;
    EXPECT_LT(test::position_error_mm(arm.forward(solutions.branches[0].theta), pose), 1e-12 * 700);
  }
  EXPECT_GT(not_a_number, 30);
}

Eigen::Matrix4d link(double theta, double a, double alpha, double d, bool as_printed) {
  const double c = std::cos(theta), s = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  Eigen::Matrix4d matrix;
  matrix << c, -s * ca, s * sa, a * c,                  //
      s, as_printed ? c * sa : c * ca, -c * sa, a * s,  //
      0, sa, ca, d,                                     //
      0, 0, 0, 1;
  return matrix;
}
Eigen::Matrix4d product_of_links(const ArmGeometry& g, const Theta& theta, bool as_printed) {
  return link(theta[0], g.a1_mm, kPi / 2, g.d1_mm, as_printed) * link(theta[1], g.a2_mm, 0, 0, as_printed) *
         link(theta[2], g.a3_mm, kPi / 2, 0, as_printed) * link(theta[3], 0, -kPi / 2, g.d4_mm, as_printed) *
         link(theta[4], 0, kPi / 2, 0, as_printed) * link(theta[5], 0, 0, g.d6_mm, as_printed);
}

TEST(VoErrata, Eq24AsPrintedIsNoRigidMotion) {
  test::Random random{kErrataSeed};
  const ArmGeometry geometry = test::lrmate200id();
  const SixR arm{geometry};
  for (int i = 0; i < 200; ++i) {
    const Theta theta = test::random_angles(random);
    const Transform pose = arm.forward(theta);
    const Eigen::Matrix4d product = product_of_links(geometry, theta, false);
    EXPECT_LT((product.topLeftCorner<3, 3>() - pose.rotation).cwiseAbs().maxCoeff(), 4e-15);
    EXPECT_LT((product.topRightCorner<3, 1>() - pose.position_mm).cwiseAbs().maxCoeff(), 3e-12);
    const Eigen::Matrix4d printed = product_of_links(geometry, theta, true);
    EXPECT_FALSE(is_rigid({printed.topLeftCorner<3, 3>(), printed.topRightCorner<3, 1>()})) << i;
  }
}

Eigen::Matrix3d expanded_rotation(const Theta& theta, bool as_printed) {
  const double c1 = std::cos(theta[0]), s1 = std::sin(theta[0]), c4 = std::cos(theta[3]), s4 = std::sin(theta[3]);
  const double c5 = std::cos(theta[4]), s5 = std::sin(theta[4]), c6 = std::cos(theta[5]), s6 = std::sin(theta[5]);
  const double c23 = std::cos(theta[1] + theta[2]), s23 = std::sin(theta[1] + theta[2]);
  const double a = c1 * c4 + s1 * s4 * c23, b = s1 * c4 - c1 * s4 * c23;
  const double c = s1 * s4 + c1 * c4 * c23, d = c1 * s4 - s1 * c4 * c23;
  Eigen::Matrix3d r;
  if (!as_printed) {
    r << s6 * b - c6 * (c1 * s5 * s23 - c5 * c), c6 * b + s6 * (c1 * s5 * s23 - c5 * c), c1 * c5 * s23 + s5 * c,
        -c6 * (s1 * s5 * s23 + c5 * d) - s6 * a, s6 * (s1 * s5 * s23 + c5 * d) - c6 * a, s1 * c5 * s23 - s5 * d,
        c6 * (c23 * s5 + s23 * c4 * c5) - s23 * s4 * s6, -s6 * (c23 * s5 + s23 * c4 * c5) - s23 * s4 * c6,
        s23 * c4 * s5 - c23 * c5;
    return r;
  }
  const double c_print = s1 * s4 + c1 * c4 * s23;
  r << s6 * b - c6 * (c1 * s5 * s23 - c5 * c_print),
      c6 * (s1 * c4 - s1 * s4 * c23) + s6 * (c1 * s5 * s23 - c5 * c_print), c1 * c5 * s23 + s5 * c,
      -c6 * (s1 * s5 * s23 + c5 * (c1 * s4 + s1 * s4 * c23)) - s6 * a,
      s6 * (s1 * s5 * s23 + c5 * (c1 * s4 + s1 * s4 * c23)) - c6 * a, s1 * c5 * s23 - s5 * (c1 * s4 - s1 * s4 * c23),
      c6 * (c23 * s5 + s23 * c4 * c5) - s23 * s4 * s6, -s6 * (c23 * s5 + s23 * c4 * c5) - s23 * s4 * s6,
      s23 * c4 * s5 - c23 * c5;
  return r;
}

TEST(VoErrata, Eq26And27AsPrintedAreOffByMoreThanOneAndNoRotation) {
  test::Random random{kErrataSeed};
  const SixR arm{test::irb120_geometry()};
  double worst = 0.0, least_determinant = 1.0, most_determinant = 1.0;
  Eigen::Matrix3d worst_entry = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const Theta theta = test::random_angles(random);
    const Eigen::Matrix3d truth = arm.forward(theta).rotation;
    ASSERT_LT((expanded_rotation(theta, false) - truth).cwiseAbs().maxCoeff(), 4e-15);
    const Eigen::Matrix3d printed = expanded_rotation(theta, true);
    worst_entry = worst_entry.cwiseMax((printed - truth).cwiseAbs());
    worst = worst_entry.maxCoeff();
    least_determinant = std::min(least_determinant, printed.determinant());
    most_determinant = std::max(most_determinant, printed.determinant());
  }
  EXPECT_GT(worst, 1.0);
  EXPECT_LT(least_determinant, 0.0);
  EXPECT_GT(most_determinant, 1.5);
  // Only r13, r31 and r33 are right.
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      const bool right = (row == 0 && column == 2) || (row == 2 && column != 1);
      EXPECT_EQ(worst_entry(row, column) < 1e-14, right) << row << " " << column;
    }
  }
}

}  // namespace
}  // namespace armature
