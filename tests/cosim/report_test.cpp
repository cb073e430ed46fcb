#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "controller/kinematics/ik_result.hpp"
#include "cosim/report/format/junit.hpp"
#include "cosim/report/format/progress_bar.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/report/format/summary_json.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

RunSummary sample() {
  RunSummary summary;
  summary.scenario = "late_core";
  summary.description = "d";
  summary.robot = "vo2021_6r";
  summary.cycles = Cycles{25'000'000};
  summary.bus_reads = 1000;
  summary.bus_writes = 700;
  summary.worst_tick = Cycles{625};
  summary.sha256 = std::string(64, 'a');
  summary.host.wall_s = 2.0;
  RunFacts& facts = summary.facts;
  facts.ticks = 10'000;
  facts.worst_following_error_deg = {0.5, 0, 0, 0, 0, 0.9553};
  facts.faults.push_back({FaultCause::kFollowingError, 3, Cycles{15'000'000}, 5'999});
  facts.refusals.push_back({{.reason = Refusal::kOutsideLimits, .axis = 2}, Cycles{500'000}});
  facts.end_fault = FaultCause::kFollowingError;
  facts.moves.resize(3);
  facts.taken_ticks = {17, std::nullopt, 18};
  facts.moves_finished = 2;
  return summary;
}

TEST(SummaryText, FitsOnAScreenAndShowsWhatMatters) {
  RunSummary summary = sample();
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, StartsWith("PASSED late_core: d\n"));
  EXPECT_THAT(text, HasSubstr("0.500000 s, 10000 ticks, 25000000 cycles\n"));
  EXPECT_THAT(text, HasSubstr("2.00 s, 12.50 Mcycles/s, real-time factor 0.250\n"));
  EXPECT_THAT(text, HasSubstr("1000 reads, 700 writes\n"));
  EXPECT_THAT(text, HasSubstr("625 of 2500 cycles (25.0 %)\n"));
  EXPECT_THAT(text, HasSubstr("3 started, 2 finished, 1 refused or dropped\n"));
  EXPECT_THAT(text, HasSubstr("0.9553\n"));
  EXPECT_THAT(text, HasSubstr("following_error of axis 3 at 0.300000 s (tick 5999, cycle 15000000)\n"));
  EXPECT_THAT(text, HasSubstr("outside_limits, axis 2 (0.010000 s)\n"));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24);

  summary.expect_failures.push_back({"underruns", "0", "5"});
  EXPECT_THAT(summary_text(summary), StartsWith("FAILED"));
  EXPECT_THAT(summary_text(summary), EndsWith("expect.underruns: expected 0, got 5\n"));
}

TEST(SummaryText, ShowsTheToolWhereThereIsSomethingToShow) {
  RunSummary summary = sample();
  EXPECT_THAT(summary_text(summary), Not(AnyOf(HasSubstr("tcp"), HasSubstr("path error"), HasSubstr("stretch"))));
  summary.facts.final_tcp_mm = Eigen::Vector3d{100.25, -20, 300};
  summary.facts.path_error = PathDeviation{.mm = 0.0412, .tick = 100, .at = Cycles{250'000}, .move = 1};
  summary.facts.command_path_error = PathDeviation{.mm = 1e-9, .tick = 5, .at = Cycles{12'500}, .move = 0};
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
  RunSummary summary = sample();
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
  RunSummary summary = sample();
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

TEST(SummaryText, TellsDroppedMovesFromRefusedOnes) {
  RunSummary summary = sample();
  summary.facts.refusals.push_back({{.reason = Refusal::kNotReady}, Cycles{0}});
  EXPECT_THAT(summary_text(summary), HasSubstr("  refused               move[0] outside_limits, axis 2"));
  EXPECT_THAT(summary_text(summary), HasSubstr("  not carried out       move[0] not_ready"));
}

TEST(SummaryText, SaysNotBlendedOnlyOfAMoveThatStoppedAtItsEnd) {
  RunSummary summary = sample();  // the second of its three moves was cut short
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

TEST(RefusalText, GivesTheNumbersOfEveryReason) {
  using Kind = PathProblem::Kind;
  const auto text = [](Refusal reason, const PathProblem& path) {
    return refusal_text({.reason = reason, .axis = 0, .path = path});
  };
  EXPECT_EQ(refusal_text({.reason = Refusal::kQueueFull}), "queue_full");
  EXPECT_EQ(refusal_text({.reason = Refusal::kOutsideLimits, .axis = 2}), "outside_limits, axis 2");
  EXPECT_EQ(text(Refusal::kUnreachable, {.kind = Kind::kUnreachable, .at = 0.87, .margin_mm = 12.34}),
            "unreachable by up to 12.3 mm from 87 % of the path on");
  EXPECT_EQ(text(Refusal::kOutsideLimits, {.kind = Kind::kOutsideLimits, .segment = 2, .at = 0.5, .axis = 4}),
            "outside_limits, axis 4 at 50 % of the path of move 3 of its chain");
  EXPECT_EQ(text(Refusal::kOrientation, {.kind = Kind::kOrientation, .at = 1, .residual_rad = 0.0349065850398866}),
            "orientation off by 2 deg at the end of the path");
  EXPECT_EQ(
      text(Refusal::kSingular,
           {.kind = Kind::kTooFast, .at = 0.51, .axis = 4, .singular = kWristSingular | kElbowSingular, .stretch = 45}),
      "singular: joint 4 would need 45 times the time at 51 % of the path: wrist and elbow singularity");
  EXPECT_EQ(text(Refusal::kTooFast, {.kind = Kind::kTooFast, .at = 0, .axis = 1, .stretch = 21.5}),
            "too_fast: joint 1 would need 21.5 times the time at 0 % of the path");
  EXPECT_EQ(text(Refusal::kNoCircle, {.kind = Kind::kNoCircle}),
            "no_circle: the three points lie on a line or coincide");
  EXPECT_EQ(text(Refusal::kInvalidTarget, {.kind = Kind::kTooLong}),
            "invalid_target: the path would take more than 600 s; make it faster or divide it");
}

TEST(SummaryText, SaysThatTheControllerMissedAStop) {
  RunSummary summary = sample();
  summary.facts.faults.clear();
  summary.facts.end_fault = FaultCause::kNone;
  EXPECT_THAT(summary_text(summary), HasSubstr("faults                none\n"));
  summary.facts.controller_silent = true;
  const std::string text = summary_text(summary);
  EXPECT_THAT(text, HasSubstr("fault:controller_silent\n"));
  EXPECT_THAT(text, HasSubstr("the logic dropped the servo enables and the controller has not noticed\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("none\n")));
}

TEST(RunSummary, PassesOnlyWhenNothingWentWrong) {
  EXPECT_TRUE(sample().passed());
  RunSummary summary = sample();
  summary.failure = "conservation: axis 3";
  EXPECT_FALSE(summary.passed());
  EXPECT_THAT(summary_text(summary), HasSubstr("conservation: axis 3"));
  summary = sample();
  summary.interrupted = true;
  EXPECT_FALSE(summary.passed());
  EXPECT_THAT(summary_text(summary), StartsWith("INTERRUPTED"));
  summary = sample();
  summary.golden.verdict = GoldenVerdict::kDiffers;
  EXPECT_FALSE(summary.passed());
  for (const GoldenVerdict verdict : {GoldenVerdict::kNone, GoldenVerdict::kEqual, GoldenVerdict::kNotCompared}) {
    summary.golden.verdict = verdict;
    EXPECT_TRUE(summary.passed());
  }
}

TEST(SummaryText, SaysHowTheRunStandsToItsGolden) {
  RunSummary summary = sample();
  EXPECT_THAT(summary_text(summary), Not(HasSubstr("golden")));
  summary.golden = {GoldenVerdict::kDiffers, "golden.csv: 1 of 5 rows", "  first mismatch\n", {}};
  EXPECT_THAT(summary_text(summary),
              HasSubstr("  golden                differs: golden.csv: 1 of 5 rows\n  first mismatch\n"));
  summary.golden = {GoldenVerdict::kNotCompared, "the run has --set seed=2", {}, {}};
  EXPECT_THAT(summary_text(summary), HasSubstr("  golden                not compared: the run has --set seed=2\n"));
  const auto result = nlohmann::json::parse(summary_json(summary))["result"];
  EXPECT_EQ(result["golden"], "not compared");
  EXPECT_EQ(result["golden_text"], "the run has --set seed=2");
}

TEST(SummaryJson, KeepsWhatDependsOnTheMachineApart) {
  RunSummary summary = sample();
  auto one = nlohmann::json::parse(summary_json(summary));
  summary.host.wall_s = 99;
  auto other = nlohmann::json::parse(summary_json(summary));
  EXPECT_NE(one, other);
  one.erase("host");
  other.erase("host");
  EXPECT_EQ(one, other);
  const auto& result = one["result"];
  EXPECT_EQ(result["passed"], true);
  EXPECT_EQ(result["outcome"], "fault:following_error");
  EXPECT_EQ(result["cycles"], 25'000'000);
  EXPECT_EQ(result["moves_finished"], 2);
  EXPECT_EQ(result["worst_tick_cycles"], 625);
  EXPECT_EQ(result["failure"], nullptr);
  EXPECT_EQ(result["settle_s"], nullptr);
  EXPECT_EQ(result["faults"][0]["cause"], "following_error");
  EXPECT_EQ(result["faults"][0]["axis"], 3);
  EXPECT_EQ(result["refused_moves"][0]["reason"], "outside_limits");
  EXPECT_EQ(result["worst_following_error_deg"][5], 0.9553);
  EXPECT_EQ(result["moves"][0]["taken_ticks"], 17);
  EXPECT_EQ(result["moves"][1]["taken_ticks"], nullptr);
}

TEST(SummaryJson, TellsWhatTheRunWasMadeFrom) {
  RunSummary summary = sample();
  summary.tool_version = "1.2.3";
  summary.seed = 42;
  summary.overrides = {"seed=42", "trace.every_ticks=1"};
  summary.sources = {{"s/scenario.toml", "aa"}, {"r/arm.toml", "bb"}};
  const auto json = nlohmann::json::parse(summary_json(summary));
  EXPECT_EQ(json["tool_version"], "1.2.3");
  EXPECT_EQ(json["seed"], 42);
  EXPECT_EQ(json["overrides"], (std::vector<std::string>{"seed=42", "trace.every_ticks=1"}));
  EXPECT_EQ(json["variant"], "counts");
  EXPECT_EQ(json["engine"], "rtl");
  EXPECT_EQ(json["inputs"].size(), 2u);
  EXPECT_EQ(json["inputs"][1]["file"], "r/arm.toml");
  EXPECT_EQ(json["inputs"][1]["sha256"], "bb");
}

TEST(SummaryJson, HoldsEachMissedExpectationWithItsPlace) {
  RunSummary summary = sample();
  summary.expect_failures = {{.key = "max_correction_pulses",
                              .expected = "at most 3",
                              .got = "4",
                              .where = {"axis 2", {2}, FactPlace{.tick = 180, .at = Cycles{450'000}, .axis = 2}},
                              .file = "s/scenario.toml",
                              .origin = {17, 1, {}}},
                             {.key = "underruns", .expected = "0", .got = "5"}};
  const auto failures = nlohmann::json::parse(summary_json(summary))["result"]["expect_failures"];
  EXPECT_EQ(failures[0]["place"], "s/scenario.toml:17:1");
  EXPECT_EQ(failures[0]["axes"], std::vector<int>{2});
  EXPECT_EQ(failures[0]["tick"], 180);
  EXPECT_EQ(failures[0]["time_s"], 0.009);
  EXPECT_EQ(failures[0]["text"], summary.expect_failures[0].text());
  EXPECT_EQ(failures[1]["tick"], nullptr);
}

TEST(SummaryJson, HoldsPathsAndWhyTheyWereRefused) {
  RunSummary summary = sample();
  MoveStarted& arc = summary.facts.moves[1];
  arc.kind = MoveKind::kArc;
  arc.stretch = 3.5;
  arc.stretched_for = 6;
  arc.continues = true;
  arc.path.shape = PositionPath::Shape::kArc;
  arc.path.radius_mm = 20;
  arc.path.end_mm = {0, 0, 40};
  MoveStarted& circle = summary.facts.moves[2];
  circle = arc;
  circle.path.end_mm = circle.path.start_mm;
  summary.facts.moves[0].peak_speed_rad_s[1] = std::numbers::pi;
  summary.facts.moves[0].accel_rad_s2[5] = std::numbers::pi / 2;
  summary.facts.refusals = {
      {{.reason = Refusal::kSingular,
        .axis = 4,
        .path = {.kind = PathProblem::Kind::kTooFast, .at = 0.5, .axis = 4, .singular = kWristSingular, .stretch = 45}},
       Cycles{7}}};
  summary.facts.path_error = PathDeviation{.mm = 0.5, .tick = 3, .at = Cycles{9}, .move = 1};
  const auto result = nlohmann::json::parse(summary_json(summary))["result"];
  EXPECT_EQ(result["moves"][0]["kind"], "joint");
  EXPECT_FALSE(result["moves"][0].contains("path"));
  EXPECT_DOUBLE_EQ(result["moves"][0]["peak_speed_deg_s"][1], 180);
  EXPECT_DOUBLE_EQ(result["moves"][0]["accel_deg_s2"][5], 90);
  EXPECT_EQ(result["moves"][2]["kind"], "circle");
  EXPECT_EQ(result["moves"][1]["kind"], "arc");
  EXPECT_EQ(result["moves"][1]["stretch"], 3.5);
  EXPECT_EQ(result["moves"][1]["stretched_for_axis"], 6);
  EXPECT_EQ(result["moves"][1]["continues"], true);
  EXPECT_EQ(result["moves"][1]["path"]["radius_mm"], 20);
  EXPECT_FALSE(result["moves"][1].contains("profile"));
  EXPECT_EQ(result["refused_moves"][0]["reason"], "singular");
  EXPECT_EQ(result["refused_moves"][0]["path"]["singular"][0], "wrist");
  EXPECT_EQ(result["refused_moves"][0]["path"]["stretch"], 45);
  EXPECT_EQ(result["path_error"]["mm"], 0.5);
  EXPECT_EQ(result["command_path_error"], nullptr);
  EXPECT_EQ(result["final_tcp_mm"], nullptr);
}

TEST(TextFile, IsReplacedAsAWholeAndThroughALink) {
  const test::TempFolder folder;
  const auto file = folder.write("a/file.txt", "old and longer");
  replace_text_file(file, "new");
  EXPECT_EQ(test::read_file(file), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder.path() / "a"}, {}), 1);
  std::filesystem::create_symlink("a/file.txt", folder.path() / "link");
  replace_text_file(folder.path() / "link", "through");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_EQ(test::read_file(file), "through");
}

TEST(TextFile, AFullDiskIsAnErrorThatNamesTheFile) {
  const test::TempFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "full");
  try {
    replace_text_file(folder.path() / "full", "text");
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), EndsWith("/full: cannot write: No space left on device"));
  }
}

TEST(TextFile, BeingWritableIsKnownWithoutTouchingIt) {
  const test::TempFolder folder;
  const auto file = folder.write("file.txt", "kept");
  require_writable(file);
  EXPECT_EQ(test::read_file(file), "kept");
  require_writable(folder.path() / "fresh.txt");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "fresh.txt"));
  EXPECT_THROW(require_writable(folder.path()), InputError);
  EXPECT_THROW(require_writable(folder.path() / "missing/file.txt"), InputError);
  EXPECT_THROW(require_writable(file / "below_a_file.txt"), InputError);
}

TEST(Junit, CountsAndEscapes) {
  const std::string xml = junit_xml(
      {{.name = "good", .wall_s = 1.5, .failure = {}, .error = {}, .output = {}},
       {.name = "a<b>&\"c\"", .wall_s = 0.25, .failure = "first\nsecond \x01", .error = {}, .output = "out & in"},
       {.name = "bad", .wall_s = 0, .failure = {}, .error = "no file", .output = {}}});
  EXPECT_THAT(xml, HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\" time=\"1.750\""));
  EXPECT_THAT(xml, HasSubstr("name=\"good\" time=\"1.500\">\n  </testcase>"));
  EXPECT_THAT(xml, HasSubstr("name=\"a&lt;b&gt;&amp;&quot;c&quot;\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"first\">first&#10;second \\x01</failure>"));
  EXPECT_THAT(xml, HasSubstr("<system-out>out &amp; in</system-out>"));
  EXPECT_THAT(xml, HasSubstr("<error message=\"no file\">no file</error>"));
  EXPECT_THAT(xml, EndsWith("</testsuite>\n"));
}

TEST(ProgressBar, ShowsTimeFactorAndTimeLeft) {
  EXPECT_EQ(progress_line(0.5, 1.0, 2.0), "[###############---------------]  50 %  0.500 of 1.000 s  x0.250  2 s left");
  EXPECT_EQ(progress_line(0, 1, 0), "[------------------------------]   0 %  0.000 of 1.000 s");
  EXPECT_THAT(progress_line(1.0, 100.0, 60.0), EndsWith("x0.017  1 h 39 min left"));
  EXPECT_THAT(progress_line(1.0, 10.0, 10.0), EndsWith("x0.100  1 min 30 s left"));
  EXPECT_THAT(progress_line(2.0, 1.0, 1.0), StartsWith("[##############################] 100 %"));
}

TEST(ProgressBar, RedrawsAtMostTenTimesASecondAndCleansUp) {
  std::ostringstream out;
  ProgressBar::Clock::time_point now{};
  {
    ProgressBar bar{out, 1.0, true, [&] { return now; }};
    for (int ms = 0; ms < 1000; ++ms) {
      now = ProgressBar::Clock::time_point{std::chrono::milliseconds{ms}};
      bar.update(ms / 1000.0);
    }
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 9 + 1);
  EXPECT_THAT(text, EndsWith("\r\033[K"));
}

TEST(ProgressBar, IsSilentWhenNotEnabled) {
  std::ostringstream out;
  ProgressBar::Clock::time_point now{};
  {
    ProgressBar bar{out, 1.0, false, [&] { return now; }};
    now += std::chrono::seconds{5};
    bar.update(0.5);
  }
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace armature::cosim
