// The summary on the screen.
#include "cosim/report/format/summary_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cosim/report/format/json/summary_json.hpp"
#include "tests/cosim/support/sample_summary.hpp"

namespace armature::cosim {
namespace {

using test::sample_summary;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(SummaryText, FitsOnAScreenAndShowsWhatMatters) {
  RunSummary summary = sample_summary();
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, StartsWith("PASSED late_core: d\n"));
  EXPECT_THAT(text, HasSubstr("0.500000 s, 10000 ticks, 25000000 cycles\n"));
  EXPECT_THAT(text, HasSubstr("2.00 s, 12.50 Mcycles/s, real-time factor 0.250\n"));
  EXPECT_THAT(text, HasSubstr("1000 reads, 700 writes\n"));
  EXPECT_THAT(text, HasSubstr("625 of 2500 cycles (25.0 %)\n"));
  EXPECT_THAT(text, HasSubstr("3 started, 2 finished, 1 refused or dropped\n"));
  EXPECT_THAT(text, HasSubstr("0.9553\n"));
  EXPECT_THAT(text, HasSubstr("following_error of axis 3 at 0.300000 s (tick 5999, cycle 15000000)\n"));
  EXPECT_THAT(text, HasSubstr("outside_limits, axis 2: target 120 deg is beyond 110 deg (0.010000 s)\n"));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24);

  summary.expect_failures.push_back({"underruns", "0", "5"});
  EXPECT_THAT(summary_text(summary), StartsWith("FAILED"));
  EXPECT_THAT(summary_text(summary), EndsWith("expect.underruns: expected 0, got 5\n"));
}

