#include "controller/language/gcode/flow/flow.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::ErrorCode;

struct GcodeFlow : testing::Test {
  // The numbers of the lines that a program executes, without those of O-words. A line `#n` adds 1 to that parameter.
  std::string lines_of(std::string_view text) {
    const gcode::ProgramText program{.text = text};
    executor->begin_program({});
    problem = code_of(flow->begin(program, source));
    std::string lines;
    for (int i = 0; i < 200 && !problem && !program.file_ends(flow->next()); ++i) {
      const std::uint32_t number = flow->next_line();
      const gcode::LineSpan span = gcode::line_at(text, flow->next());
      const gcode::OWord* const word = flow->index().at_line(span.begin);
      EXPECT_FALSE(source.read(text.substr(span.begin, span.end - span.begin)));
      flow->pass(span);
      if (word != nullptr) {
        execute(*word);
      } else if (source.text() == "m2") {
        break;
      } else {
        lines += std::to_string(number) + ' ';
        if (source.text().starts_with('#')) executor->parameters().at(source.text()[1] - '0') += 1.0;
      }
    }
    return lines;
  }
  void execute(const gcode::OWord& word) {
    if (flow->skip(word)) return;
    gcode::ValueReader reader{source, executor->parameters()};
    gcode::OWordValues values;
    problem = code_of(read_values(word, flow->index(), reader, values));
    if (!problem) problem = code_of(flow->execute(word, values));
  }

  KeepingSink sink;
  std::unique_ptr<gcode::Executor> executor = std::make_unique<gcode::Executor>(sink);
  std::unique_ptr<gcode::Flow> flow = std::make_unique<gcode::Flow>(*executor);
  gcode::SourceLine source;
  std::optional<ErrorCode> problem;
};

TEST_F(GcodeFlow, ExecutesTheFirstBranchWhoseConditionHolds) {
  for (const auto& [value, lines] : {std::pair{"0", "7 9 "}, std::pair{"1", "2 9 "}}) {
    const std::string condition{value};
    EXPECT_EQ(lines_of("o1 if [" + condition + "]\nG0\no1 elseif [0]\nG0\no1 elseif [0]\no1 else\nG0\no1 endif\nG0\n"),
              lines);
  }
  EXPECT_EQ(lines_of("o1 if [0]\nG0\no1 elseif [1]\nG0\no1 else\nG0\no1 endif\n"), "4 ");
}

TEST_F(GcodeFlow, LeavesAndContinuesLoops) {
  EXPECT_EQ(lines_of("o1 while [#1 LT 2]\n#1\no1 endwhile\nG0\n"), "2 2 4 ");
  EXPECT_EQ(lines_of("o1 do\n#1\no1 while [#1 LT 2]\nG0\n"), "2 2 4 ");
  EXPECT_EQ(lines_of("o1 repeat [2]\n#1\no2 if [#1 EQ 1]\no1 continue\no2 endif\nG0\no1 endrepeat\n"), "2 2 6 ");
  EXPECT_EQ(lines_of("o1 repeat [9]\no2 repeat [9]\n#1\no1 break\no2 endrepeat\no1 endrepeat\nG0\n"), "3 7 ");
  EXPECT_EQ(lines_of("o1 repeat [0.4]\nG0\no1 endrepeat\n"), "");
}

TEST_F(GcodeFlow, ReturnsBehindTheCallWithItsOwnLoopsAndParameters) {
  EXPECT_EQ(lines_of("o1 sub\n#1\no2 repeat [5]\no1 return [#1]\no2 endrepeat\no1 endsub\n"
                     "o3 repeat [2]\no1 call [6]\nG0\no3 endrepeat\nM2\n"),
            "2 9 2 9 ");
  EXPECT_EQ(executor->computed("_value"), 7.0);
  EXPECT_EQ(executor->parameters().at(1), 0.0) << "of the caller";
}

TEST_F(GcodeFlow, CallsASubprogramSeveralTimesWithTheParametersOfTheCaller) {
  EXPECT_EQ(lines_of("M98 P20 L2\nG0\nM2\nO0020\n#1\nM99\n"), "5 5 2 ");
  EXPECT_EQ(executor->parameters().at(1), 2.0);
  EXPECT_EQ(lines_of("M98 P20 L0\nM2\nO20\n#1\nM99\n"), "");
}

TEST_F(GcodeFlow, RefusesACallOfWhatIsNotThere) {
  lines_of("o1 call\n");
  EXPECT_EQ(problem, ErrorCode::kSubroutineUnknown);
  lines_of("o[1+1] call\nM2\no1 sub\no1 endsub\n");
  EXPECT_EQ(problem, ErrorCode::kSubroutineUnknown);
  lines_of("M98 P1\nM2\no1 sub\no1 endsub\n");
  EXPECT_EQ(problem, ErrorCode::kSubroutineNotCalled);
  lines_of("o1 call\nM2\nO1\nM99\n");
  EXPECT_EQ(problem, ErrorCode::kProgramNotCalled);
  lines_of("o1 sub\no1 call\no1 endsub\no1 call\n");
  EXPECT_EQ(problem, ErrorCode::kCallTooDeep);
  lines_of("M98 P1\nM2\nO1\nM98 P1\nM99\n");
  EXPECT_EQ(problem, ErrorCode::kCallTooDeep);
}

}  // namespace
}  // namespace armature::test
