#include "cosim/golden/golden_comparer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::read_file;
using test::TempFolder;
using testing::HasSubstr;

constexpr std::int64_t kGoldenTicks = 1000;  // golden.csv ends at tick 800

// In which tick one pulse more is on a pin than in the golden.
TraceRow row_at(std::int64_t tick, std::int64_t odd_tick) {
  TraceRow row;
  row.tick = tick;
  row.cycle = 3108 + tick * 2500;
  row.pin_pulses[2] = tick * 9 + (tick == odd_tick ? 1 : 0);
  return row;
}

struct GoldenComparerTest : testing::Test {
  GoldenComparerTest() {
    folder.write("s/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n");
  }

  [[nodiscard]] Scenario load() const {
    LoadOptions options;
    options.search_path = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios";
    return load_scenario(folder.path() / "s", options);
  }

  void bless(std::int64_t every_ticks = kGoldenEveryTicks) const {
    const auto file = folder.path() / "blessed.csv";
    CsvWriter writer{file, every_ticks};
    IntegerDigest digest;
    for (std::int64_t tick = 0; tick < kGoldenTicks; ++tick) {
      digest.add(row_at(tick, -1));
      writer.write(row_at(tick, -1), digest);
    }
    writer.close();
    (void)bless_golden(load(), file, digest.hex());
  }

  [[nodiscard]] GoldenCheck run(std::int64_t odd_tick, std::int64_t every_ticks = 20) const {
    IntegerDigest digest;
    GoldenComparer comparer{load(), ToolColumns::kNo, {"out/s/trace.csv", every_ticks}};
    for (std::int64_t tick = 0; tick < kGoldenTicks; ++tick) {
      digest.add(row_at(tick, odd_tick));
      comparer.add(row_at(tick, odd_tick), digest);
    }
    return comparer.finish(digest.hex());
  }

  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = read_file(folder.path() / name);
    ASSERT_NE(text.find(from), std::string::npos);
    folder.write(name, text.replace(text.find(from), from.size(), to));
  }

  static void expect_begins(const GoldenCheck& check, std::int64_t from, std::int64_t to) {
    ASSERT_TRUE(check.begins);
    EXPECT_DOUBLE_EQ(check.begins->from_s, to_seconds(Cycles{row_at(from, -1).cycle}));
    EXPECT_DOUBLE_EQ(check.begins->to_s, to_seconds(Cycles{row_at(to, -1).cycle}));
  }

  TempFolder folder;
};

TEST_F(GoldenComparerTest, AScenarioWithoutOneIsNotJudged) {
  const GoldenCheck check = run(-1);
  EXPECT_EQ(check.verdict, GoldenVerdict::kNone);
  EXPECT_EQ(check.word(), "none");
  EXPECT_THAT(check.text, HasSubstr("'armature bless " + (folder.path() / "s").string()));
}

TEST_F(GoldenComparerTest, TheSameRunEqualsItWhateverTheRateOfItsTrace) {
  bless();
  for (const std::int64_t every : {1, 7, 20, 200, 1000}) {
    const GoldenCheck check = run(-1, every);
    EXPECT_EQ(check.verdict, GoldenVerdict::kEqual);
    EXPECT_EQ(check.text, "5 rows, and the digest of all 1000 ticks");
    EXPECT_EQ(check.details, "");
    EXPECT_FALSE(check.begins);
  }
}

// An earlier version wrote every 20th tick.
TEST_F(GoldenComparerTest, AGoldenWithMoreRowsIsComparedInAllOfThem) {
  bless(20);
  EXPECT_EQ(run(-1).text, "50 rows, and the digest of all 1000 ticks");
  const GoldenCheck check = run(327);
  EXPECT_THAT(check.details, HasSubstr("the runs first differ between tick 320 "));
  expect_begins(check, 320, 340);
}

TEST_F(GoldenComparerTest, ARowThatDiffersIsNamedWithBothFiles) {
  bless();
  const std::string golden = (folder.path() / "s/golden.csv").string();
  const GoldenCheck check = run(400, kGoldenEveryTicks);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_EQ(check.text, golden + ": 1 of 5 common rows differ");
  EXPECT_THAT(check.details,
              HasSubstr("  first mismatch at tick 400 (0.020062 s), j3_pin_pulses: golden 3600 (golden.csv line "
                        "4), this run 3601 (trace.csv line 4)\n"));
  expect_begins(check, 200, 400);
}

