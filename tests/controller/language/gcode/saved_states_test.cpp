#include "controller/language/gcode/execute/saved_states.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;

struct GcodeSavedStates : testing::Test, GcodeParts {
  GcodeSavedStates() { coordinates.begin_program({}); }
  std::optional<ErrorCode> execute(std::string_view text) { return code_of(saved_states.execute(block(text))); }
  void set_feed(std::string_view text) { ASSERT_FALSE(modes.set_feed(block(text))); }
};

TEST_F(GcodeSavedStates, RestoreEachPartOnceInTheOrderOfTheReference) {
  ASSERT_EQ(execute("M70"), std::nullopt);
  modes.set_units_and_plane(block("G20 G18"));
  set_feed("F10");
  ASSERT_FALSE(spindle.set_speed(block("S5")));
  ASSERT_FALSE(coordinates.set_tool_offset(block("G43.1 Z1")));
  coordinates.set_system(block("G55"));
  ASSERT_FALSE(modes.set_control(block("G61")));
  coolant.set(block("M8"));
  ASSERT_FALSE(overrides.set(block("M53 P0")));
  sink.clear();
  ASSERT_EQ(execute("M72"), std::nullopt);
  EXPECT_TRUE((sink.made<gcode::UseLengthUnits, gcode::SetFeedRate, gcode::SetSpindleSpeed, gcode::SelectPlane,
                         gcode::UseToolLengthOffset, gcode::SetG5xOffset, gcode::SetG92Offset, gcode::SetXyRotation,
                         gcode::SetMotionControlMode, gcode::SetNaiveCamTolerance, gcode::Mist, gcode::Flood,
                         gcode::EnableOverride>()));
  sink.clear();
  ASSERT_EQ(execute("M72"), std::nullopt) << "it stays saved";
  EXPECT_TRUE(sink.calls.empty());
}

TEST_F(GcodeSavedStates, BelongToTheirLevelOfCalls) {
  set_feed("F1");
  ASSERT_EQ(execute("M70"), std::nullopt);
  saved_states.begin_call();
  EXPECT_EQ(execute("M72"), ErrorCode::kNoSavedState);
  set_feed("F2");
  ASSERT_EQ(execute("M70"), std::nullopt);
  saved_states.end_call();
  EXPECT_EQ(modes.active().feed, 2.0) << "M70 does not restore by itself";
  ASSERT_EQ(execute("M72"), std::nullopt);
  EXPECT_EQ(modes.active().feed, 1.0);
  ASSERT_EQ(execute("M71"), std::nullopt);
  EXPECT_EQ(execute("M72"), ErrorCode::kNoSavedState);
}

TEST_F(GcodeSavedStates, AreRestoredAtTheReturnAfterM73) {
  saved_states.begin_call();
  set_feed("F1");
  ASSERT_EQ(execute("M73"), std::nullopt);
  set_feed("F2");
  saved_states.end_call();
  EXPECT_EQ(modes.active().feed, 1.0);
  EXPECT_EQ(saved_states.call_level(), 0U);
}

}  // namespace
}  // namespace armature::test
