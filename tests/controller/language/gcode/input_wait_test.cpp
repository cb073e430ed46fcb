#include "controller/language/gcode/run/input_wait.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/gcode_rig.hpp"

namespace armature::test {
namespace {

using gcode::WaitInput;

struct GcodeInputWait : testing::Test {
  void begin(WaitInput::Mode mode, double timeout_s = 0.001) {
    wait.begin({.index = 2, .mode = mode, .timeout_s = timeout_s}, 5, port.time);
  }
  // A step with a level of input 2, which is pin 3.
  std::optional<double> step(bool level) {
    port.inputs[3] = level;
    port.time += Ticks{1};
    return wait.step(port);
  }
  Cell cell;
  KeepingPort port{cell};
  gcode::InputWait wait;
};

TEST_F(GcodeInputWait, ReadsTheInputAtOnce) {
  begin(WaitInput::Mode::kImmediate, 0.0);
  EXPECT_EQ(step(true), 1.0);
  begin(WaitInput::Mode::kImmediate, 0.0);
  EXPECT_EQ(step(false), 0.0);
  EXPECT_FALSE(wait.active());
  EXPECT_TRUE(port.notes_of(ProgramNote::Kind::kWaits).empty());
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kWaited).size(), 2U);
}

TEST_F(GcodeInputWait, WaitsForAnEdgeAfterItsStart) {
  begin(WaitInput::Mode::kRise);
  EXPECT_EQ(step(true), std::nullopt) << "it was high before";
  EXPECT_EQ(step(false), std::nullopt);
  EXPECT_TRUE(wait.active());
  EXPECT_EQ(step(true), 1.0);
  begin(WaitInput::Mode::kFall);
  EXPECT_EQ(step(false), std::nullopt);
  EXPECT_EQ(step(true), std::nullopt);
  EXPECT_EQ(step(false), 0.0);
}

TEST_F(GcodeInputWait, WaitsForALevel) {
  begin(WaitInput::Mode::kHigh);
  EXPECT_EQ(step(false), std::nullopt);
  EXPECT_EQ(step(true), 1.0);
  begin(WaitInput::Mode::kLow);
  EXPECT_EQ(step(false), 0.0);
}

// 1 ms is 20 ticks.
TEST_F(GcodeInputWait, EndsWithTheTimeOut) {
  begin(WaitInput::Mode::kHigh);
  for (int tick = 1; tick < 20; ++tick) ASSERT_EQ(step(false), std::nullopt) << tick;
  EXPECT_EQ(step(false), -1.0);
  const auto waits = port.notes_of(ProgramNote::Kind::kWaits);
  ASSERT_EQ(waits.size(), 1U);
  EXPECT_EQ(waits[0].place, 5U);
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kWaited).back().text.view(), kWaitTimeOver);
}

}  // namespace
}  // namespace armature::test
