#include "controller/language/gcode/flow/o_word_values.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;

struct GcodeOWordValues : testing::Test {
  // Of the first line of a program, which has a subroutine 7.
  std::optional<ErrorCode> read(std::string_view line) {
    values = {};
    const std::string text = std::string{line} + "\nM2\no7 sub\no7 endsub\n";
    EXPECT_FALSE(index->build({.text = text}, source));
    EXPECT_FALSE(source.read(line));
    const NoComputedParameters computed;
    const gcode::Parameters parameters{computed};
    gcode::ValueReader reader{source, parameters};
    return code_of(read_values(*index->at_line(0), *index, reader, values));
  }
  [[nodiscard]] std::string_view name() const { return index->name(values.name); }

  std::unique_ptr<gcode::FlowIndex> index = std::make_unique<gcode::FlowIndex>();
  gcode::SourceLine source;
  gcode::OWordValues values;
};

TEST_F(GcodeOWordValues, AreTheArgumentsOfACall) {
  ASSERT_EQ(read("o7 call [1+1] [3]"), std::nullopt);
  EXPECT_EQ(values.count, 2U);
  EXPECT_EQ(values.list[0], 2.0);
  EXPECT_EQ(values.list[1], 3.0);
  EXPECT_EQ(name(), "7");
  std::string many = "o7 call";
  for (int i = 0; i < 30; ++i) many += " [1]";
  EXPECT_EQ(read(many), std::nullopt);
  EXPECT_EQ(read(many + " [1]"), ErrorCode::kTooManyArguments);
  EXPECT_EQ(read("o7 call G0"), ErrorCode::kLineAfterOWord);
}

TEST_F(GcodeOWordValues, HaveANameThatMayBeComputed) {
  ASSERT_EQ(read("o[3+4] call [1]"), std::nullopt);
  EXPECT_EQ(name(), "7");
  ASSERT_EQ(read("o[3+5] call"), std::nullopt);
  EXPECT_EQ(values.name, gcode::FlowIndex::kComputed);
  EXPECT_EQ(read("o[3.5] call"), ErrorCode::kNotAnInteger);
}

TEST_F(GcodeOWordValues, AreTheWordsOfM98) {
  ASSERT_EQ(read("M98 L3 P0007"), std::nullopt);
  EXPECT_EQ(name(), "7");
  EXPECT_EQ(values.turns, 3);
  ASSERT_EQ(read("M98 P[3+4]"), std::nullopt);
  EXPECT_EQ(values.turns, 1);
  EXPECT_EQ(read("M98 L3"), ErrorCode::kWordMissing);
  EXPECT_EQ(read("M98 P7 P7"), ErrorCode::kWordTwice);
  EXPECT_EQ(read("M98 P7 X1"), ErrorCode::kCodeNotFirst);
  EXPECT_EQ(read("M98 P7 L-1"), ErrorCode::kWordNegative);
}

}  // namespace
}  // namespace armature::test
