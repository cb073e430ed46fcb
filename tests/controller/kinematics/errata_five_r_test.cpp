// Why FiveR differs from the print of Hu 2012: the equations as printed, one error at a time, do not solve the poses of
// the arm of Table 1. And Figure 2: its pose, its one solution and the values printed for it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;

// The paper's chain of formulas (10)-(15), with each of its errors or without.
struct Print {
  bool without_a1 = false;               // (2): a1 is not in the last column, so not in (13) and (14) either
  bool one_argument_arctangent = false;  // (10), (12)-(15)
  bool sign_of_14 = false;               // - d5 a_z
  bool without_a1_in_14 = false;
  bool signs_of_15 = false;
};

double arctangent(const Print& print, double y, double x) {
  return print.one_argument_arctangent ? std::atan(y / x) : std::atan2(y, x);
}

// All the answers of the paper with its +- of (13), and with the second root of (7) where the arctangent is one of two
// arguments. Only pairs that belong together.
bool solves(const Print& print, const Transform& pose) {
  const ArmGeometry arm = hu_arm();
  const double a1 = print.without_a1 ? 0.0 : arm.a1_mm;
  const auto n = pose.rotation.col(0), o = pose.rotation.col(1), a = pose.rotation.col(2);
  const auto& p = pose.position_mm;
  bool solved = false;
  for (const double root : {0.0, kPi}) {
    if (print.one_argument_arctangent && root > 0.0) break;
    const double th1 = arctangent(print, p.y(), p.x()) + root;
    const double c1 = std::cos(th1), s1 = std::sin(th1);
    const double u = c1 * a.x() + s1 * a.y();
    const double th5 = arctangent(print, s1 * n.x() - c1 * n.y(), s1 * o.x() - c1 * o.y());
    const double x = c1 * p.x() + s1 * p.y() - a1 - arm.d5_mm * u + arm.a4_mm * a.z();
    const double y = -p.z() + arm.d5_mm * a.z() + arm.a4_mm * u;
    const double m = x, k = (x * x + y * y + arm.a2_mm * arm.a2_mm - arm.a3_mm * arm.a3_mm) / (2.0 * arm.a2_mm);
    const double square = m * m + y * y - k * k;
    if (square < 0.0) continue;
    for (const double sign : {+1.0, -1.0}) {
      // x cos(th2) + y sin(th2) = k.
      const double th2 = arctangent(print, -m, y) + arctangent(print, k, sign * std::sqrt(square));
      const double c2 = std::cos(th2), s2 = std::sin(th2);
      const double numerator_14 =
          -p.z() - arm.a2_mm * s2 + arm.a4_mm * u + (print.sign_of_14 ? -1.0 : 1.0) * arm.d5_mm * a.z();
      const double denominator_14 = c1 * p.x() + s1 * p.y() - (print.without_a1_in_14 ? 0.0 : a1) - arm.a2_mm * c2 +
                                    arm.a4_mm * a.z() - arm.d5_mm * u;
      const double th3 = -th2 + arctangent(print, numerator_14, denominator_14);
      const double numerator_15 = u * c2 - a.z() * s2, denominator_15 = u * s2 + a.z() * c2;
      const double flip = print.signs_of_15 ? 1.0 : -1.0;
      const double th4 = -th3 + arctangent(print, flip * numerator_15, flip * denominator_15);
      const Transform reached = test::product_of_links(arm, Theta{th1, th2, th3, th4, th5, 0.0});
      solved = solved ||
               (test::rotation_difference(reached, pose) < 1e-6 && test::position_difference_mm(reached, pose) < 1e-6);
    }
  }
  return solved;
}

int solved_of_1000(const Print& print) {
  test::Random random{60};
  int solved = 0;
  for (int i = 0; i < 1000; ++i) {
    if (solves(print, test::product_of_links(hu_arm(), test::random_theta(random)))) ++solved;
  }
  return solved;
}

