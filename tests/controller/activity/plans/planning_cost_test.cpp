#include "controller/activity/plans/stages/planning_cost.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "tests/controller/support/finish_plan.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::kReady;
using test::PathRig;

constexpr double kTicksPerInverse = 0.14;  // 7 us
constexpr double kBlend_mm = 0.02;

// Lines along y, one behind the other.
std::vector<SegmentRequest> lines(const Transform& from, const std::vector<double>& lengths_mm, ProfileKind profile) {
  std::vector<SegmentRequest> result;
  Transform at = from;
  for (const double length_mm : lengths_mm) {
    at.position_mm.y() += length_mm;
    result.push_back(test::line_to(at, test::kGentle, kBlend_mm));
    result.back().profile = profile;
  }
  return result;
}

double planned_ticks(CartesianPlanner& planner) {
  test::finish_plan(planner);
  return kTicksPerInverse * static_cast<double>(planner.inverses());
}

class PlanningCostOf : public testing::TestWithParam<ProfileKind> {};
INSTANTIATE_TEST_SUITE_P(Profiles, PlanningCostOf, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& test) { return test.param == ProfileKind::kSCurve ? "SCurve" : "Trapezoid"; });

// The law of the first plan is fine, and its first line long: for each move it costs more than ten times as much as the
// window behind it. Straight lines are easier than what is expected, most of all their check by bounds.
TEST_P(PlanningCostOf, BehindAPlanFromRestAWindowIsExpectedToTakeHalfToTwelveTimesItsTime) {
  const auto rig = std::make_unique<PathRig>(test::irb120());
  std::vector<double> lengths(16, 0.2);
  lengths.front() = 20.0;
  auto first = lines(rig->tool_at(kReady), lengths, GetParam());
  const Transform end = first.back().target;
  first.back().blend_mm = 0.0;
  rig->planner.begin(kReady, first);
  PlanningCost cost;
  const double first_ticks = planned_ticks(rig->planner);
  ASSERT_EQ(rig->planner.progress(), CartesianPlanner::Progress::kDone);
  cost.measure(first_ticks, rig->planner, first.size());

  for (const std::size_t count : {std::size_t{20}, std::size_t{100}}) {
    SCOPED_TRACE(count);
    auto added = lines(end, std::vector<double>(count, 0.2), GetParam());
    added.back().blend_mm = 0.0;
    ASSERT_TRUE(rig->planner.can_continue());
    ASSERT_TRUE(rig->planner.extend(Ticks{100}, kBlend_mm, added));
    const double actual = planned_ticks(rig->planner);
    ASSERT_EQ(rig->planner.progress(), CartesianPlanner::Progress::kDone);
    const CartesianPlan& plan = rig->planner.plan();
    const double expected = cost.ticks(static_cast<double>(plan.duration.value()), static_cast<double>(plan.count));
    EXPECT_GT(expected, 0.5 * actual) << "after " << first_ticks;
    EXPECT_LT(expected, 12.0 * actual) << "after " << first_ticks;
    rig->planner.begin(kReady, first);
    (void)planned_ticks(rig->planner);
  }
}

TEST(PlanningCost, OfAWholeIsThatOfItsParts) {
  const auto rig = std::make_unique<PathRig>(test::irb120());
  const auto chain = lines(rig->tool_at(kReady), {5.0}, ProfileKind::kTrapezoid);
  rig->planner.begin(kReady, chain);
  PlanningCost cost;
  cost.measure(planned_ticks(rig->planner), rig->planner, 1);
  EXPECT_DOUBLE_EQ(cost.ticks(300.0, 7.0), cost.ticks(100.0, 5.0) + cost.ticks(200.0, 2.0));
  EXPECT_GT(cost.ticks(300.0, 7.0), 0.0);
}

}  // namespace
}  // namespace armature