TEST(SummaryText, ShowsTheToolWhereThereIsSomethingToShow) {
  RunSummary summary = sample_summary();
  EXPECT_THAT(summary_text(summary), Not(AnyOf(HasSubstr("tcp"), HasSubstr("path error"), HasSubstr("stretch"))));
  summary.facts.final_tcp_mm = Eigen::Vector3d{100.25, -20, 300};
  summary.facts.path_error = PathDeviation{.mm = 0.0412, .where = {.tick = 100, .at = Cycles{250'000}}, .move = 1};
  summary.facts.command_path_error = PathDeviation{.mm = 1e-9, .where = {.tick = 5, .at = Cycles{12'500}}, .move = 0};
  summary.facts.moves[1].stretch = 4.25;
  summary.facts.moves[1].stretched_for = 4;
  summary.facts.moves[1].tag = 1;
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, HasSubstr("final tcp mm (x y z)      100.2500    -20.0000    300.0000\n"));
  EXPECT_THAT(text, HasSubstr("worst path error      0.0412 mm at 0.005000 s in move[1]\n"));
  EXPECT_THAT(text, HasSubstr("of the set-points   1.0e-09 mm at 0.000250 s in move[0]\n"));
  EXPECT_THAT(text, HasSubstr("largest stretch       4.250 for joint 4 in move[1]\n"));
  summary.facts.moves[1].stretched_for = 0;
  EXPECT_THAT(summary_text(summary), HasSubstr("largest stretch       4.250 for the tool in move[1]\n"));
}

TEST(SummaryText, HasAColumnForEachAxisThatTheRobotHas) {
  RunSummary summary = sample_summary();
  summary.facts.axis_count = 5;
  EXPECT_THAT(summary_text(summary), HasSubstr("           5\n"));
  EXPECT_THAT(summary_text(summary), Not(HasSubstr("           6\n")));
  const auto result = nlohmann::json::parse(summary_json(summary))["result"];
  for (const char* key : {"final_joint_deg", "final_error_counts", "total_pulses", "peak_speed_deg_s",
                          "worst_following_error_deg", "overshoot_counts"}) {
    EXPECT_EQ(result[key].size(), 5u) << key;
  }
  EXPECT_EQ(result["moves"][0]["profile"].size(), 5u);
}

TEST(SummaryText, TellsWhatTheLogicOfThePaperCosts) {
  RunSummary summary = sample_summary();
  summary.facts.inexact_ticks = {4711, 0, 0, 0, 0, 0};
  summary.facts.lost_counts = {0, -815, 0, 0, 0, 0};
  summary.facts.max_residual_pulses = 10;
  for (const char* word : {"inexact", "lost", "residual", "variant"})
    EXPECT_THAT(summary_text(summary), Not(HasSubstr(word)));
  EXPECT_FALSE(nlohmann::json::parse(summary_json(summary))["result"].contains("paper"));
  summary.variant = Variant::kPaper;
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, HasSubstr("4711"));
  EXPECT_THAT(text, HasSubstr("-815"));
  EXPECT_THAT(text, HasSubstr("10 pulses\n"));
  const auto paper = nlohmann::json::parse(summary_json(summary))["result"]["paper"];
  EXPECT_EQ(paper["inexact_ticks"][0], 4711);
  EXPECT_EQ(paper["lost_counts"][1], -815);
  EXPECT_EQ(paper["max_residual_pulses"], 10);
}

TEST(SummaryText, HasALineForStreamsWhenTheArmLeftOne) {
  RunSummary summary = sample_summary();
  EXPECT_THAT(summary_text(summary), Not(HasSubstr("off the stream")));
  summary.facts.stream_deviation_deg[1] = 0.25;
  EXPECT_THAT(summary_text(summary), HasSubstr("off the stream deg    "));
  EXPECT_THAT(summary_text(summary), HasSubstr("0.250000"));
}

TEST(SummaryText, TellsDroppedMovesFromRefusedOnes) {
  RunSummary summary = sample_summary();
  summary.facts.refusals.push_back({{.reason = Refusal::kNotReady}, Cycles{0}});
  EXPECT_THAT(summary_text(summary), HasSubstr("  refused               move[0] outside_limits, axis 2"));
  EXPECT_THAT(summary_text(summary), HasSubstr("  not carried out       move[0] not_ready"));
}

TEST(SummaryText, SaysWhyEachJogEnded) {
  RunSummary summary = sample_summary();
  summary.facts.jogs = {{{.tag = 2}, JogEnded{.how = JogEnd::kLimit, .axis = 3, .taken = Ticks{20}}}, {{.tag = 7}}};
  EXPECT_THAT(summary_text(summary), HasSubstr("of move[2] ended by the soft limit of joint 3 after 20 ticks"));
  EXPECT_THAT(summary_text(summary), HasSubstr("of move[7] is under way at the end"));
}

TEST(SummaryText, SaysNotBlendedOnlyOfAMoveThatStoppedAtItsEnd) {
  RunSummary summary = sample_summary();  // the second of its three moves was cut short
  for (std::uint32_t i = 0; i < 3; ++i) {
    summary.facts.moves[i].tag = i;
    summary.facts.blends_asked_for.push_back(i);
  }
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, HasSubstr("  not blended           move[0] stopped at its end\n"));
  EXPECT_THAT(text, Not(HasSubstr("move[1] stopped")));
  EXPECT_THAT(text, HasSubstr("  not blended           move[2] stopped at its end\n"));
  const auto moves = nlohmann::json::parse(summary_json(summary))["result"]["moves"];
  EXPECT_EQ(moves[0]["blended"], false);
  EXPECT_EQ(moves[1]["blended"], nullptr);
}

TEST(SummaryText, SaysThatTheControllerMissedAStop) {
  RunSummary summary = sample_summary();
  summary.facts.faults.clear();
  summary.facts.end_fault = FaultCause::kNone;
  EXPECT_THAT(summary_text(summary), HasSubstr("faults                none\n"));
  summary.facts.controller_silent = true;
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, HasSubstr("fault:controller_silent\n"));
  EXPECT_THAT(text, HasSubstr("the servo enables dropped and the controller did not report it\n"));
  EXPECT_THAT(text, Not(HasSubstr("none\n")));
}

TEST(SummaryText, SaysHowTheRunStandsToItsGolden) {
  RunSummary summary = sample_summary();
  EXPECT_THAT(summary_text(summary), Not(HasSubstr("golden")));
  summary.golden = {GoldenVerdict::kDiffers, "golden.csv: 1 of 5 rows", "  first mismatch\n", {}};
  EXPECT_THAT(summary_text(summary),
              HasSubstr("  golden                differs: golden.csv: 1 of 5 rows\n  first mismatch\n"));
  summary.golden = {GoldenVerdict::kNotCompared, "the run has --set seed=2", {}};
  EXPECT_THAT(summary_text(summary), HasSubstr("  golden                not compared: the run has --set seed=2\n"));
  const auto result = nlohmann::json::parse(summary_json(summary))["result"];
  EXPECT_EQ(result["golden"], "not compared");
  EXPECT_EQ(result["golden_text"], "the run has --set seed=2");
}

TEST(RunSummary, PassesOnlyWhenNothingWentWrong) {
  EXPECT_TRUE(sample_summary().passed());
  RunSummary summary = sample_summary();
  summary.failure = "conservation: axis 3";
  EXPECT_FALSE(summary.passed());
  EXPECT_THAT(summary_text(summary), HasSubstr("conservation: axis 3"));
  summary = sample_summary();
  summary.interrupted = true;
  EXPECT_FALSE(summary.passed());
  EXPECT_THAT(summary_text(summary), StartsWith("INTERRUPTED"));
  summary = sample_summary();
  summary.golden.verdict = GoldenVerdict::kDiffers;
  EXPECT_FALSE(summary.passed());
  for (const GoldenVerdict verdict : {GoldenVerdict::kNone, GoldenVerdict::kEqual, GoldenVerdict::kNotCompared}) {
    summary.golden.verdict = verdict;
    EXPECT_TRUE(summary.passed());
  }
}

}  // namespace
}  // namespace armature::cosim