TEST(ErrataFiveR, TheCorrectedFormulasOfThePaperSolveEveryPose) {
  EXPECT_EQ(solved_of_1000({}), 1000);
}

TEST(ErrataFiveR, Equation2WithoutA1SolvesNothing) {
  EXPECT_EQ(solved_of_1000({.without_a1 = true}), 0);
}

TEST(ErrataFiveR, Equation10WithOneArgumentSolvesFewPoses) {
  const int solved = solved_of_1000({.one_argument_arctangent = true});
  EXPECT_GT(solved, 10);
  EXPECT_LT(solved, 100);
}

TEST(ErrataFiveR, Equation14AsPrintedSolvesNothing) {
  EXPECT_EQ(solved_of_1000({.sign_of_14 = true}), 0);
  EXPECT_EQ(solved_of_1000({.without_a1_in_14 = true}), 0);
}

TEST(ErrataFiveR, Equation15AsPrintedSolvesNothing) {
  EXPECT_EQ(solved_of_1000({.signs_of_15 = true}), 0);
}

TEST(ErrataFiveR, EverythingAsPrintedSolvesNothing) {
  EXPECT_EQ(solved_of_1000({.without_a1 = true,
                            .one_argument_arctangent = true,
                            .sign_of_14 = true,
                            .without_a1_in_14 = true,
                            .signs_of_15 = true}),
            0);
}

// Forward kinematics of q = (0, -90, 0, -90, 0) deg, which Figure 3 simulates and whose angles Figure 2 prints.
Transform figure_2_pose(const ArmGeometry& arm) {
  return test::product_of_links(arm, Theta{0.0, -kPi / 2, 0.0, -kPi / 2, 0.0, 0.0});
}

TEST(ErrataFiveR, ThePoseOfFigure2HasOneDoubleRoot) {
  for (const double a1 : {0.0, 1.1}) {
    const FiveR arm{hu_arm(a1)};
    const RawSolutions solutions = arm.inverse(figure_2_pose(hu_arm(a1)), Theta{});
    ASSERT_EQ(solutions.count, 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const RawBranch& branch = solutions.branches[i];
      EXPECT_EQ(branch.shoulder, -1);  // the tool point is behind axis 1
      EXPECT_EQ(branch.singular, kElbowSingular);
      EXPECT_LT(test::angle_distance(branch.theta, Theta{0.0, -kPi / 2, 0.0, -kPi / 2, 0.0, 0.0}), 3e-6);
    }
  }
}

TEST(ErrataFiveR, NoneOfTheValuesPrintedInFigure2ReachesItsPose) {
  const ArmGeometry arm = hu_arm(0.0);
  const Transform pose = figure_2_pose(arm);
  const auto miss_mm = [&](double th2_deg, double th3_deg, double th4_deg) -> Eigen::Vector3d {
    const double degree = kPi / 180.0;
    const Theta theta{0.0, th2_deg * degree, th3_deg * degree, th4_deg * degree, 0.0, 0.0};
    return test::product_of_links(arm, theta).position_mm - pose.position_mm;
  };
  // angle3_i belongs to angle2_i, angle4_i to the four pairs in the order of the print.
  EXPECT_LT((miss_mm(90, -180, 90) - Eigen::Vector3d{6.4, 0.0, -49.0}).norm(), 1e-13);
  EXPECT_LT((miss_mm(90, 0, -90) - Eigen::Vector3d{6.4, 0.0, -68.0}).norm(), 1e-13);
  EXPECT_LT((miss_mm(-90, -180, 270) - Eigen::Vector3d{6.4, 0.0, -48.0}).norm(), 1e-13);
  EXPECT_LT((miss_mm(-90, 0, 90) - Eigen::Vector3d{6.4, 0.0, -29.0}).norm(), 1e-13);
  EXPECT_LT(miss_mm(-90, 0, -90).norm(), 1e-13);
  EXPECT_LT(miss_mm(-90, 0, 270).norm(), 1e-13);
}

}  // namespace
}  // namespace armature
