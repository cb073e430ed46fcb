#include "controller/kinematics/branch_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "controller/kinematics/turns.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
using test::kDeg;
constexpr std::uint64_t kBranchChoiceSeed = 14;

double nearest_turn_inside(double joint_rad, double previous_rad, const JointRange& range) {
  return turned_inside(nearest_turn(joint_rad, previous_rad), range);
}

PerAxis<JointRange> ranges(double limit_rad) {
  PerAxis<JointRange> all;
  all.fill({-limit_rad, limit_rad, 1.0});
  return all;
}

IkBranch branch_at(const PerAxis<double>& rad) {
  IkBranch branch;
  branch.joints = make_per_axis([&](std::size_t i) { return Radians{rad[i]}; });
  return branch;
}

IkSolutions solutions_of(std::initializer_list<PerAxis<double>> all) {
  IkSolutions solutions;
  solutions.status = IkStatus::kOk;
  for (const PerAxis<double>& rad : all) solutions.branches[solutions.count++] = branch_at(rad);
  return solutions;
}

TEST(TurnInside, IsTheNearestOfAllTurnsInsideTheLimits) {
  test::Random random{kBranchChoiceSeed};
  int with_choice = 0, without = 0;
  for (int i = 0; i < 5000; ++i) {
    const double low = random.real(-8, 2), high = low + random.real(0, 14);
    const JointRange range{low, high, 1.0};
    const double joint = random.real(-10, 10), previous = random.real(-12, 12);
    double best = 0.0, least = std::numeric_limits<double>::infinity();
    double best_outside = 0.0, least_excess = least;
    for (int turns = -6; turns <= 6; ++turns) {
      const double candidate = joint + turns * kTurn;
      const double excess = std::max(low - candidate, candidate - high);
      if (excess <= 0.0 && std::fabs(candidate - previous) < least) {
        least = std::fabs(candidate - previous);
        best = candidate;
      }
      if (excess < least_excess) {
        least_excess = excess;
        best_outside = candidate;
      }
    }
    const bool exists = std::isfinite(least);
    (exists ? with_choice : without) += 1;
    ASSERT_NEAR(nearest_turn_inside(joint, previous, range), exists ? best : best_outside, 1e-13)
        << "seed " << kBranchChoiceSeed << " " << i;
  }
  EXPECT_GT(with_choice, 1000);
  EXPECT_GT(without, 100);
}

TEST(TurnInside, LeavesAnAngleThatFitsUntouched) {
  EXPECT_EQ(nearest_turn_inside(0.1, 0.3, {-1.0, 1.0, 1.0}), 0.1);
  EXPECT_EQ(nearest_turn_inside(3.0, 0.0, {-3.0, 3.0, 1.0}), 3.0) << "the limit belongs to the range";
}

TEST(LimitExcess, OfRoundingIsZeroAndTakenAsTheLimit) {
  const JointRange range{-1.0, 2.0, 1.0};
  double joint = 2.0 + 0.9e-9;
  EXPECT_EQ(limit_excess(joint, range), 0.0);
  EXPECT_EQ(joint, 2.0);
  joint = -1.0 - 0.9e-9;
  EXPECT_EQ(limit_excess(joint, range), 0.0);
  EXPECT_EQ(joint, -1.0);
  joint = 2.0 + 1.1e-9;
  EXPECT_NEAR(limit_excess(joint, range), 1.1e-9, 1e-15);
  EXPECT_EQ(joint, 2.0 + 1.1e-9);
  joint = -1.5;
  EXPECT_DOUBLE_EQ(limit_excess(joint, range), 0.5);
  joint = 0.3;
  EXPECT_EQ(limit_excess(joint, range), 0.0);
  EXPECT_EQ(joint, 0.3);
}

// One turn further, a joint at its limit by rounding is still found.
TEST(TurnInside, FindsTheLimitItself) {
  const JointRange range{-400 * kDeg, 400 * kDeg, 1.0};
  for (const double rounding : {0.0, 1e-13, -1e-13}) {
    const double found = nearest_turn_inside(40 * kDeg + rounding, 399 * kDeg, range);
    EXPECT_NEAR(found, 400 * kDeg, 1e-12);
    const double from_beyond = nearest_turn_inside(40 * kDeg + rounding, 760 * kDeg, range);
    EXPECT_NEAR(from_beyond, 400 * kDeg, 1e-12) << "one turn back, not two";
    EXPECT_NEAR(nearest_turn_inside(-40 * kDeg - rounding, -760 * kDeg, range), -400 * kDeg, 1e-12);
  }
}

