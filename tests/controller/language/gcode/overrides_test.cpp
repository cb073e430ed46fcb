#include "controller/language/gcode/execute/overrides.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::EnableOverride;
using gcode::Overrides;
using Kind = Overrides::Kind;

struct GcodeOverrides : testing::Test, GcodeParts {};

TEST_F(GcodeOverrides, SwitchesFeedAndSpindleTogetherOrEachAlone) {
  ASSERT_FALSE(overrides.set(block("M49")));
  EXPECT_TRUE((sink.made<EnableOverride, EnableOverride>()));
  EXPECT_FALSE(overrides.is_on(Kind::kFeed) || overrides.is_on(Kind::kSpeed));
  ASSERT_FALSE(overrides.set(block("M51")));
  EXPECT_TRUE(overrides.is_on(Kind::kSpeed));
  ASSERT_FALSE(overrides.set(block("M53 P0")));
  EXPECT_FALSE(overrides.is_on(Kind::kFeedHold));
  ASSERT_FALSE(overrides.set(block("M52 P2")));
  EXPECT_EQ(overrides.value_of("_adaptive_feed"), 1.0);
  EXPECT_EQ(code_of(overrides.set(block("M50 P-1"))), gcode::ErrorCode::kWordNegative);
}

TEST_F(GcodeOverrides, RestoreAllButAdaptiveFeed) {
  const Overrides::Values before = overrides.active();
  ASSERT_FALSE(overrides.set(block("M49")));
  ASSERT_FALSE(overrides.set(block("M52")));
  sink.clear();
  overrides.restore(before);
  EXPECT_TRUE((sink.made<EnableOverride, EnableOverride>()));
  EXPECT_TRUE(overrides.is_on(Kind::kFeed) && overrides.is_on(Kind::kSpeed));
  EXPECT_TRUE(overrides.is_on(Kind::kAdaptiveFeed));
}

TEST_F(GcodeOverrides, HaveTheFeedOnAfterAProgram) {
  ASSERT_FALSE(overrides.set(block("M49")));
  sink.clear();
  overrides.end_program();
  EXPECT_TRUE(sink.made<EnableOverride>());
  EXPECT_TRUE(overrides.is_on(Kind::kFeed));
  EXPECT_FALSE(overrides.is_on(Kind::kSpeed));
}

}  // namespace
}  // namespace armature::test
