#include "controller/language/gcode/execute/executor.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;
using After = gcode::Executor::After;

struct GcodeExecutor : testing::Test {
  GcodeExecutor() {
    executor->tools().add(1, gcode::Axes6{});
    executor->begin_program({});
    sink.clear();
  }
  std::optional<ErrorCode> execute(std::string_view text, std::uint32_t line = 1) {
    executor->begin_line(line);
    gcode::Block block = block_of(text, gcode::find_code('g', 0));
    return code_of(executor->execute(block));
  }
  KeepingSink sink;
  std::unique_ptr<gcode::Executor> executor = std::make_unique<gcode::Executor>(sink);
};

// RS274/NGC, order of execution, with one code of each step.
TEST_F(GcodeExecutor, ExecutesTheCodesOfALineInTheOrderOfTheLanguage) {
  ASSERT_EQ(execute("M0 G1 X1 G92.1 G99 G91 G61 G55 G49 G20 G18 G94 M50 M8 M3 M6 M64 P1 T1 S100 F20", 7), std::nullopt);
  EXPECT_TRUE(
      (sink.made<gcode::SetFeedMode, gcode::SetFeedRate, gcode::SetFeedRate, gcode::SetSpindleSpeed, gcode::SelectTool,
                 gcode::SetDigitalOutput, gcode::StartChange, gcode::StopSpindle, gcode::ChangeTool,
                 gcode::StartSpindle, gcode::Flood, gcode::EnableOverride, gcode::SelectPlane, gcode::UseLengthUnits,
                 gcode::UseToolLengthOffset, gcode::SetG5xOffset, gcode::SetG92Offset, gcode::SetXyRotation,
                 gcode::SetMotionControlMode, gcode::SetG92Offset, gcode::StraightFeed, gcode::ProgramStop>()));
  EXPECT_EQ(sink.lines, std::vector<std::uint32_t>(sink.calls.size(), 7));
  EXPECT_EQ(executor->after(), After::kStop);
}

TEST_F(GcodeExecutor, SaysWhatTheProgramDoesNext) {
  ASSERT_EQ(execute("M66 P1"), std::nullopt);
  EXPECT_EQ(executor->after(), After::kWaitInput);
  executor->give_input(1.0);
  EXPECT_EQ(executor->parameters().numbered(gcode::kInputParameter), 1.0);
  ASSERT_EQ(execute("G0 X1"), std::nullopt);
  EXPECT_EQ(executor->after(), After::kNext);
  ASSERT_EQ(execute("M30"), std::nullopt);
  EXPECT_EQ(executor->after(), After::kEnd);
}

TEST_F(GcodeExecutor, EndsAProgramWithItsModesAsAtTheStartButG1) {
  ASSERT_EQ(execute("G55 G18 F5 M3 S1 M8 M49 G91"), std::nullopt);
  sink.clear();
  executor->end_program(true);
  EXPECT_TRUE((sink.made<gcode::SetG5xOffset, gcode::SetXyRotation, gcode::SelectPlane, gcode::SetFeedMode,
                         gcode::SetFeedRate, gcode::EnableOverride, gcode::StopSpindle, gcode::SetSpindleMode,
                         gcode::Flood, gcode::PalletShuttle, gcode::ProgramEnd>()));
  EXPECT_EQ(executor->computed("_motion_mode"), 10.0);
  EXPECT_EQ(executor->computed("_coord_system"), 540.0);
  EXPECT_EQ(executor->computed("_incremental"), 0.0);
}

TEST_F(GcodeExecutor, AnswersTheParametersOfAllItsParts) {
  ASSERT_EQ(execute("T1 M6 S12 F3 M7 M50 P0 G59.2"), std::nullopt);
  ASSERT_EQ(execute("G0 X4", 9), std::nullopt);
  executor->begin_call();
  executor->set_returned(2.5);
  for (const auto& [name, value] :
       {gcode::NamedValue{"_current_tool", 1}, gcode::NamedValue{"_rpm", 12}, gcode::NamedValue{"_feed", 3},
        gcode::NamedValue{"_mist", 1}, gcode::NamedValue{"_feed_override", 0}, gcode::NamedValue{"_coord_system", 592},
        gcode::NamedValue{"_motion_mode", 0}, gcode::NamedValue{"_line", 9}, gcode::NamedValue{"_call_level", 1},
        gcode::NamedValue{"_value", 2.5}, gcode::NamedValue{"_x", 4}, gcode::NamedValue{"_ccomp", 400}}) {
    EXPECT_EQ(executor->computed(name), value) << name;
    EXPECT_EQ(executor->parameters().set(name, 0.0), ErrorCode::kParameterReadOnly) << name;
  }
  for (const char* other : {"", "_", "_abs_", "feed", "_nothing"}) EXPECT_EQ(executor->computed(other), std::nullopt);
  EXPECT_EQ(executor->computed(gcode::kToolParameter), 1.0);
}

TEST_F(GcodeExecutor, KeepsOffsetsAndToolsForTheNextProgram) {
  ASSERT_EQ(execute("G10 L2 P1 X5"), std::nullopt);
  ASSERT_EQ(execute("G10 L1 P1 Z7"), std::nullopt);
  const auto stored = std::make_unique<gcode::Executor::Stored>();
  executor->save(*stored);
  ASSERT_EQ(execute("G10 L2 P1 X6"), std::nullopt);
  executor->restore(*stored);
  executor->begin_program({});
  EXPECT_EQ(executor->computed("_x"), -5.0);
  ASSERT_NE(executor->tools().offset_of(1), nullptr);
  EXPECT_EQ((*executor->tools().offset_of(1))[2], 7.0);
}

}  // namespace
}  // namespace armature::test
