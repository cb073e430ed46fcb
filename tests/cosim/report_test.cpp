#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cosim/report/junit.hpp"
#include "cosim/report/progress_bar.hpp"
#include "cosim/report/run_summary.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
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
  facts.faults.push_back({FaultCause::kFollowingError, 3, Cycles{15'000'000}});
  facts.refusals.push_back({{.reason = Refusal::kOutsideLimits, .axis = 2}, Cycles{500'000}});
  facts.end_fault = FaultCause::kFollowingError;
  facts.moves.resize(3);
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
  EXPECT_THAT(text, HasSubstr("3 started, 2 finished, 1 refused\n"));
  EXPECT_THAT(text, HasSubstr("0.9553\n"));
  EXPECT_THAT(text, HasSubstr("following_error of axis 3 at 0.300000 s\n"));
  EXPECT_THAT(text, HasSubstr("outside_limits, axis 2 at 0.010000 s\n"));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24);

  summary.expect_failures.push_back({"underruns", "0", "5"});
  EXPECT_THAT(summary_text(summary), StartsWith("FAILED"));
  EXPECT_THAT(summary_text(summary), EndsWith("expect.underruns: expected 0, got 5\n"));
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
    EXPECT_THAT(error.what(), EndsWith("/full: No space left on device"));
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
  EXPECT_THAT(xml, HasSubstr("<failure message=\"first\">first&#10;second ?</failure>"));
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
