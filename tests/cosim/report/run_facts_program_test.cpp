// What the reports say of a program: its end, its lines and its messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/report/judge/expect.hpp"
#include "tests/cosim/support/run_facts_rows.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Kind = ProgramNoted::Kind;

constexpr Cycles kAt{500'000};  // 0.01 s

CommandNames names(const std::string& file) {
  Scenario scenario;
  scenario.program_files = {{.name = file, .text = {}}};
  return CommandNames{scenario};
}

struct RunFactsProgram : test::RunFactsRows {
  RunFactsProgram() { collector = RunFactsCollector{test::robot(), 1, std::nullopt, names("part.ngc")}; }

  void note(Kind kind, std::uint32_t line, std::string_view text = {}) {
    ProgramNoted event{.place = line, .kind = kind};
    event.set_text(text);
    report(event, kAt);
  }
  [[nodiscard]] std::string_view end() const { return collector.facts().program_end(); }
  // The only thing that is wrong.
  [[nodiscard]] std::string failure(const ExpectSpec& expect = {}) const {
    const std::vector<ExpectFailure> failures = check(expect, collector.facts());
    EXPECT_EQ(failures.size(), 1U);
    return failures.empty() ? std::string{} : failures.front().text();
  }
  [[nodiscard]] RunSummary summary() const {
    RunSummary all;
    all.facts = collector.facts();
    return all;
  }
};

TEST_F(RunFactsProgram, TheLastThingThatItReportsIsItsEnd) {
  EXPECT_EQ(end(), "waiting");
  note(Kind::kLine, 1);
  EXPECT_EQ(end(), "running");
  note(Kind::kMessage, 2, "hello");
  EXPECT_EQ(end(), "running");
  note(Kind::kPaused, 2);
  EXPECT_EQ(end(), "paused");
  note(Kind::kLine, 3);
  EXPECT_EQ(end(), "running");
  note(Kind::kEnded, 3);
  EXPECT_EQ(end(), "ended");
  EXPECT_THAT(collector.facts().program_messages(), ElementsAre("hello"));
  EXPECT_EQ(RunFacts{}.program_end(), "");
}

TEST_F(RunFactsProgram, ARunWithoutAProgramNeedNotHaveEndedOne) {
  EXPECT_THAT(check({}, RunFacts{}), IsEmpty());
}

TEST_F(RunFactsProgram, AProgramThatHasNotEndedFailsTheRunUnlessThatIsExpected) {
  EXPECT_EQ(failure(), "expect.program_end: expected ended, as it is not stated, got waiting");
  note(Kind::kLine, 4);
  EXPECT_EQ(failure(), "expect.program_end: expected ended, as it is not stated, got running (line 4 of part.ngc)");
  report(MoveStarted{.tag = Tag{Source::kProgram, 2}});
  report(MoveFinished{.tag = Tag{Source::kProgram, 2}});
  EXPECT_EQ(failure(), "expect.program_end: expected ended, as it is not stated, got running (line 2 of part.ngc)");
  note(Kind::kAlarm, 4, "the path leaves the reach of the arm");
  EXPECT_EQ(failure(),
            "expect.program_end: expected ended, as it is not stated, got alarm: the path leaves the reach of the "
            "arm (line 4 of part.ngc; 0.010000 s)");
  ExpectSpec expect;
  expect.program_end = "alarm";
  expect.program_end_line = 4;
  EXPECT_THAT(check(expect, collector.facts()), IsEmpty());
  expect.program_end_line = 5;
  EXPECT_THAT(failure(expect), HasSubstr("expected 5, got 4 (line 4 of"));
}

TEST_F(RunFactsProgram, TheMessagesAreCompared) {
  note(Kind::kMessage, 1, "a");
  note(Kind::kEnded, 1);
  ExpectSpec expect;
  expect.program_messages = {"a"};
  EXPECT_THAT(check(expect, collector.facts()), IsEmpty());
  expect.program_messages = {"b"};
  EXPECT_THAT(failure(expect), HasSubstr("expect.program_messages"));
}

TEST_F(RunFactsProgram, ALineIsNotTheMoveOfTheScenarioWithItsNumber) {
  CommandSpec move;
  move.kind = LineSpec{.path = {.blend_mm = 1}};
  move.index = 3;
  collector.add(move);
  report(MoveStarted{.tag = Tag{Source::kProgram, 3}});
  report(MoveFinished{.tag = Tag{Source::kProgram, 3}});
  EXPECT_EQ(collector.facts().moves_waiting, 1);
  EXPECT_FALSE(collector.facts().blended_with_next(0));
  report(MoveStarted{.tag = 3});
  EXPECT_EQ(collector.facts().moves_waiting, 0);
}

TEST_F(RunFactsProgram, ReportsNameTheLineOfACommand) {
  report(MoveStarted{.tag = Tag{Source::kProgram, 12}, .stretch = 2, .stretched_for = 4});
  report(MoveRefused{.reason = Refusal::kUnreachable, .tag = Tag{Source::kProgram, 13}}, kAt);
  note(Kind::kLine, 12, "MOVL");
  note(Kind::kMessage, 12, "a \"b\"");
  note(Kind::kStopped, 13);
  const std::string text = summary_text(summary());
  EXPECT_THAT(text, HasSubstr("2.000 for joint 4 in line 12 of part.ngc\n"));
  EXPECT_THAT(text, HasSubstr("line 13 of part.ngc unreachable (0.010000 s)\n"));
  EXPECT_THAT(text, HasSubstr("line 12 of part.ngc message: \"a \"b\"\" (0.010000 s)\n"));
  EXPECT_THAT(text, HasSubstr("line 13 of part.ngc stopped (0.010000 s)\n"));
  EXPECT_THAT(text, Not(HasSubstr("interpreted")));
  EXPECT_THAT(text, Not(HasSubstr("move[")));

  const auto result = nlohmann::json::parse(summary_json(summary()))["result"];
  EXPECT_EQ(result["moves"][0]["command"], "line 12 of part.ngc");
  EXPECT_EQ(result["moves"][0]["move"], nullptr);
  EXPECT_EQ(result["refused_moves"][0]["command"], "line 13 of part.ngc");
  EXPECT_EQ(result["program_end"], "stopped");
  EXPECT_EQ(result["program_end_line"], 13);
  ASSERT_EQ(result["program"].size(), 3U);
  EXPECT_EQ(result["program"][0].dump(), R"({"cycle":500000,"file":"part.ngc","kind":"line","line":12,"text":"MOVL"})");
  EXPECT_FALSE(nlohmann::json::parse(summary_json(RunSummary{}))["result"].contains("program"));
}

}  // namespace
}  // namespace armature::cosim
