#include "controller/language/gcode/execute/modes.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;
using gcode::Plane;
using gcode::SetFeedMode;
using gcode::SetFeedRate;
using gcode::SetMotionControlMode;
using gcode::SetNaiveCamTolerance;

struct GcodeModes : testing::Test, GcodeParts {};

TEST_F(GcodeModes, CountFeedInTheUnitsThatAreActive) {
  modes.set_units_and_plane(block("G20"));
  ASSERT_FALSE(modes.set_feed(block("F10")));
  EXPECT_DOUBLE_EQ(sink.last<SetFeedRate>().mm_min, 254.0);
  EXPECT_DOUBLE_EQ(sink.last<SetFeedRate>().number, 10.0);
}

TEST_F(GcodeModes, ForgetTheFeedWithItsMode) {
  ASSERT_FALSE(modes.set_feed(block("F10")));
  sink.clear();
  ASSERT_FALSE(modes.set_feed(block("G93 F2")));
  EXPECT_TRUE(sink.made<SetFeedMode>()) << "the number of F is for each motion";
  EXPECT_EQ(modes.active().feed, 2.0);
  sink.clear();
  ASSERT_FALSE(modes.set_feed(block("G94")));
  EXPECT_TRUE((sink.made<SetFeedMode, SetFeedRate>()));
  EXPECT_EQ(modes.active().feed, 0.0);
  EXPECT_EQ(code_of(modes.set_feed(block("F-1"))), ErrorCode::kWordNegative);
}

TEST_F(GcodeModes, TakeTheToleranceOfThePathForThatOfShortLinesToo) {
  modes.set_units_and_plane(block("G20"));
  ASSERT_FALSE(modes.set_control(block("G64 P0.1")));
  EXPECT_DOUBLE_EQ(sink.last<SetMotionControlMode>().tolerance_mm, 2.54);
  EXPECT_DOUBLE_EQ(sink.last<SetNaiveCamTolerance>().mm, 2.54);
  ASSERT_FALSE(modes.set_control(block("G64 P0.1 Q0")));
  EXPECT_EQ(sink.last<SetNaiveCamTolerance>().mm, 0.0);
  sink.clear();
  ASSERT_FALSE(modes.set_control(block("G61")));
  EXPECT_TRUE(sink.made<SetMotionControlMode>());
}

TEST_F(GcodeModes, RestoreOnlyWhatDiffers) {
  const gcode::Modes::Values before = modes.active();
  modes.restore_units_and_feed(before);
  modes.restore_plane(before);
  modes.restore_control_and_distances(before);
  EXPECT_TRUE(sink.calls.empty());
  modes.set_units_and_plane(block("G18 G20"));
  ASSERT_FALSE(modes.set_control(block("G61.1")));
  modes.set_distances(block("G91 G90.1 G99"));
  sink.clear();
  modes.restore_units_and_feed(before);
  modes.restore_plane(before);
  modes.restore_control_and_distances(before);
  EXPECT_TRUE((sink.made<gcode::UseLengthUnits, gcode::SelectPlane, SetMotionControlMode, SetNaiveCamTolerance>()));
  EXPECT_FALSE(modes.active().incremental || modes.active().absolute_centres);
  EXPECT_TRUE(modes.active().retract_to_start);
}

TEST_F(GcodeModes, KeepOnlyTheUnitsAtTheEnd) {
  modes.set_units_and_plane(block("G19 G20"));
  modes.set_distances(block("G91"));
  sink.clear();
  modes.end_program();
  EXPECT_TRUE((sink.made<gcode::SelectPlane, SetFeedMode, SetFeedRate>()));
  EXPECT_TRUE(modes.active().inches);
  EXPECT_FALSE(modes.active().incremental);
  EXPECT_EQ(modes.active().plane, Plane::kXy);
}

TEST_F(GcodeModes, AnswerTheirParameters) {
  modes.set_units_and_plane(block("G18 G20"));
  EXPECT_EQ(modes.value_of("_plane"), 180.0);
  EXPECT_EQ(modes.value_of("_imperial"), 1.0);
  EXPECT_EQ(modes.value_of("_metric"), 0.0);
  EXPECT_EQ(modes.value_of("_rpm"), std::nullopt);
}

}  // namespace
}  // namespace armature::test
