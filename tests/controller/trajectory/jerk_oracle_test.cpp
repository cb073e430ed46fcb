// S-curves against the fastest motion with limited jerk that an oracle finds, and the oracle against a closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "controller/trajectory/profile/scurve.hpp"
#include "tests/controller/support/jerk_cases.hpp"
#include "tests/controller/support/jerk_oracle.hpp"

namespace armature {
namespace {

constexpr int kNodes = 1'000;

TEST(JerkOracle, FindsTheFastestSCurveOfALine) {
  for (const double length_mm : {0.1, 10.0, 200.0}) {
    test::PathRig rig{test::irb120()};
    SegmentRequest line = test::line_to(test::moved(rig.tool_at(test::kReady), 0, length_mm, 0), test::kFast);
    line.profile = ProfileKind::kSCurve;
    ASSERT_EQ(rig.plan(test::kReady, line), CartesianPlanner::Progress::kDone);
    const test::OracleMotion motion = test::fastest_with_jerk(rig, kNodes);
    const SCurveProfile fastest = plan_scurve(
        length_mm, {.speed = test::kFast.speed_mm_s, .accel = test::kFast.accel_mm_s2, .jerk = test::kFast.jerk_mm_s3});
    EXPECT_NEAR(motion.duration_s, fastest.duration_s, 1e-3 * fastest.duration_s) << length_mm;
    EXPECT_LE(std::max({motion.shares.speed, motion.shares.accel, motion.shares.jerk}), 1.002) << length_mm;
  }
}

TEST(JerkOracle, SCurvesAreNotMuchSlower) {
  constexpr double kMost = 1.45, kMostJerk = 1.02;
  std::vector<test::JerkCase> cases{test::axis_1_at(5.0), test::random_jerk_case(1'008)};
  for (const test::JerkCase& path : cases) {
    SCOPED_TRACE(path.name);
    const auto rig = std::make_unique<test::PathRig>(path.robot);
    ASSERT_EQ(rig->plan(path.start, path.chain), CartesianPlanner::Progress::kDone);
    const test::OracleMotion motion = test::fastest_with_jerk(*rig, kNodes);
    EXPECT_LE(std::max({motion.shares.speed, motion.shares.accel, motion.shares.jerk}), 1.01);
    EXPECT_LE(seconds(rig->planner.plan().duration), kMost * motion.duration_s);
    for (const double shift : {0.0, 0.37}) {
      const test::SampledShares shares = test::shares_of_plan(*rig, shift);
      EXPECT_LE(std::max(shares.speed, shares.accel), 1.001);
      EXPECT_LE(shares.jerk, kMostJerk);
    }
  }
}

}  // namespace
}  // namespace armature
