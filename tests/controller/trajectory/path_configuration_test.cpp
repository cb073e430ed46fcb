// Requested configurations at the ends of paths: the start determines them, and another one is refused.
#include <gtest/gtest.h>

#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::kGentle;
using test::kReady;
using test::line_to;
using test::moved;
using Kind = PathProblem::Kind;
using Progress = CartesianPlanner::Progress;

SegmentRequest line_with(const Transform& target, const Configuration& wanted, ProfileKind profile,
                         double blend_mm = 0.0) {
  SegmentRequest request = line_to(target, kGentle, blend_mm, profile);
  request.configuration = wanted;
  return request;
}

class PathConfiguration : public testing::TestWithParam<ProfileKind> {
 protected:
  test::PathRig rig_{test::irb120()};
  Transform start_ = rig_.tool_at(kReady);
};

TEST_P(PathConfiguration, ThatOfTheStartIsAccepted) {
  const Configuration there = rig_.arm.configuration(kReady);
  EXPECT_EQ(there.shoulder, ShoulderSide::kFront);
  EXPECT_EQ(there.elbow, ElbowSide::kUp);
  EXPECT_EQ(there.wrist, WristSide::kNoflip);
  EXPECT_EQ(rig_.plan(kReady, line_with(moved(start_, 40, 30, -50), there, GetParam())), Progress::kDone);
  EXPECT_EQ(rig_.plan(kReady, line_with(moved(start_, 40, 30, -50), {.elbow = ElbowSide::kUp}, GetParam())),
            Progress::kDone);
}

TEST_P(PathConfiguration, AnotherSideIsRefusedWithItsName) {
  ASSERT_EQ(rig_.plan(kReady, line_with(moved(start_, 40, 30, -50),
                                        {.elbow = ElbowSide::kDown, .wrist = WristSide::kFlip}, GetParam())),
            Progress::kRefused);
  EXPECT_EQ(rig_.planner.problem().kind, Kind::kOtherConfiguration);
  EXPECT_EQ(rig_.planner.problem().configuration, kElbowPart | kWristPart);
  EXPECT_EQ(rig_.planner.problem().axis, 0);
}

TEST_P(PathConfiguration, OtherTurnsAreRefusedWithTheJoint) {
  Turns turns{};
  turns[5] = 1;
  ASSERT_EQ(rig_.plan(kReady, line_with(moved(start_, 0, 30, 0), {.turns = turns}, GetParam())), Progress::kRefused);
  EXPECT_EQ(rig_.planner.problem().configuration, kTurnsPart);
  EXPECT_EQ(rig_.planner.problem().axis, 6);
}

TEST_P(PathConfiguration, OfEverySegmentOfAChainIsChecked) {
  for (const double blend_mm : {0.0, 5.0}) {
    const std::vector<SegmentRequest> chain{
        line_with(moved(start_, 40, 0, 0), {.shoulder = ShoulderSide::kFront}, GetParam(), blend_mm),
        line_with(moved(start_, 40, 40, 0), {.shoulder = ShoulderSide::kBack}, GetParam(), blend_mm),
        line_with(moved(start_, 0, 40, 0), {}, GetParam())};
    ASSERT_EQ(rig_.plan(kReady, chain), Progress::kRefused);
    EXPECT_EQ(rig_.planner.problem().kind, Kind::kOtherConfiguration);
    EXPECT_EQ(rig_.planner.problem().segment, 1);
    EXPECT_EQ(rig_.planner.problem().configuration, kShoulderPart);
  }
}

TEST_P(PathConfiguration, OfAPathWithoutLengthIsThatOfTheArm) {
  EXPECT_EQ(rig_.plan(kReady, line_with(start_, {.elbow = ElbowSide::kUp}, GetParam())), Progress::kDone);
  ASSERT_EQ(rig_.plan(kReady, line_with(start_, {.elbow = ElbowSide::kDown}, GetParam())), Progress::kRefused);
  EXPECT_EQ(rig_.planner.problem().configuration, kElbowPart);
  // The same in front of a path that moves.
  const std::vector<SegmentRequest> chain{line_with(start_, {.elbow = ElbowSide::kDown}, GetParam()),
                                          line_with(moved(start_, 40, 0, 0), {}, GetParam())};
  ASSERT_EQ(rig_.plan(kReady, chain), Progress::kRefused);
  EXPECT_EQ(rig_.planner.problem().segment, 0);
}

INSTANTIATE_TEST_SUITE_P(BothProfiles, PathConfiguration,
                         testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve));

}  // namespace
}  // namespace armature