TEST(BranchChoice, TakesTheBranchThatIsReachedSoonestNotTheNearestOne) {
  PerAxis<JointRange> all = ranges(3.0);
  all[0].max_speed_rad_s = 10.0;
  // Branch 0: axis 2 by 0.5 rad, 0.5 s. Branch 1: axis 1 by 2 rad, 0.2 s.
  IkSolutions solutions = solutions_of({{0, 0.5, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0}});
  choose_branch(solutions, {}, all);
  EXPECT_EQ(solutions.selected, 1);
  EXPECT_EQ(solutions.status, IkStatus::kOk);
  choose_branch(solutions, {}, ranges(3.0));
  EXPECT_EQ(solutions.selected, 0);
}

TEST(BranchChoice, TellsEqualTimesApartByTheSumOfSquaresAndThenByOrder) {
  IkSolutions squares = solutions_of({{1, 0.5, 0, 0, 0, 0}, {0, 0, -1, 0, 0, 0.1}, {0, 1, 0, 0, 0.2, 0}});
  choose_branch(squares, {}, ranges(3.0));
  EXPECT_EQ(squares.selected, 1);
  IkSolutions order = solutions_of({{0, 0, 0, 2, 0, 0}, {1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}});
  choose_branch(order, {}, ranges(3.0));
  EXPECT_EQ(order.selected, 1);
}

TEST(BranchChoice, CountsTheTurnsOfTheLimits) {
  PerAxis<JointRange> all = ranges(3.0);
  all[5] = {-400 * kDeg, 400 * kDeg, 1.0};
  const JointAngles previous = branch_at({0, 0, 0, 0, 0, 350 * kDeg}).joints;
  IkSolutions solutions = solutions_of({{0, 0, 0, 0, 0, 170 * kDeg}, {0, 0, 0, 0, 0, 20 * kDeg}});
  choose_branch(solutions, previous, all);
  EXPECT_EQ(solutions.selected, 1);
  EXPECT_NEAR(solutions.branches[1].joints[5].value(), 380 * kDeg, 1e-14);
  EXPECT_NEAR(solutions.branches[0].joints[5].value(), 170 * kDeg, 1e-14);
}

TEST(BranchChoice, PassesOverBranchesOutsideTheLimits) {
  IkSolutions solutions = solutions_of({{0, 0, 1.2, 0, 0, 0}, {0, 0.9, 0, 0, 0, 0}});
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.selected, 1);
  EXPECT_FALSE(solutions.branches[0].within_limits);
  EXPECT_EQ(solutions.branches[0].outside_axis, 3);
  EXPECT_TRUE(solutions.branches[1].within_limits);
  EXPECT_EQ(solutions.branches[1].outside_axis, 0);
  EXPECT_EQ(solutions.axis, 0);
}

TEST(BranchChoice, NamesTheWorstJointOfTheBranchThatMissesItsLimitsByLeast) {
  IkSolutions solutions = solutions_of({{0, 0, 2.0, 0, 0, 0}, {0, 1.1, 0, 0, -1.3, 0}, {1.2, 0, 0, 0, 0, 1.6}});
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.selected, -1);
  EXPECT_EQ(solutions.status, IkStatus::kOutsideLimits);
  EXPECT_EQ(solutions.axis, 5);
  EXPECT_NEAR(solutions.angle_rad, -1.3, 1e-12);
  EXPECT_EQ(solutions.branches[2].outside_axis, 6);
}

TEST(BranchChoice, PassesOnWhatTheSelectedBranchSaysOfItself) {
  IkSolutions solutions = solutions_of({{0, 0, 0.5, 0, 0, 0}, {0, 0.1, 0, 0, 0, 0}});
  solutions.branches[1].singular = kWristSingular;
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.status, IkStatus::kSingular);
  EXPECT_EQ(solutions.singular, kWristSingular);
  solutions.branches[1].singular = kElbowSingular;  // no angle is free
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.status, IkStatus::kOk);
  EXPECT_EQ(solutions.singular, kElbowSingular);
  solutions.branches[1].clamped = true;
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.status, IkStatus::kClamped);
}

TEST(BranchChoice, LeavesAPoseWithoutBranchesAlone) {
  IkSolutions solutions;
  solutions.status = IkStatus::kOrientation;
  choose_branch(solutions, {}, ranges(1.0));
  EXPECT_EQ(solutions.selected, -1);
  EXPECT_EQ(solutions.status, IkStatus::kOrientation);
}

}  // namespace
}  // namespace armature
