#include "controller/language/gcode/execute/outputs.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;
using gcode::SetAnalogOutput;
using gcode::SetDigitalOutput;
using gcode::WaitInput;

struct GcodeOutputs : testing::Test, GcodeParts {
  std::optional<ErrorCode> execute(std::string_view text) { return code_of(set_outputs(block(text), calls)); }
};

TEST_F(GcodeOutputs, ChangeAtOnceOrWithTheNextMotion) {
  struct Case {
    const char* text;
    bool with_motion;
    bool on;
  };
  for (const auto& [text, with_motion, on] : {Case{"M62 P5", true, true}, Case{"M63 P5", true, false},
                                              Case{"M64 P5", false, true}, Case{"M65 P5", false, false}}) {
    ASSERT_EQ(execute(text), std::nullopt);
    EXPECT_EQ(sink.last<SetDigitalOutput>().with_motion, with_motion) << text;
    EXPECT_EQ(sink.last<SetDigitalOutput>().on, on) << text;
    EXPECT_EQ(sink.last<SetDigitalOutput>().index, 5) << text;
  }
  ASSERT_EQ(execute("M67 E1 Q-2.5"), std::nullopt);
  EXPECT_TRUE(sink.last<SetAnalogOutput>().with_motion);
  EXPECT_EQ(sink.last<SetAnalogOutput>().value, -2.5);
  EXPECT_EQ(execute("M68 E1"), ErrorCode::kWordMissing);
  EXPECT_EQ(execute("M64 P64"), ErrorCode::kWordRange);
}

TEST_F(GcodeOutputs, WaitForAnInputWithATimeOut) {
  EXPECT_TRUE(waits_for_input(block("M66 P3 L3 Q2")));
  ASSERT_EQ(execute("M66 P3 L3 Q2"), std::nullopt);
  EXPECT_EQ(sink.last<WaitInput>().index, 3);
  EXPECT_EQ(sink.last<WaitInput>().mode, WaitInput::Mode::kHigh);
  EXPECT_EQ(sink.last<WaitInput>().timeout_s, 2.0);
  EXPECT_EQ(execute("M66 P3 L3"), ErrorCode::kWaitTimeout);
  EXPECT_EQ(execute("M66 E3 L3 Q2"), ErrorCode::kWaitMode);
  EXPECT_EQ(execute("M66 P1 E1"), ErrorCode::kWordNotUsed);
}

}  // namespace
}  // namespace armature::test
