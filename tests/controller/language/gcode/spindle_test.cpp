#include "controller/language/gcode/execute/spindle.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::SetSpindleMode;
using gcode::SetSpindleSpeed;
using gcode::StartSpindle;
using gcode::StopSpindle;

struct GcodeSpindle : testing::Test, GcodeParts {};

TEST_F(GcodeSpindle, TurnsInTheDirectionOfItsCode) {
  spindle.set_direction(block("M3"));
  EXPECT_TRUE(sink.last<StartSpindle>().clockwise);
  spindle.set_direction(block("M4"));
  EXPECT_FALSE(sink.last<StartSpindle>().clockwise);
  EXPECT_EQ(spindle.value_of("_spindle_on"), 1.0);
  EXPECT_EQ(spindle.value_of("_spindle_cw"), 0.0);
  spindle.set_direction(block("M5"));
  EXPECT_TRUE((sink.made<StartSpindle, StartSpindle, StopSpindle>()));
}

TEST_F(GcodeSpindle, HasNoLimitForASurfaceSpeedWithoutD) {
  ASSERT_FALSE(spindle.set_speed(block("G96 D-2500 S20")));
  EXPECT_EQ(sink.last<SetSpindleMode>().max_rpm, 2500.0);
  ASSERT_FALSE(spindle.set_speed(block("G96 S20")));
  EXPECT_GE(sink.last<SetSpindleMode>().max_rpm, 1e9);
  EXPECT_EQ(spindle.value_of("_spindle_css_mode"), 1.0);
  EXPECT_EQ(code_of(spindle.set_speed(block("G96"))), gcode::ErrorCode::kWordMissing);
  EXPECT_EQ(code_of(spindle.set_speed(block("S-1"))), gcode::ErrorCode::kWordNegative);
}

TEST_F(GcodeSpindle, RestoresModeSpeedAndDirection) {
  ASSERT_FALSE(spindle.set_speed(block("S100")));
  spindle.turn(1);
  const gcode::Spindle::Values before = spindle.active();
  ASSERT_FALSE(spindle.set_speed(block("G96 S20")));
  spindle.turn(0);
  sink.clear();
  spindle.restore(before);
  EXPECT_TRUE((sink.made<SetSpindleMode, SetSpindleSpeed, StartSpindle>()));
  sink.clear();
  spindle.restore(before);
  EXPECT_TRUE(sink.calls.empty());
  EXPECT_EQ(spindle.active().speed_rpm, 100.0);
}

}  // namespace
}  // namespace armature::test
