// The cost of the set-points at passages of the wrist singularity.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;

TEST(Sampler, NeedsOneInverseOnABendOfTheWrist) {
  test::PathRig rig{test::irb120()};
  const JointAngles start = degrees({0, 10, -20, 0, -20, 0});
  const Transform target = test::turned_by(rig.tool_at(start), 40.0 * test::kDeg, {0, 1, 0});
  ASSERT_EQ(rig.plan(start, test::line_to(target, test::kGentle)), CartesianPlanner::Progress::kDone);
  ASSERT_EQ(rig.planner.plan().bends.count, 1u);
  test::KeepingSampler sampler{rig.robot, rig.arm, start};
  sampler.start(rig.planner.plan(), 1.0);
  while (true) {
    (void)sampler.advance(1.0);
    if (!sampler.busy()) break;
    ASSERT_EQ(sampler.inverses(), 1);
  }
}

// Joint 5 passes 0 in the middle of each line. The last line is one more than a plan has bends for: within 1e-3 rad of
// the singularity each of its set-points looks one tick to either side.
TEST(Sampler, CountsTheInversesOfAPassageOfTheWristSingularity) {
  test::PathRig rig{test::irb120()};
  const JointAngles start = degrees({0, 10, -20, 0, -20, 0});
  const Transform here = rig.tool_at(start), there = test::turned_by(here, 40.0 * test::kDeg, {0, 1, 0});
  std::vector<SegmentRequest> chain;
  for (std::size_t i = 0; i <= WristBends::kMax; ++i) {
    chain.push_back(test::line_to(i % 2 == 0 ? there : here, test::kGentle, 0.0, ProfileKind::kSCurve));
  }
  ASSERT_EQ(rig.plan(start, chain), CartesianPlanner::Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  ASSERT_EQ(plan.bends.count, WristBends::kMax);
  test::KeepingSampler sampler{rig.robot, rig.arm, start};
  sampler.start(plan, 1.0);
  int near_by = 0, through = 0;
  for (std::int64_t tick = 1; sampler.busy(); ++tick) {
    const double sine = std::fabs(rig.arm.wrist_sine(sampler.advance(1.0)));
    if (!sampler.busy()) break;  // the end is exact, not computed
    const bool last = tick > plan.segments[WristBends::kMax].start.value();
    if (!last || sine > 1.1e-3) {
      ASSERT_EQ(sampler.inverses(), 1) << sine;
    }
    if (last && sine < 0.9e-3) {
      ++near_by;
      ASSERT_GE(sampler.inverses(), 3) << sine;
    }
    ASSERT_LE(sampler.inverses(), FollowedTool::kMaxInverses);
    if (sampler.inverses() == FollowedTool::kMaxInverses) ++through;
  }
  EXPECT_GT(near_by, 10);
  EXPECT_GE(through, 1);
  EXPECT_LE(through, 2);
}

}  // namespace
}  // namespace armature
