#include "controller/language/gcode/execute/tools.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;

struct GcodeTools : testing::Test, GcodeParts {};

TEST_F(GcodeTools, AreChangedOnlyByM6AndWithAStandingSpindle) {
  tools.add(3, gcode::Axes6{});
  spindle.turn(1);
  ASSERT_FALSE(tools.select(block("T3")));
  EXPECT_EQ(tools.current(), 0);
  EXPECT_EQ(tools.value_of("_selected_tool"), 3.0);
  sink.clear();
  tools.change(block("M6"));
  EXPECT_TRUE((sink.made<gcode::StartChange, gcode::StopSpindle, gcode::ChangeTool>()));
  EXPECT_EQ(sink.last<gcode::ChangeTool>().number, 3);
  EXPECT_EQ(tools.current(), 3);
  EXPECT_EQ(spindle.active().direction, 0);
}

TEST_F(GcodeTools, MustBeInTheTable) {
  gcode::ToolNumbers numbers;
  numbers.set(63);
  tools.add(numbers);
  EXPECT_FALSE(tools.select(block("T63")));
  EXPECT_FALSE(tools.select(block("T0"))) << "no tool";
  const gcode::Failure unknown = tools.select(block("T62"));
  EXPECT_EQ(code_of(unknown), ErrorCode::kToolUnknown);
  EXPECT_EQ(unknown->tenths, 620);
  EXPECT_EQ(code_of(tools.select(block("T64"))), ErrorCode::kWordRange);
  EXPECT_EQ(code_of(tools.select(block("T1.5"))), ErrorCode::kNotAnInteger);
}

TEST_F(GcodeTools, StayInTheTableFromProgramToProgram) {
  tools.add(1, {0, 0, 7, 0, 0, 0});
  ASSERT_FALSE(tools.select(block("T1")));
  tools.change(block("M6"));
  tools.begin_program();
  EXPECT_EQ(tools.current(), 0);
  ASSERT_NE(tools.offset_of(1), nullptr);
  EXPECT_EQ((*tools.offset_of(1))[2], 7.0);
}

}  // namespace
}  // namespace armature::test