TEST_F(GoldenComparerTest, TheLineIsThatOfTheTraceThatTheRunWrites) {
  bless();
  EXPECT_THAT(run(400, 1).details, HasSubstr("golden 3600 (golden.csv line 4), this run 3601 (trace.csv line 402)\n"));
  EXPECT_THAT(run(400, 7).details, HasSubstr("golden 3600 (golden.csv line 4), this run 3601\n"));
}

TEST_F(GoldenComparerTest, ATickBetweenTheRowsIsFoundByTheDigest) {
  bless();
  const GoldenCheck check = run(407);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(check.details,
              HasSubstr("the runs first differ between tick 400 (0.020062 s; golden.csv line 4, trace.csv "
                        "line 22) and tick 600 (0.030062 s; golden.csv line 5, trace.csv line 32)\n"));
  EXPECT_THAT(check.details,
              HasSubstr("armature run " + (folder.path() / "s").string() + " --set trace.every_ticks=1"));
  expect_begins(check, 400, 600);
}

TEST_F(GoldenComparerTest, ATickAfterTheLastRowIsFoundByTheDigestOfTheRun) {
  bless();
  const GoldenCheck check = run(907);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(check.text, HasSubstr("the run differs after the last row of "));
  EXPECT_THAT(check.text, HasSubstr(", tick 800,"));
  EXPECT_THAT(check.details, HasSubstr("sed -n '1p;803,1001p'"));
  expect_begins(check, 800, 999);
}

TEST_F(GoldenComparerTest, OneWithADigestOfAnEarlierVersionSaysHowToRenewIt) {
  bless();
  edit("s/golden.csv", ",digest2\n", ",digest\n");
  const GoldenCheck check = run(-1);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(check.text, HasSubstr("golden.csv: its 5 rows are equal, but its digest is that of an earlier version"));
  EXPECT_EQ(check.details, "  'armature bless " + (folder.path() / "s").string() + "' renews it\n");
  EXPECT_FALSE(check.begins);
  EXPECT_THAT(run(400).text, HasSubstr("1 of 5 common rows differ, 1 columns missing, 1 columns extra"));
}

TEST_F(GoldenComparerTest, OneWithTriggersAtOtherCyclesDiffersAndSaysSo) {
  bless();
  edit("s/golden.csv", "0,0.00006216", "0,0.00006218");
  std::string text = read_file(folder.path() / "s/golden.csv");
  const std::size_t end = text.find('\n', text.find("\n0,") + 1);
  folder.write("s/golden.csv", text.replace(end - 4, 4, "0000"));
  std::string scenario = read_file(folder.path() / "s/scenario.toml");
  char& digit = scenario[scenario.find("sha256 = \"") + 10];
  digit = digit == '0' ? '1' : '0';
  folder.write("s/scenario.toml", scenario);
  const GoldenCheck check = run(-1);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(check.text, HasSubstr("golden.csv: its 5 rows are equal, but the triggers come at other clock cycles"));
}

TEST_F(GoldenComparerTest, HalfAGoldenDiffers) {
  bless();
  const std::string text = read_file(folder.path() / "s/scenario.toml");
  folder.write("s/scenario.toml", text.substr(0, text.find("\n\n") + 1));
  EXPECT_EQ(run(-1).verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(run(-1).text, HasSubstr("golden.csv exists but golden.sha256 is not set"));
  folder.write("s/scenario.toml", text);
  std::filesystem::remove(folder.path() / "s/golden.csv");
  EXPECT_EQ(run(-1).verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(run(-1).text, HasSubstr("golden.csv is missing"));
}

TEST_F(GoldenComparerTest, OneThatCannotBeReadDiffersAndTheRunGoesOn) {
  bless();
  edit("s/golden.csv", "\n400,", "\n4x,");
  GoldenCheck check = run(-1);
  EXPECT_EQ(check.verdict, GoldenVerdict::kDiffers);
  EXPECT_THAT(check.text, HasSubstr("it cannot be compared: "));
  EXPECT_THAT(check.text, HasSubstr("golden.csv:4:1: tick: expected an integer, found \"4x\""));
  edit("s/golden.csv", "tick,", "tock,");
  EXPECT_THAT(run(-1).text, HasSubstr("golden.csv:1:1: expected the column \"tick\""));
}

}  // namespace
}  // namespace armature::cosim
